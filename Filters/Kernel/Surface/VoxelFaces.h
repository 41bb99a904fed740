// SPDX-License-Identifier: BSD-3-Clause
// The faces of voxels between two materials, of which Multimaterial Marching Cubes makes its surface.
#pragma once

#include "ExtractInterfaces.h"

#include <optional>

namespace lamina
{

/// A voxel face between two materials: the lattice point of its lower corner, its axis, and what lies on
/// either side.
struct VoxelFace
{
  std::array<Id, 3> corner;
  int axis;
  int low;   ///< label on the low side of the face
  int high;  ///< label on the high side
  int plane; ///< 0 inside the image, else 1 + 2 * axis + (1 at the high border)
  bool open;

  /// The voxel on the low side; that on the high side has the indices of `corner`.
  std::array<Id, 3> LowVoxel() const
  {
    std::array<Id, 3> voxel = this->corner;
    --voxel[static_cast<std::size_t>(this->axis)];
    return voxel;
  }
  /// Whether its cut may lie elsewhere than midway: not on the image's border, nor on an opening.
  bool MayMove() const { return this->plane == 0 && !this->open; }
  /// The four lattice corners, counter-clockwise seen from the high side.
  std::array<std::array<Id, 3>, 4> Corners() const;
};

/// All of them, ascending by corner (k, then j, then i) and axis; what lies outside the image is background.
/// `cut`: flags of voxels that a plane end at the mask's edge took, or empty. Nothing if cancelled.
std::optional<std::vector<VoxelFace>> CollectVoxelFaces(const LabelImage& image,
                                                        const ExtractInterfacesOptions& options,
                                                        const std::vector<char>& cut, Monitor& monitor);

} // namespace lamina
