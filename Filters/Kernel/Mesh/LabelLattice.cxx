// SPDX-License-Identifier: BSD-3-Clause
#include "LabelLattice.h"

#include "WellComposed.h"

namespace lamina
{

LabelLattice::LabelLattice(const LabelImage& image, const RepairOptions& options)
  : VoxelSize(image.grid.size)
  , PointSize{ { image.grid.size[0] + 1, image.grid.size[1] + 1, image.grid.size[2] + 1 } }
  , Labels(image.labels)
  , Frozen(options.frozen)
  , ExemptOutside(options.openAtImageBorder)
  , ExemptFrozen(options.openAtFrozen && options.frozen)
  , Rules(options.forbidden)
{
}

Block LabelLattice::BlockAt(const Place& point) const
{
  Block block;
  const bool inner = point[0] > 0 && point[1] > 0 && point[2] > 0 && point[0] < this->VoxelSize[0] &&
                     point[1] < this->VoxelSize[1] && point[2] < this->VoxelSize[2];
  for (int q = 0; q < 8; ++q)
  {
    const Place v = VoxelAround(point, q);
    const std::size_t slot = static_cast<std::size_t>(q);
    if (inner || this->IsVoxel(v))
    {
      const Id voxel = this->VoxelIndex(v);
      block.labels[slot] = this->Labels[static_cast<std::size_t>(voxel)];
      block.exempt |= this->ExemptFrozen && this->IsFrozen(voxel) ? 1u << q : 0;
    }
    else
    {
      block.exempt |= this->ExemptOutside ? 1u << q : 0;
    }
  }
  return block;
}

Neighbourhood Surroundings::With(int label) const
{
  Neighbourhood set = 0;
  for (unsigned n = 0; n < 27; ++n)
  {
    set |= this->labels[n] == label ? 1u << n : 0u;
  }
  return set & ~(1u << 13);
}

Surroundings LabelLattice::Around(const Place& voxel) const
{
  Surroundings around;
  const bool inner = voxel[0] > 0 && voxel[1] > 0 && voxel[2] > 0 && voxel[0] + 1 < this->VoxelSize[0] &&
                     voxel[1] + 1 < this->VoxelSize[1] && voxel[2] + 1 < this->VoxelSize[2];
  std::size_t slot = 0;
  for (Id dk = -1; dk <= 1; ++dk)
  {
    for (Id dj = -1; dj <= 1; ++dj)
    {
      for (Id di = -1; di <= 1; ++di, ++slot)
      {
        const Place v{ voxel[0] + di, voxel[1] + dj, voxel[2] + dk };
        if (inner || this->IsVoxel(v))
        {
          const Id index = this->VoxelIndex(v);
          around.labels[slot] = this->Labels[static_cast<std::size_t>(index)];
          around.exempt |= this->ExemptFrozen && this->IsFrozen(index) ? 1u << slot : 0;
        }
        else
        {
          around.exempt |= this->ExemptOutside ? 1u << slot : 0;
        }
      }
    }
  }
  return around;
}

} // namespace lamina
