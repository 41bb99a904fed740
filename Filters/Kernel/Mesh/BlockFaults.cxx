// SPDX-License-Identifier: BSD-3-Clause
#include "BlockFaults.h"

#include <algorithm>

namespace lamina
{

namespace
{

/// The six lattice edges that end at the block's centre: the voxels around each, in cyclic order.
constexpr int Cycles[6][4] = { { 0, 1, 3, 2 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 },
                               { 2, 3, 7, 6 }, { 0, 2, 6, 4 }, { 1, 3, 7, 5 } };

/// For each set of a block's voxels: bits 0 to 5 the edges, bit 6 the corner, across which alone the set or
/// its complement touches itself (Latecki's C1 and C2).
std::array<unsigned char, 256> MakeTable()
{
  std::array<unsigned char, 256> table{};
  for (unsigned set = 0; set < 256; ++set)
  {
    const auto in = [set](int voxel) { return ((set >> voxel) & 1u) != 0; };
    for (unsigned e = 0; e < 6; ++e)
    {
      const int* c = Cycles[e];
      const bool critical = in(c[0]) == in(c[2]) && in(c[1]) == in(c[3]) && in(c[0]) != in(c[1]);
      table[set] = static_cast<unsigned char>(table[set] | (critical ? 1u << e : 0u));
    }
    for (unsigned i = 0; i < 4; ++i)
    {
      const unsigned diagonal = (1u << i) | (1u << (7 - i));
      const bool critical = set == diagonal || set == (0xffu & ~diagonal);
      table[set] = static_cast<unsigned char>(table[set] | (critical ? 64u : 0u));
    }
  }
  return table;
}

} // namespace

bool IsCriticalEdge(int p0, int p1, int p2, int p3)
{
  return (p0 == p2 && p0 != p1 && p0 != p3) || (p1 == p3 && p1 != p0 && p1 != p2);
}

bool Block::IsUniform() const
{
  bool same = true;
  for (std::size_t q = 1; q < 8; ++q)
  {
    same = same && this->labels[q] == this->labels[0];
  }
  return same;
}

FaultRules::FaultRules(const std::vector<ForbiddenPair>& forbidden)
  : Critical(MakeTable())
{
  for (const ForbiddenPair& pair : forbidden)
  {
    if (pair[0] != pair[1])
    {
      this->Forbidden.push_back({ std::min(pair[0], pair[1]), std::max(pair[0], pair[1]) });
    }
  }
  std::sort(this->Forbidden.begin(), this->Forbidden.end());
  for (const ForbiddenPair& pair : this->Forbidden)
  {
    if (pair[0] >= 0 && pair[1] < 64)
    {
      this->Low[static_cast<std::size_t>(pair[0])] |= 1ull << pair[1];
      this->Low[static_cast<std::size_t>(pair[1])] |= 1ull << pair[0];
    }
  }
}

bool FaultRules::MayNotTouch(int a, int b) const
{
  if (a >= 0 && b >= 0 && a < 64 && b < 64)
  {
    return ((this->Low[static_cast<std::size_t>(a)] >> b) & 1u) != 0;
  }
  return std::binary_search(this->Forbidden.begin(), this->Forbidden.end(),
                            ForbiddenPair{ std::min(a, b), std::max(a, b) });
}

int FaultRules::CountContacts(const Block& block) const
{
  int counts[8] = { 0, 0, 0, 0, 0, 0, 0, 0 }; // of the label that voxel q is the first to carry
  for (std::size_t q = 0; q < 8; ++q)
  {
    if (!((block.exempt >> q) & 1u))
    {
      std::size_t first = 0;
      while (block.labels[first] != block.labels[q] || ((block.exempt >> first) & 1u))
      {
        ++first;
      }
      ++counts[first];
    }
  }
  int contacts = 0;
  for (std::size_t p = 0; p < 8; ++p)
  {
    for (std::size_t q = p + 1; q < 8 && counts[p] > 0; ++q)
    {
      contacts += counts[q] > 0 && this->MayNotTouch(block.labels[p], block.labels[q])
                    ? std::min(counts[p], counts[q])
                    : 0;
    }
  }
  return contacts;
}

BlockFaults FaultRules::Find(const Block& block) const
{
  BlockFaults faults;
  if (block.IsUniform())
  {
    return faults;
  }
  unsigned critical = 0;
  unsigned left = 0xffu;
  for (std::size_t q = 0; left; ++q)
  {
    if (!((left >> q) & 1u))
    {
      continue;
    }
    unsigned set = 0;
    for (std::size_t p = 0; p < 8; ++p)
    {
      set |= static_cast<unsigned>(block.labels[p] == block.labels[q]) << p;
    }
    left &= ~set;
    critical |= this->Critical[set];
  }
  for (unsigned e = 0; e < 6; ++e)
  {
    faults.edges += static_cast<int>((critical >> e) & 1u);
  }
  faults.corners = critical & 64u ? 1 : 0;
  faults.contacts = this->Forbidden.empty() ? 0 : this->CountContacts(block);
  return faults;
}

} // namespace lamina
