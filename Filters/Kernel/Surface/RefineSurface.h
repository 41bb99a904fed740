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
  /// How many times longer than their target edges may be along the least curvature, 1 to 4; above 1 the
  /// surface needs its curvatures. Lengths and qualities are then those of that metric.
  double tangentialAnisotropy = 1;
  int iterations = 6;      ///< rounds of bisection, merging, swapping and relaxation, 1 or more
  double splitRatio = 1.4; ///< an edge longer than this times its target is bisected, > 1
  double mergeRatio = 0.7; ///< an edge shorter than this times its target is merged, in (0, 1)
  /// Largest distance to the input surface and of it to the refined one, a length; 0: the smaller of a tenth
  /// of the local feature size (a fifth of the target where there is none) and half a mean edge.
  double tolerance = 0;
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
  double goodTriangles = 0;       ///< share of triangles with 2r/R of 0.4 or more
  double largestVolumeChange = 0; ///< relative, over all materials, after the final correction
  Id hiddenNodes = 0;             ///< wall nodes without a direction that sees all faces of a material
  Id forbiddenNodes = 0;          ///< those of them where the input's own sharp edges leave no direction
  std::vector<Vec3> hiddenPlaces;
  std::vector<Id> hiddenPoints; ///< their ids in the refined surface, ascending
};

/// Needs surface.targetEdgeLength; the fields of the points (featureSize, thickness, ...) are carried to the
/// new points.
Result<RefineSurfaceReport> RefineSurface(TriangleComplex& surface, const RefineSurfaceOptions& options,
                                          Monitor& monitor);

} // namespace lamina
