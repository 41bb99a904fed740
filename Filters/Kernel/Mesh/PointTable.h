// SPDX-License-Identifier: BSD-3-Clause
// Points found by their exact coordinates.
#pragma once

#include "../Base/Types.h"

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace lamina
{

/// A hash table of points; equal means equal coordinates (0 and -0 are one). Ids are given in the order of
/// insertion.
class PointTable
{
public:
  explicit PointTable(std::size_t expected = 0)
  {
    std::size_t size = 16;
    while (size < 2 * expected)
    {
      size *= 2;
    }
    this->Slots.assign(size, -1);
    this->Points.reserve(expected);
  }

  /// The id of p, a new one if it was not there.
  Id Insert(const Vec3& p)
  {
    if (2 * (this->Points.size() + 1) > this->Slots.size())
    {
      this->Grow();
    }
    Id& slot = this->Slots[this->SlotOf(p)];
    if (slot < 0)
    {
      slot = static_cast<Id>(this->Points.size());
      this->Points.push_back(p);
    }
    return slot;
  }

  /// The id of p, -1 if it is not there.
  Id Find(const Vec3& p) const { return this->Slots[this->SlotOf(p)]; }

  const std::vector<Vec3>& GetPoints() const { return this->Points; }

private:
  static std::uint64_t Hash(const Vec3& p)
  {
    std::uint64_t hash = 0;
    for (int k = 0; k < 3; ++k)
    {
      const double value = p[k] + 0.0; // -0 becomes 0
      std::uint64_t bits = 0;
      std::memcpy(&bits, &value, sizeof bits);
      hash = (hash ^ bits) * 0x9e3779b97f4a7c15ULL;
      hash ^= hash >> 32;
    }
    return hash;
  }
  /// The slot p is in, or the free one where it belongs.
  std::size_t SlotOf(const Vec3& p) const
  {
    const std::size_t mask = this->Slots.size() - 1;
    std::size_t slot = static_cast<std::size_t>(Hash(p)) & mask;
    while (this->Slots[slot] >= 0 && !(this->Points[static_cast<std::size_t>(this->Slots[slot])] == p))
    {
      slot = (slot + 1) & mask;
    }
    return slot;
  }
  void Grow()
  {
    this->Slots.assign(2 * this->Slots.size(), -1);
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      this->Slots[this->SlotOf(this->Points[i])] = static_cast<Id>(i);
    }
  }

  std::vector<Id> Slots; ///< ids, -1 where free; as many as a power of two
  std::vector<Vec3> Points;
};

} // namespace lamina
