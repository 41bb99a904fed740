// SPDX-License-Identifier: BSD-3-Clause
// A hash grid over triangles that come and go while a surface is edited.
#pragma once

#include "../Search/TriangleTree.h"

#include <cstdint>
#include <unordered_map>

namespace lamina
{

class TriangleGrid
{
public:
  explicit TriangleGrid(double cell)
    : Inverse(1 / cell)
  {
  }
  void Insert(Id triangle, const Box& box)
  {
    this->ForCells(box,
                   [&](std::uint64_t key)
                   {
                     this->Cells[key].push_back(static_cast<int>(triangle));
                     return true;
                   });
  }
  void Erase(Id triangle, const Box& box)
  {
    this->ForCells(box,
                   [&](std::uint64_t key)
                   {
                     std::vector<int>& cell = this->Cells[key];
                     for (std::size_t i = 0; i < cell.size(); ++i)
                     {
                       if (cell[i] == static_cast<int>(triangle))
                       {
                         cell[i] = cell.back();
                         cell.pop_back();
                         break;
                       }
                     }
                     return true;
                   });
  }
  /// Calls visit(id) for the triangles of all cells that touch the box (some more than once); visit returns
  /// false to stop. Returns false if it was stopped.
  template<typename Visit>
  bool ForNear(const Box& box, Visit&& visit) const
  {
    return this->ForCells(box,
                          [&](std::uint64_t key)
                          {
                            const auto found = this->Cells.find(key);
                            if (found != this->Cells.end())
                            {
                              for (int id : found->second)
                              {
                                if (!visit(static_cast<Id>(id)))
                                {
                                  return false;
                                }
                              }
                            }
                            return true;
                          });
  }

private:
  std::int64_t At(double x) const { return static_cast<std::int64_t>(std::floor(x * this->Inverse)); }
  template<typename Do>
  bool ForCells(const Box& box, Do&& act) const
  {
    const std::int64_t i0 = this->At(box.low.x);
    const std::int64_t j0 = this->At(box.low.y);
    const std::int64_t k0 = this->At(box.low.z);
    const std::int64_t i1 = this->At(box.high.x);
    const std::int64_t j1 = this->At(box.high.y);
    const std::int64_t k1 = this->At(box.high.z);
    for (std::int64_t k = k0; k <= k1; ++k)
    {
      for (std::int64_t j = j0; j <= j1; ++j)
      {
        for (std::int64_t i = i0; i <= i1; ++i)
        {
          const std::uint64_t key = (static_cast<std::uint64_t>(i) & 0x1fffff) |
                                    (static_cast<std::uint64_t>(j) & 0x1fffff) << 21 |
                                    (static_cast<std::uint64_t>(k) & 0x1fffff) << 42;
          if (!act(key))
          {
            return false;
          }
        }
      }
    }
    return true;
  }

  double Inverse;
  std::unordered_map<std::uint64_t, std::vector<int>> Cells;
};

} // namespace lamina
