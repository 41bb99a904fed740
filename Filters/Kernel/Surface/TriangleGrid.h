// SPDX-License-Identifier: BSD-3-Clause
// A hash grid over triangles that come and go while a surface is edited.
#pragma once

#include "../Base/ShortList.h"
#include "../Search/TriangleTree.h"

#include <algorithm>
#include <cstdint>

namespace lamina
{

/// Each cell holds the triangles whose boxes touch it, with their boxes: what a query reads lies together.
class TriangleGrid
{
public:
  explicit TriangleGrid(double cell)
    : Inverse(1 / cell)
    , Table(1024)
  {
  }
  double CellSize() const { return 1 / this->Inverse; }
  void Insert(Id triangle, const Box& box)
  {
    const Entry entry{ static_cast<int>(triangle), Shrink(box) };
    this->ForCells(entry.bounds,
                   [&](const Place& place)
                   {
                     this->Cells[this->Make(KeyOf(place))].push_back(entry);
                     return true;
                   });
  }
  void Erase(Id triangle, const Box& box)
  {
    this->ForCells(Shrink(box),
                   [&](const Place& place)
                   {
                     Cell& cell = this->Cells[this->Make(KeyOf(place))];
                     const auto found = std::find_if(cell.begin(), cell.end(),
                                                     [&](const Entry& e) { return e.triangle == triangle; });
                     *found = cell.back();
                     cell.pop_back();
                     return true;
                   });
  }
  /// Calls visit(item, id) for the triangles whose boxes overlap that of an item of `boxes`, grown by `reach`
  /// and rounded, each pair once; visit returns false to stop. Returns false if it was stopped.
  template<typename Visit>
  bool ForNear(const std::vector<Box>& boxes, double reach, Visit&& visit) const
  {
    Box all;
    ShortList<Bounds, 16> bounds;
    for (Box box : boxes)
    {
      box.Grow(reach);
      all.Add(box);
      bounds.push_back(Shrink(box));
    }
    const Bounds whole = Shrink(all);
    const auto look = [&](const Place& place, const Entry& e)
    {
      if (!Overlap(e.bounds, whole) || !this->StartsIn(place, e.bounds, whole))
      {
        return true;
      }
      for (std::size_t i = 0; i < boxes.size(); ++i)
      {
        if (Overlap(e.bounds, bounds[i]) && !visit(i, static_cast<Id>(e.triangle)))
        {
          return false;
        }
      }
      return true;
    };
    return this->ForCells(whole,
                          [&](const Place& place)
                          {
                            const int cell = this->Table[this->Find(KeyOf(place))].cell;
                            return cell < 0 || std::all_of(this->Cells[Index(cell)].begin(),
                                                           this->Cells[Index(cell)].end(),
                                                           [&](const Entry& e) { return look(place, e); });
                          });
  }

private:
  struct Bounds
  {
    std::array<float, 3> low;
    std::array<float, 3> high;
  };
  struct Entry
  {
    int triangle;
    Bounds bounds;
  };
  using Cell = std::vector<Entry>;
  using Place = std::array<std::int64_t, 3>; ///< of a cell
  struct Slot
  {
    std::uint64_t key = 0;
    int cell = -1;
  };

  static std::size_t Index(int i) { return static_cast<std::size_t>(i); }
  /// To nearest: order is kept, so boxes that overlap still do.
  static Bounds Shrink(const Box& box)
  {
    return {
      { { static_cast<float>(box.low.x), static_cast<float>(box.low.y), static_cast<float>(box.low.z) } },
      { { static_cast<float>(box.high.x), static_cast<float>(box.high.y), static_cast<float>(box.high.z) } }
    };
  }
  static bool Overlap(const Bounds& a, const Bounds& b)
  {
    return a.low[0] <= b.high[0] && b.low[0] <= a.high[0] && a.low[1] <= b.high[1] && b.low[1] <= a.high[1] &&
           a.low[2] <= b.high[2] && b.low[2] <= a.high[2];
  }
  /// The slot of a key, or the empty one where it would go.
  std::size_t Find(std::uint64_t key) const
  {
    const std::size_t mask = this->Table.size() - 1;
    std::uint64_t mixed = key * 0x9e3779b97f4a7c15u;
    mixed ^= mixed >> 32;
    std::size_t slot = static_cast<std::size_t>(mixed) & mask;
    while (this->Table[slot].cell >= 0 && this->Table[slot].key != key)
    {
      slot = (slot + 1) & mask;
    }
    return slot;
  }
  std::size_t Make(std::uint64_t key)
  {
    std::size_t slot = this->Find(key);
    if (this->Table[slot].cell < 0)
    {
      if (2 * this->Cells.size() >= this->Table.size())
      {
        std::vector<Slot> old(2 * this->Table.size());
        old.swap(this->Table);
        for (const Slot& s : old)
        {
          if (s.cell >= 0)
          {
            this->Table[this->Find(s.key)] = s;
          }
        }
        slot = this->Find(key);
      }
      this->Table[slot] = { key, static_cast<int>(this->Cells.size()) };
      this->Cells.emplace_back();
    }
    return Index(this->Table[slot].cell);
  }
  std::int64_t At(double x) const { return static_cast<std::int64_t>(std::floor(x * this->Inverse)); }
  /// True if what two overlapping bounds share has its lower corner in this cell, as it has in one alone.
  bool StartsIn(const Place& place, const Bounds& a, const Bounds& b) const
  {
    return this->At(std::max(a.low[0], b.low[0])) == place[0] &&
           this->At(std::max(a.low[1], b.low[1])) == place[1] &&
           this->At(std::max(a.low[2], b.low[2])) == place[2];
  }
  static std::uint64_t KeyOf(const Place& place)
  {
    return (static_cast<std::uint64_t>(place[0]) & 0x1fffff) |
           (static_cast<std::uint64_t>(place[1]) & 0x1fffff) << 21 |
           (static_cast<std::uint64_t>(place[2]) & 0x1fffff) << 42;
  }
  template<typename Do>
  bool ForCells(const Bounds& bounds, Do&& act) const
  {
    const std::int64_t i0 = this->At(bounds.low[0]);
    const std::int64_t j0 = this->At(bounds.low[1]);
    const std::int64_t k0 = this->At(bounds.low[2]);
    const std::int64_t i1 = this->At(bounds.high[0]);
    const std::int64_t j1 = this->At(bounds.high[1]);
    const std::int64_t k1 = this->At(bounds.high[2]);
    for (std::int64_t k = k0; k <= k1; ++k)
    {
      for (std::int64_t j = j0; j <= j1; ++j)
      {
        for (std::int64_t i = i0; i <= i1; ++i)
        {
          if (!act({ { i, j, k } }))
          {
            return false;
          }
        }
      }
    }
    return true;
  }

  double Inverse;
  std::vector<Slot> Table; ///< open addressing; its size is a power of two
  std::vector<Cell> Cells;
};

} // namespace lamina
