// SPDX-License-Identifier: BSD-3-Clause
// Volume-conserving smoothing of a multimaterial surface by edge relaxation.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "../Mesh/TriangleComplex.h"
#include "Certificate.h"

namespace lamina
{

struct SmoothSurfaceOptions
{
  int sweeps = 20;         ///< most passes over all edges, 0 or more
  double relaxation = 1.0; ///< share of the Laplacian move, (0, 1]
  /// Waves of the sheets up to about this length, in mean edge lengths, are levelled between the sweeps; 0:
  /// none.
  double wavelength = 10;
  /// Farthest a point may end from its start along the starting normal, in mean edge lengths.
  double largestDrift = 0.75;
  double largestDisplacement = 1.5; ///< the same in any direction
  /// Sweeping ends when the points move less than this in a sweep, root mean square, in voxels; 0: never.
  double settled = 0.002;
  /// Smooth an open, non-manifold or intersecting surface too: points at such places stay.
  bool acceptFaults = false;
};

/// A connected piece of a material that is off its volume after smoothing.
struct MissedPiece
{
  int material = 0;
  double target = 0; ///< in the image, or of the surface as it came
  double volume = 0;
  Vec3 place; ///< a point of its surface
};

struct SmoothSurfaceReport
{
  int sweepsDone = 0;
  Id movesRefused = 0;     ///< relaxations skipped because they would have folded or approached another sheet
  Id pointsRolledBack = 0; ///< points put back because the exact test found an intersection
  double largestVolumeChange = 0;        ///< from what is held, relative, over all materials
  double largestPieceError = 0;          ///< the same over all pieces of 100 voxels or more
  Id pieces = 0;                         ///< of materials and of enclosed background
  std::vector<MissedPiece> missedPieces; ///< off their volume by more than 1e-9 of it, and of 100 voxels
  std::vector<int> materials;
  std::vector<double> volumesBefore; ///< one a material, of the surface
  std::vector<double> volumesHeld;   ///< with what the repair of the labels took
  std::vector<double> volumesAfter;
  Id faultyEdges = 0; ///< open or non-manifold, for each material (acceptFaults)
  Id faultyPairs = 0; ///< of triangles that intersected before (acceptFaults)
  SurfaceCertificate certificate;
};

/// Smooths `surface` and brings every connected piece to its volume: that of its voxels where the surface
/// knows it (TriangleComplex::missing, which is empty afterwards), else the one it came with.
Result<SmoothSurfaceReport> SmoothSurface(TriangleComplex& surface, const SmoothSurfaceOptions& options,
                                          Monitor& monitor);

} // namespace lamina
