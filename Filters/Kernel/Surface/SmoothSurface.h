// SPDX-License-Identifier: BSD-3-Clause
// Volume-conserving smoothing of a multimaterial surface by edge relaxation.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "../Mesh/TriangleComplex.h"

namespace lamina
{

struct SmoothSurfaceOptions
{
  int sweeps = 20;         ///< passes over all edges, 0 or more
  double relaxation = 1.0; ///< share of the Laplacian move, (0, 1]
  /// Waves of the sheets up to about this length, in mean edge lengths, are levelled between the sweeps; 0:
  /// none.
  double wavelength = 10;
  double largestDrift =
    0.75; ///< farthest a point may end from its start along the starting normal, in mean edge lengths
};

struct SmoothSurfaceReport
{
  int sweepsDone = 0;
  Id movesRefused = 0;     ///< relaxations skipped because they would have folded or approached another sheet
  Id pointsRolledBack = 0; ///< points put back because the exact test found an intersection
  double largestVolumeChange = 0; ///< relative, over all materials
  std::vector<int> materials;
  std::vector<double> volumesBefore; ///< one a material
  std::vector<double> volumesAfter;
};

Result<SmoothSurfaceReport> SmoothSurface(TriangleComplex& surface, const SmoothSurfaceOptions& options,
                                          Monitor& monitor);

} // namespace lamina
