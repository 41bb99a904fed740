// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelFaults.h"

#include <algorithm>

namespace lamina
{

namespace
{

int CountBits(unsigned set)
{
  set = set - ((set >> 1) & 0x55u);
  set = (set & 0x33u) + ((set >> 2) & 0x33u);
  return static_cast<int>((set + (set >> 4)) & 0x0fu);
}

/// The part of a neighbourhood in the block whose lowest voxel is `first`, in the order of Block.
unsigned char InBlock(Neighbourhood set, std::size_t first)
{
  const unsigned at = set >> first;
  return static_cast<unsigned char>((at & 3u) | ((at >> 1) & 0xcu) | ((at >> 5) & 0x30u) |
                                    ((at >> 6) & 0xc0u));
}

constexpr std::size_t FirstOf(std::size_t block)
{
  return (block & 1) + 3 * ((block >> 1) & 1) + 9 * (block >> 2);
}

} // namespace

VoxelFaults::VoxelFaults(const Surroundings& around, const FaultRules& rules)
  : Rules(rules)
{
  this->Materials[0].label = around.labels[13];
  this->Materials[0].voxels = 0;
  this->Count = 1;
  for (unsigned n = 0; n < 27; ++n)
  {
    std::size_t m = 0;
    while (m < static_cast<std::size_t>(this->Count) && this->Materials[m].label != around.labels[n])
    {
      ++m;
    }
    if (m == static_cast<std::size_t>(this->Count))
    {
      this->Materials[m].label = around.labels[n];
      this->Materials[m].voxels = 0;
      ++this->Count;
    }
    this->Materials[m].voxels |= 1u << n;
  }
  for (std::size_t block = 0; block < 8; ++block)
  {
    for (std::size_t m = 0; m < static_cast<std::size_t>(this->Count); ++m)
    {
      this->Materials[m].sets[block] = InBlock(this->Materials[m].voxels, FirstOf(block));
    }
    this->Exempt[block] = InBlock(around.exempt, FirstOf(block));
  }
}

int VoxelFaults::Contacts(std::size_t block, const std::array<unsigned, 28>& sets, int count, int label) const
{
  const unsigned counted = ~static_cast<unsigned>(this->Exempt[block]) & 0xffu;
  const auto labelOf = [&](int m)
  { return m < this->Count ? this->Materials[static_cast<std::size_t>(m)].label : label; };
  int contacts = 0;
  for (int p = 0; p < count; ++p)
  {
    const int own = CountBits(sets[static_cast<std::size_t>(p)] & counted);
    for (int q = p + 1; own > 0 && q < count; ++q)
    {
      const int other = CountBits(sets[static_cast<std::size_t>(q)] & counted);
      contacts += other > 0 && this->Rules.MayNotTouch(labelOf(p), labelOf(q)) ? std::min(own, other) : 0;
    }
  }
  return contacts;
}

int VoxelFaults::With(int label) const
{
  int to = 0;
  while (to < this->Count && this->Materials[static_cast<std::size_t>(to)].label != label)
  {
    ++to;
  }
  const int count = std::max(this->Count, to + 1);
  int faults = 0;
  for (std::size_t block = 0; block < 8; ++block)
  {
    const unsigned middle = 1u << (7 - block);
    unsigned critical = 0;
    std::array<unsigned, 28> sets;
    for (int m = 0; m < count; ++m)
    {
      const std::size_t slot = static_cast<std::size_t>(m);
      const unsigned set = m < this->Count ? this->Materials[slot].sets[block] & ~middle : 0u;
      sets[slot] = m == to ? set | middle : set;
      critical |= this->Rules.CriticalOf(sets[slot]);
    }
    faults += CountBits(critical);
    faults += this->Rules.HasForbidden() ? this->Contacts(block, sets, count, label) : 0;
  }
  return faults;
}

} // namespace lamina
