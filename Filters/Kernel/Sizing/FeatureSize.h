// SPDX-License-Identifier: BSD-3-Clause
// The local feature size of every material on a surface, and the edge length that follows from it.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "../Mesh/TriangleComplex.h"

namespace lamina
{

/// What one material asks for instead of the options for all; 0 takes those.
struct MaterialSizing
{
  int material = 0;
  int layers = 0;
  double anisotropy = 0;
  double minimum = 0;
  double maximum = 0;
};

struct FeatureSizeOptions
{
  double minimum = 0; ///< least feature size used for edges, a length; 0: 2.6 mean edge lengths of the input
  double maximum = 0; ///< largest feature size, a length; 0: 20 mean edge lengths of the input
  double gradient = 0.3;          ///< largest slope of the size field, > 0
  int layers = 6;                 ///< layers asked for across a feature, >= 1
  double anisotropy = 2;          ///< tangential edge over layer thickness, > 0
  double coneAngle = 15;          ///< half-angle in degrees of the six rays around the normal
  int nodesPerCircumference = 12; ///< edges around a circle of the surface's curvature; 0: any, else >= 3
  double edgePerLayer = 8;        ///< longest edge over the thickness of a layer where sizes are clipped, > 0
  std::vector<MaterialSizing> materials; ///< each material at most once
};

struct FeatureSizeReport
{
  double minimum = 0; ///< limits used for materials without their own
  double maximum = 0;
  double leastSize = 0; ///< over all points, before clipping
  double largestSize = 0;
  Id clippedBelow = 0; ///< points whose size was raised to the minimum
  Id clippedAbove = 0;
  Id curved = 0;    ///< points whose size the curvature lowered
  Id thinWalls = 0; ///< points whose edges are held short for the layers in a wall below the minimum
  double strongestCurvature = 0; ///< the largest principal curvature by amount, 1/length
  std::vector<int> materials;
};

/// Fills featureSize, targetEdgeLength, sizedMaterials, thickness and the curvatures of `surface`.
///
/// thickness: the rays' (Thickness.h), at most the maximum, limited in slope in each material; never clipped
/// from below nor shortened by curvature, as layers must fit the walls that are there.
/// featureSize: the least over the materials at the point of the thickness, shortened where a circle of the
/// surface's curvature would get fewer edges than nodesPerCircumference, clipped to the material's limits;
/// then limited in slope over all points.
/// targetEdgeLength: anisotropy / layers times that size of each material, at most edgePerLayer thicknesses
/// of a layer, the least of them; then limited to the slope gradient * anisotropy / layers (the largest of
/// the materials').
Result<FeatureSizeReport> ComputeFeatureSize(TriangleComplex& surface, const FeatureSizeOptions& options,
                                             Monitor& monitor);

} // namespace lamina
