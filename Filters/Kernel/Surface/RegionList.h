// SPDX-License-Identifier: BSD-3-Clause
// Regions of edits that are apart from each other.
#pragma once

#include "SurfaceEdit.h"

#include <cmath>

namespace lamina
{

/// Two edits do not hinder each other if neither reads what the other writes. Bounds are kept in floats, side
/// by side: all are compared with a new region at once.
class RegionList
{
public:
  /// Takes a region if it is apart from all that were taken.
  bool Admit(const EditRegion& region)
  {
    const Sides writes = SidesOf(region.writes);
    const Sides reads = SidesOf(region.reads);
    if (this->Touches(this->Reads, writes) || this->Touches(this->Writes, reads))
    {
      return false;
    }
    for (std::size_t k = 0; k < 6; ++k)
    {
      this->Writes[k].push_back(writes[k]);
      this->Reads[k].push_back(reads[k]);
    }
    return true;
  }
  void Clear()
  {
    for (std::size_t k = 0; k < 6; ++k)
    {
      this->Writes[k].clear();
      this->Reads[k].clear();
    }
  }

private:
  using Sides = std::array<float, 6>; ///< low x, y, z, then high; rounded outwards
  using Columns = std::array<std::vector<float>, 6>;

  static Sides SidesOf(const Box& box)
  {
    constexpr float most = std::numeric_limits<float>::max();
    const auto down = [](double x) { return std::nextafter(static_cast<float>(x), -most); };
    const auto up = [](double x) { return std::nextafter(static_cast<float>(x), most); };
    return { { down(box.low.x), down(box.low.y), down(box.low.z), up(box.high.x), up(box.high.y),
               up(box.high.z) } };
  }
  static bool Touches(const Columns& all, const Sides& one)
  {
    const std::size_t count = all[0].size();
    int touching = 0; // without a branch the compiler compares several at once
    for (std::size_t i = 0; i < count; ++i)
    {
      touching |= static_cast<int>(all[0][i] <= one[3]) & static_cast<int>(all[1][i] <= one[4]) &
                  static_cast<int>(all[2][i] <= one[5]) & static_cast<int>(all[3][i] >= one[0]) &
                  static_cast<int>(all[4][i] >= one[1]) & static_cast<int>(all[5][i] >= one[2]);
    }
    return touching != 0;
  }

  Columns Writes;
  Columns Reads;
};

} // namespace lamina
