// SPDX-License-Identifier: BSD-3-Clause
// From a label image to one complex of interface triangles for any number of materials.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "../Mesh/GreyView.h"
#include "../Mesh/LabelImage.h"
#include "../Mesh/TriangleComplex.h"

namespace lamina
{

struct ExtractInterfacesOptions
{
  /// Materials that stay open where they reach the border of the image or of the mask: their end is a plane
  /// patch "opening_1", ... Empty: every end is an ordinary wall.
  std::vector<int> openMaterials;
  bool openAtImageBorder = false;
  bool openAtMaskBorder = false;
  /// The region of interest (1 inside) that openAtMaskBorder refers to; same grid as the labels.
  const LabelImage* mask = nullptr;
  /// Grey values on the same grid. With them the surface cuts between two voxels where the values pass from
  /// one material to the other, not midway, and pieces have their partial volumes (GreyCuts.h).
  const GreyView* grey = nullptr;
  /// Merge points that such cuts bring close together (ClusterPoints.h); without grey values there are none.
  bool clusterPoints = true;
};

struct ExtractInterfacesReport
{
  Id points = 0;
  Id triangles = 0;
  Id junctionCurveEdges = 0;
  Id openings = 0;
  /// Voxels relabelled because no manifold surface could have passed between them (edge or corner contacts).
  Id repairedVoxels = 0;
  std::vector<Vec3> repairedPlaces;
  /// Voxels of pieces that the repair removed whole. What it took from other pieces is noted on the triangles
  /// (TriangleComplex::missing), and smoothing gives it back.
  Id lostVoxels = 0;
  std::vector<int> materials; ///< ids present, background apart
  std::vector<double>
    imageVolumes;         ///< of their voxels before the repair, one a material; partial with grey values
  Id movedPoints = 0;     ///< to the cuts of the grey values
  Id clusteredPoints = 0; ///< merged into others
  Id heldPoints = 0;      ///< moved less than those ask, because triangles would have met
};

/// Extract the interface surfaces of `image` into `surface`. Each material's boundary is closed and
/// 2-manifold; nodes are shared between materials; points are in world coordinates.
Result<ExtractInterfacesReport> ExtractInterfaces(const LabelImage& image, TriangleComplex& surface,
                                                  const ExtractInterfacesOptions& options, Monitor& monitor);

} // namespace lamina
