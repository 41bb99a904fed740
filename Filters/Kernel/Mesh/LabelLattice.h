// SPDX-License-Identifier: BSD-3-Clause
// A label image seen from its lattice points, with the faults of the 2x2x2 blocks around them.
#pragma once

#include "BlockFaults.h"
#include "LabelImage.h"
#include "SimplePoint.h"

namespace lamina
{

struct RepairOptions;

/// The 3x3x3 voxels around one; bit or slot i + 3 j + 9 k, the voxel itself is number 13.
struct Surroundings
{
  std::array<int, 27> labels{};
  Neighbourhood exempt = 0; ///< contacts of these are never forbidden

  /// The others that carry `label`.
  Neighbourhood With(int label) const;
};

/// Lattice point (i, j, k) is the corner below voxel (i, j, k); i runs from 0 to size[0]. Voxels outside the
/// image count as background.
class LabelLattice
{
public:
  using Place = std::array<Id, 3>; ///< of a lattice point or a voxel

  LabelLattice(const LabelImage& image, const RepairOptions& options);

  const Place& Size() const { return this->VoxelSize; }
  const Place& Points() const { return this->PointSize; }
  Id PointCount() const { return this->PointSize[0] * this->PointSize[1] * this->PointSize[2]; }
  Id PointIndex(const Place& p) const
  {
    return p[0] + this->PointSize[0] * (p[1] + this->PointSize[1] * p[2]);
  }
  Place PointPlace(Id index) const
  {
    return { index % this->PointSize[0], index / this->PointSize[0] % this->PointSize[1],
             index / (this->PointSize[0] * this->PointSize[1]) };
  }
  bool IsPoint(const Place& p) const
  {
    return p[0] >= 0 && p[1] >= 0 && p[2] >= 0 && p[0] < this->PointSize[0] && p[1] < this->PointSize[1] &&
           p[2] < this->PointSize[2];
  }
  bool IsVoxel(const Place& v) const
  {
    return v[0] >= 0 && v[1] >= 0 && v[2] >= 0 && v[0] < this->VoxelSize[0] && v[1] < this->VoxelSize[1] &&
           v[2] < this->VoxelSize[2];
  }
  Id VoxelIndex(const Place& v) const
  {
    return v[0] + this->VoxelSize[0] * (v[1] + this->VoxelSize[1] * v[2]);
  }
  Place VoxelPlace(Id index) const
  {
    return { index % this->VoxelSize[0], index / this->VoxelSize[0] % this->VoxelSize[1],
             index / (this->VoxelSize[0] * this->VoxelSize[1]) };
  }
  /// The q-th voxel around a lattice point, in the order of Block; may lie outside.
  static Place VoxelAround(const Place& point, int q)
  {
    return { point[0] - 1 + (q & 1), point[1] - 1 + ((q >> 1) & 1), point[2] - 1 + (q >> 2) };
  }
  /// The q-th corner of a voxel.
  static Place CornerOf(const Place& voxel, int q)
  {
    return { voxel[0] + (q & 1), voxel[1] + ((q >> 1) & 1), voxel[2] + (q >> 2) };
  }

  int Label(const Place& v) const
  {
    return this->IsVoxel(v) ? this->Labels[static_cast<std::size_t>(this->VoxelIndex(v))] : 0;
  }
  bool IsFrozen(Id voxel) const
  {
    return this->Frozen && (*this->Frozen)[static_cast<std::size_t>(voxel)] != 0;
  }
  Block BlockAt(const Place& point) const;
  BlockFaults FaultsAt(const Place& point) const { return this->Rules.Find(this->BlockAt(point)); }
  Surroundings Around(const Place& voxel) const;
  const FaultRules& Faults() const { return this->Rules; }

private:
  Place VoxelSize;
  Place PointSize;
  const std::vector<int>& Labels;
  const std::vector<unsigned char>* Frozen;
  bool ExemptOutside;
  bool ExemptFrozen;
  FaultRules Rules;
};

} // namespace lamina
