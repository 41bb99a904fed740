// SPDX-License-Identifier: BSD-3-Clause
// One bit for each lattice point of an image.
#pragma once

#include "../Base/Types.h"

#include <array>
#include <vector>

namespace lamina
{

/// Bits of a lattice of points. Each layer begins in a word of its own, so threads may write to different
/// layers at the same time. A point's slot is its place in the order i, then j, then k, with gaps at the ends
/// of the layers.
class PointFlags
{
public:
  using Place = std::array<Id, 3>;

  explicit PointFlags(const Place& size)
    : Row(size[0])
    , Layer((size[0] * size[1] + 63) / 64 * 64)
    , Words(static_cast<std::size_t>(this->Layer / 64 * size[2]), 0)
  {
  }

  Id Slot(const Place& p) const { return p[0] + this->Row * p[1] + this->Layer * p[2]; }
  Place PlaceOf(Id slot) const
  {
    const Id inLayer = slot % this->Layer;
    return { inLayer % this->Row, inLayer / this->Row, slot / this->Layer };
  }
  bool At(const Place& p) const { return this->At(this->Slot(p)); }
  bool At(Id slot) const
  {
    return ((this->Words[static_cast<std::size_t>(slot >> 6)] >> (slot & 63)) & 1u) != 0;
  }
  void Set(const Place& p, bool flag)
  {
    const Id slot = this->Slot(p);
    unsigned long long& word = this->Words[static_cast<std::size_t>(slot >> 6)];
    const unsigned long long bit = 1ull << (slot & 63);
    word = flag ? word | bit : word & ~bit;
  }
  /// The first slot from `slot` on whose bit is set; End() if there is none.
  Id Next(Id slot) const
  {
    while (slot < this->End())
    {
      const unsigned long long rest = this->Words[static_cast<std::size_t>(slot >> 6)] >> (slot & 63);
      if (rest == 0)
      {
        slot = (slot | 63) + 1;
        continue;
      }
      while (!this->At(slot))
      {
        ++slot;
      }
      return slot;
    }
    return this->End();
  }
  Id End() const { return static_cast<Id>(this->Words.size()) * 64; }
  Id Count() const
  {
    Id count = 0;
    for (unsigned long long word : this->Words)
    {
      for (; word; word &= word - 1)
      {
        ++count;
      }
    }
    return count;
  }

private:
  Id Row;
  Id Layer;
  std::vector<unsigned long long> Words;
};

} // namespace lamina
