// SPDX-License-Identifier: BSD-3-Clause
// What has changed since when, so that nothing is tried again in vain.
#pragma once

#include "../Base/Types.h"

#include <algorithm>
#include <vector>

namespace lamina
{

/// When what lies round each point of a set of tets has changed last.
class ChangeClock
{
public:
  /// Something about a tet with these points has changed.
  void Mark(const std::array<Id, 4>& points)
  {
    ++this->Time;
    for (Id p : points)
    {
      const auto i = static_cast<std::size_t>(p);
      this->Last.resize(std::max(this->Last.size(), i + 1), 0);
      this->Last[i] = this->Time;
    }
  }
  std::size_t Now() const { return this->Time; }
  bool HasChangedSince(Id point, std::size_t time) const
  {
    const auto i = static_cast<std::size_t>(point);
    return i < this->Last.size() && this->Last[i] > time;
  }

private:
  std::size_t Time = 0;
  std::vector<std::size_t> Last; ///< one a point, as far as any was marked
};

} // namespace lamina
