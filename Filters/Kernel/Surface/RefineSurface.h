// SPDX-License-Identifier: BSD-3-Clause
// Drive the edges of a multimaterial surface to their target lengths.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "../Mesh/TriangleComplex.h"

namespace lamina
{

struct RefineSurfaceOptions
{
  int iterations = 6;      ///< rounds of bisection, merging, swapping and relaxation, 1 or more
  double splitRatio = 1.4; ///< an edge longer than this times its target is bisected, > 1
  double mergeRatio = 0.7; ///< an edge shorter than this times its target is merged, in (0, 1)
  double tolerance =
    0; ///< largest distance to the input surface, a length; 0: a tenth of the local feature size
};

/// Bit of MeshingFlags on points: no direction into a material sees all its faces around the point.
constexpr unsigned char FlagHiddenNode = 16;

struct RefineSurfaceReport
{
  Id splits = 0;
  Id merges = 0;
  Id swaps = 0;
  Id triangles = 0;
  double edgesInRange = 0;        ///< share of edges within [0.5, 1.5] of their target
  double leastQuality = 0;        ///< least 2r/R of a triangle
  double largestVolumeChange = 0; ///< relative, over all materials, after the final correction
  Id hiddenNodes = 0;             ///< wall nodes without a direction that sees all faces of a material
  std::vector<Vec3> hiddenPlaces;
  std::vector<Id> hiddenPoints; ///< their ids in the refined surface, ascending
};

/// Needs surface.targetEdgeLength; the fields of the points (featureSize, thickness, ...) are carried to the
/// new points.
Result<RefineSurfaceReport> RefineSurface(TriangleComplex& surface, const RefineSurfaceOptions& options,
                                          Monitor& monitor);

} // namespace lamina
