// SPDX-License-Identifier: BSD-3-Clause
// The local feature size of every material on a surface, and the edge length that follows from it.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "../Mesh/TriangleComplex.h"

namespace lamina
{

struct FeatureSizeOptions
{
  double minimum = 0; ///< least feature size used for edges, a length; 0: 2.6 mean edge lengths of the input
  double maximum = 0; ///< largest feature size, a length; 0: 20 mean edge lengths of the input
  double gradient = 0.3; ///< largest slope of the size field, > 0
  int layers = 6;        ///< layers asked for across a feature, >= 1
  double anisotropy = 2; ///< tangential edge over layer thickness, > 0
  double coneAngle = 15; ///< half-angle in degrees of the six rays around the normal
};

struct FeatureSizeReport
{
  double minimum = 0; ///< limits used
  double maximum = 0;
  double leastSize = 0; ///< over all points, before clipping
  double largestSize = 0;
  Id clippedBelow = 0; ///< points whose size was raised to the minimum
  Id clippedAbove = 0;
  std::vector<int> materials;
};

/// Fills featureSize, targetEdgeLength, sizedMaterials and thickness of `surface`.
Result<FeatureSizeReport> ComputeFeatureSize(TriangleComplex& surface, const FeatureSizeOptions& options,
                                             Monitor& monitor);

} // namespace lamina
