// SPDX-License-Identifier: BSD-3-Clause
// Images on a regular grid with an origin, a spacing and a direction: grey values and material ids.
#pragma once

#include "../Base/Types.h"

#include <vector>

namespace lamina
{

/// Where a regular grid stands in the world. Voxel (i, j, k) is a box centred at
/// origin + direction * (spacing * (i, j, k)); i runs fastest in memory.
struct GridGeometry
{
  std::array<Id, 3> size{ { 0, 0, 0 } }; ///< voxels along i, j, k
  Vec3 origin;                           ///< world position of the centre of voxel (0, 0, 0)
  Vec3 spacing{ 1, 1, 1 };               ///< voxel edge lengths, > 0
  std::array<double, 9> direction{ { 1, 0, 0, 0, 1, 0, 0, 0,
                                     1 } }; ///< row-major; columns are the axes of i, j, k

  Id Count() const { return this->size[0] * this->size[1] * this->size[2]; }
  Id Index(Id i, Id j, Id k) const { return i + this->size[0] * (j + this->size[1] * k); }
  /// World position of continuous index (i, j, k).
  Vec3 ToWorld(double i, double j, double k) const
  {
    const double a = i * this->spacing.x;
    const double b = j * this->spacing.y;
    const double c = k * this->spacing.z;
    const auto& d = this->direction;
    return { this->origin.x + d[0] * a + d[1] * b + d[2] * c, this->origin.y + d[3] * a + d[4] * b + d[5] * c,
             this->origin.z + d[6] * a + d[7] * b + d[8] * c };
  }
  /// True if the axes form a left-handed system (a mirror image).
  bool IsMirrored() const
  {
    const auto& d = this->direction;
    return d[0] * (d[4] * d[8] - d[5] * d[7]) - d[1] * (d[3] * d[8] - d[5] * d[6]) +
             d[2] * (d[3] * d[7] - d[4] * d[6]) <
           0;
  }
  double VoxelVolume() const { return this->spacing.x * this->spacing.y * this->spacing.z; }
};

/// Material ids run from 0 (background) to this one.
constexpr int LargestMaterial = 65535;

/// Material ids, one a voxel.
struct LabelImage
{
  GridGeometry grid;
  std::vector<int> labels;
};

/// A region of interest, a byte a voxel: not 0 inside.
struct RegionMask
{
  GridGeometry grid;
  std::vector<unsigned char> inside;
};

/// Grey values, one a voxel, of its own; GreyView reads those of others where they lie.
struct GreyImage
{
  GridGeometry grid;
  std::vector<double> values;
};

} // namespace lamina
