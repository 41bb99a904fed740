// SPDX-License-Identifier: BSD-3-Clause
#include "IslandList.h"

#include <numeric>

namespace lamina
{
namespace segment
{

/// The components that lie at the image's border.
std::vector<unsigned char> Islands::AtBorder() const
{
  std::vector<unsigned char> atBorder(this->Map.components.size(), 0);
  const auto& size = this->Map.size;
  for (Id r = 0; r < size[1] * size[2]; ++r)
  {
    const Id j = r % size[1];
    const Id k = r / size[1];
    const bool edge = j == 0 || k == 0 || j == size[1] - 1 || k == size[2] - 1;
    for (Id at = this->Map.rowStart[r]; at < this->Map.rowStart[r + 1]; ++at)
    {
      const LabelRun& run = this->Map.runs[at];
      atBorder[run.component] |= edge || run.begin == 0 || run.end == size[0];
    }
  }
  return atBorder;
}

/// The components of each material that are among the largest that may stay: the first in memory among
/// equals.
std::vector<unsigned char> Islands::Favoured(const Work& work) const
{
  const auto& components = this->Map.components;
  const bool few = work.options.kept == KeptComponents::LargestFew;
  const Id keep = few ? work.options.keptCount : 1;
  std::vector<int> order;
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    if (components[c].label >= 0)
    {
      order.push_back(static_cast<int>(c));
    }
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return components[a].voxels > components[b].voxels; });
  std::vector<unsigned char> favoured(components.size(), 0);
  std::vector<Id> found(work.Materials(), 0);
  for (const int c : order)
  {
    favoured[c] = found[components[c].label]++ < keep;
  }
  return favoured;
}

Islands::Islands(const Work& work, const IslandLimits& limits, const ComponentMap& map)
  : Map(map)
  , Number(map.components.size(), -1)
{
  const std::vector<unsigned char> atBorder = this->AtBorder();
  const std::vector<unsigned char> favoured = this->Favoured(work);
  const bool all = work.options.kept == KeptComponents::All;
  for (std::size_t c = 0; c < map.components.size(); ++c)
  {
    const Component& component = map.components[c];
    // Background at the image's border is part of the background around the image: only specks of it are
    // filled.
    const bool borderland = component.label == Background && atBorder[c];
    const bool large = component.voxels >= work.options.minimumVoxels;
    if (component.label < 0 || (borderland && (favoured[c] || large)))
    {
      continue;
    }
    const bool spare = !all && (!favoured[c] || component.label == Background);
    if (spare || component.voxels < limits.least[component.label])
    {
      this->Number[c] = this->Count();
      this->Components.push_back(static_cast<int>(c));
    }
  }
  this->GroupRuns();
}

void Islands::GroupRuns()
{
  this->Start.assign(this->Components.size() + 1, 0);
  for (const LabelRun& run : this->Map.runs)
  {
    const int island = this->Number[run.component];
    this->Start[island < 0 ? 0 : island + 1] += island >= 0;
  }
  std::partial_sum(this->Start.begin(), this->Start.end(), this->Start.begin());
  this->Runs.resize(this->Start.back());
  std::vector<int> next(this->Start.begin(), this->Start.end() - 1);
  for (std::size_t at = 0; at < this->Map.runs.size(); ++at)
  {
    const int island = this->Number[this->Map.runs[at].component];
    if (island >= 0)
    {
      this->Runs[next[island]++] = static_cast<int>(at);
    }
  }
}

IslandLimits MakeIslandLimits(const Work& work)
{
  IslandLimits limits;
  for (const Id count : work.voxels)
  {
    limits.least.push_back(
      std::max(work.options.minimumVoxels, static_cast<Id>(work.options.minimumShare * count)));
  }
  return limits;
}

} // namespace segment
} // namespace lamina
