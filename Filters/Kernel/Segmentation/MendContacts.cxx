// SPDX-License-Identifier: BSD-3-Clause
#include "MendContacts.h"

#include <array>
#include <vector>

namespace lamina
{

namespace
{

/// One bit a voxel of a 2x2x2 block (bit = i + 2 j + 4 k).
using Pattern = unsigned;

/// True if the set meets itself, or its complement itself, in an edge or a corner only.
bool IsCritical(Pattern set)
{
  constexpr std::array<std::array<int, 4>, 6> squares{
    { { 0, 1, 3, 2 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 3, 7, 6 }, { 0, 2, 6, 4 }, { 1, 3, 7, 5 } }
  };
  for (const auto& square : squares)
  {
    const auto in = [&](int corner) { return (set >> square[corner]) & 1u; };
    if (in(0) == in(2) && in(1) == in(3) && in(0) != in(1))
    {
      return true;
    }
  }
  for (int corner = 0; corner < 4; ++corner)
  {
    const Pattern diagonal = (1u << corner) | (1u << (7 - corner));
    if (set == diagonal || (~set & 0xffu) == diagonal)
    {
      return true;
    }
  }
  return false;
}

std::array<bool, 256> MakeTable()
{
  std::array<bool, 256> table{};
  for (Pattern set = 0; set < 256; ++set)
  {
    table[set] = IsCritical(set);
  }
  return table;
}

class Blocks
{
public:
  explicit Blocks(LabelImage& image)
    : Image(image)
    , Critical(MakeTable())
  {
    const auto& size = image.grid.size;
    for (int corner = 0; corner < 8; ++corner)
    {
      this->Offset[corner] = (corner & 1) + size[0] * (((corner >> 1) & 1) + size[1] * ((corner >> 2) & 1));
    }
  }
  /// The material that makes the block whose first voxel is `at` critical, or -1.
  int CriticalMaterial(Id at) const
  {
    const int* labels = this->Image.labels.data() + at;
    bool mixed = false;
    for (int c = 1; c < 8; ++c)
    {
      mixed = mixed || labels[this->Offset[c]] != labels[0];
    }
    for (int c = 0; mixed && c < 8; ++c)
    {
      const int material = labels[this->Offset[c]];
      Pattern set = 0;
      for (int d = 0; d < 8; ++d)
      {
        set |= (labels[this->Offset[d]] == material ? 1u : 0u) << d;
      }
      if (this->Critical[set])
      {
        return material;
      }
    }
    return -1;
  }
  /// Fill the block's first voxel that is not filler and whose filling helps most; returns the voxel.
  Id Fill(Id at, int filler)
  {
    Id fallback = -1;
    for (int c = 0; c < 8; ++c)
    {
      const Id voxel = at + this->Offset[c];
      const int before = this->Image.labels[voxel];
      if (before == filler)
      {
        continue;
      }
      fallback = fallback < 0 ? voxel : fallback;
      this->Image.labels[voxel] = filler;
      if (this->CriticalMaterial(at) < 0)
      {
        return voxel;
      }
      this->Image.labels[voxel] = before;
    }
    if (fallback >= 0)
    {
      this->Image.labels[fallback] = filler;
    }
    return fallback;
  }

private:
  LabelImage& Image;
  std::array<bool, 256> Critical;
  std::array<Id, 8> Offset{};
};

/// Call visit(block) for each 2x2x2 block, by its first voxel.
template<typename Visit>
void ForEachBlock(const GridGeometry& grid, const Visit& visit)
{
  for (Id k = 0; k + 1 < grid.size[2]; ++k)
  {
    for (Id j = 0; j + 1 < grid.size[1]; ++j)
    {
      for (Id i = 0; i + 1 < grid.size[0]; ++i)
      {
        visit(grid.Index(i, j, k));
      }
    }
  }
}

} // namespace

Id MendContacts(LabelImage& image, int filler)
{
  Blocks blocks(image);
  std::vector<Id> queue;
  ForEachBlock(image.grid,
               [&](Id at)
               {
                 if (blocks.CriticalMaterial(at) >= 0)
                 {
                   queue.push_back(at);
                 }
               });
  const auto& size = image.grid.size;
  Id changed = 0;
  for (std::size_t next = 0; next < queue.size(); ++next)
  {
    const Id at = queue[next];
    if (blocks.CriticalMaterial(at) < 0)
    {
      continue;
    }
    const Id voxel = blocks.Fill(at, filler);
    if (voxel < 0)
    {
      continue;
    }
    ++changed;
    queue.push_back(at);
    const Id i = voxel % size[0];
    const Id j = (voxel / size[0]) % size[1];
    const Id k = voxel / (size[0] * size[1]);
    for (int corner = 0; corner < 8; ++corner)
    {
      const Id a = i - (corner & 1);
      const Id b = j - ((corner >> 1) & 1);
      const Id c = k - (corner >> 2);
      if (a >= 0 && b >= 0 && c >= 0 && a + 1 < size[0] && b + 1 < size[1] && c + 1 < size[2])
      {
        queue.push_back(image.grid.Index(a, b, c));
      }
    }
  }
  return changed;
}

Id CountContacts(const LabelImage& image)
{
  LabelImage& unchanged = const_cast<LabelImage&>(image); // Blocks only reads until Fill() is called
  const Blocks blocks(unchanged);
  Id count = 0;
  ForEachBlock(image.grid, [&](Id at) { count += blocks.CriticalMaterial(at) >= 0; });
  return count;
}

} // namespace lamina
