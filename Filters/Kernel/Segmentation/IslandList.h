// SPDX-License-Identifier: BSD-3-Clause
// Components too small, or too many, to keep, and their runs.
#pragma once

#include "SegmentRules.h"

#include <algorithm>

namespace lamina
{
namespace segment
{

/// For each component whether it goes, numbered from 0 (-1: stays).
class Islands
{
public:
  Islands(const Work& work, const IslandLimits& limits, const ComponentMap& map);

  int Count() const { return static_cast<int>(this->Components.size()); }
  bool Goes(int component) const { return this->Number[component] >= 0; }
  int ComponentOf(int island) const { return this->Components[island]; }
  /// Call visit(run, row) for each run of an island.
  template<typename Visit>
  void ForEachRun(int island, const Visit& visit) const
  {
    for (int at = this->Start[island]; at < this->Start[island + 1]; ++at)
    {
      const int run = this->Runs[at];
      const auto row = std::upper_bound(this->Map.rowStart.begin(), this->Map.rowStart.end(), Id{ run });
      visit(this->Map.runs[run], static_cast<Id>(row - this->Map.rowStart.begin()) - 1);
    }
  }

private:
  std::vector<unsigned char> AtBorder() const;
  std::vector<unsigned char> Favoured(const Work& work) const;
  void GroupRuns();

  const ComponentMap& Map;
  std::vector<int> Number;     ///< by component
  std::vector<int> Components; ///< by island
  std::vector<int> Start;      ///< island i has Runs [Start[i], Start[i + 1])
  std::vector<int> Runs;
};

} // namespace segment
} // namespace lamina
