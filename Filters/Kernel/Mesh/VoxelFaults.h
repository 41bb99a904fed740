// SPDX-License-Identifier: BSD-3-Clause
// The faults around one voxel for each label that it may take.
#pragma once

#include "LabelLattice.h"

namespace lamina
{

/// Counts the faults of the eight blocks that share a voxel. The labels around are sorted into sets once, so
/// that each further label of the voxel costs a few look-ups.
class VoxelFaults
{
public:
  VoxelFaults(const Surroundings& around, const FaultRules& rules);

  /// The faults if the voxel had this label.
  int With(int label) const;
  /// As it is.
  int Now() const { return this->With(this->Materials[0].label); }
  /// The labels of the 27 voxels, that of the one in the middle first.
  int LabelCount() const { return this->Count; }
  /// Which of the others carry a label.
  Neighbourhood Others(int label) const
  {
    for (int n = 0; n < this->Count; ++n)
    {
      if (this->LabelAt(n) == label)
      {
        return this->Materials[static_cast<std::size_t>(n)].voxels & ~(1u << 13);
      }
    }
    return 0;
  }
  int LabelAt(int n) const { return this->Materials[static_cast<std::size_t>(n)].label; }

private:
  struct Material
  {
    int label;
    Neighbourhood voxels;
    std::array<unsigned char, 8> sets; ///< its voxels in each block
  };
  int Contacts(std::size_t block, const std::array<unsigned, 28>& sets, int count, int label) const;

  const FaultRules& Rules;
  std::array<Material, 27> Materials; // the first Count of them are set
  std::array<unsigned char, 8> Exempt{};
  int Count = 0;
};

} // namespace lamina
