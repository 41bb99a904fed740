// SPDX-License-Identifier: BSD-3-Clause
// Where between two voxels a surface cuts, by their grey values.
#pragma once

#include "../Base/Monitor.h"
#include "../Mesh/GreyView.h"
#include "../Mesh/TriangleComplex.h"
#include "VoxelFaces.h"

#include <map>

namespace lamina
{

/// Where the surface cuts the line between the two voxels of a face.
struct GreyCut
{
  bool known = false; ///< else the middle
  double offset = 0;  ///< from the middle along the face's axis towards the high side, in voxels
  Vec3 normal;        ///< of the surface there, along the grid's axes, of either sign
};

/// The grey value between two materials that lies between the two voxels of as many of their faces as any
/// does: for materials told apart by a threshold, that threshold. The middle of the lowest such interval, so
/// that it does not depend on the order of faces. Pairs whose faces never part any value are left out.
std::map<MaterialPair, double> FindCutValues(const std::vector<VoxelFace>& faces, const GreyView& grey);

/// For each face where the grey value, linear between the voxels' centres, takes the pair's value. Not known
/// where the two values do not straddle it (the labels tell otherwise than the image there), on the image's
/// border and on openings. The normal is the direction of the grey values' gradient (Sobel's differences over
/// three voxels each way, of both voxels).
std::vector<GreyCut> FindGreyCuts(const std::vector<VoxelFace>& faces, const GreyView& grey,
                                  Monitor& monitor);

} // namespace lamina
