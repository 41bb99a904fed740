// SPDX-License-Identifier: BSD-3-Clause
// The points of voxel faces moved to where grey values say that the surface cuts.
#pragma once

#include "../Base/Monitor.h"
#include "GreyCuts.h"

namespace lamina
{

/// What moving points to their cuts came to.
struct GreyCutsReport
{
  Id movedPoints = 0;
  Id heldPoints = 0; ///< moved less than the grey values ask, or not at all, because triangles would have met
  /// One a triangle: the volume between the voxel faces and the cuts, along the triangle's normal.
  std::vector<double> growth;
};

/// No point is moved farther than this along an axis, in voxels: sheets one voxel apart stay clear of each
/// other.
constexpr double LargestCutMove = 0.45;

/// Moves the points of the faces' surface (two triangles a face, in their order) along the normals of the
/// cuts around them by the mean distance to the planes of those, as far as LargestCutMove allows; points of
/// border planes and openings stay in them. No triangles intersect afterwards and none turns over: points
/// where that would happen move less. What these bounds leave out of the volume between faces and cuts is
/// added to the surface's missing volumes: with it, a piece has its partial volume. Nothing is changed if
/// cancelled.
GreyCutsReport PlaceAtGreyCuts(const GridGeometry& grid, const std::vector<VoxelFace>& faces,
                               const std::vector<GreyCut>& cuts, TriangleComplex& surface, Monitor& monitor);

} // namespace lamina
