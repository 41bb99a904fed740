// SPDX-License-Identifier: BSD-3-Clause
#include "Specks.h"

#include "ConnectedComponents.h"

#include <algorithm>
#include <limits>
#include <map>

namespace lamina
{

namespace
{

ComponentMap FindParts(const std::vector<int>& labels, Id width)
{
  ThreadMonitor here(1); // slices are already shared out to threads
  return FindComponents(labels, { { width, static_cast<Id>(labels.size()) / width, 1 } }, Connectivity::Faces,
                        here);
}

/// Where a label stands in lists that begin with the background.
std::size_t PlaceOf(int label, const std::vector<int>& ids)
{
  return label == 0
           ? 0
           : 1 + static_cast<std::size_t>(std::lower_bound(ids.begin(), ids.end(), label) - ids.begin());
}

/// The edges of each speck with every label around it.
std::map<Id, std::map<int, Id>> CountEdges(const std::vector<int>& labels, Id width,
                                           const ComponentMap& parts, const std::vector<char>& isSpeck)
{
  std::map<Id, std::map<int, Id>> edges;
  const Id count = static_cast<Id>(labels.size());
  for (std::size_t row = 0; row + 1 < parts.rowStart.size(); ++row)
  {
    for (Id r = parts.rowStart[row]; r < parts.rowStart[row + 1]; ++r)
    {
      const LabelRun& run = parts.runs[static_cast<std::size_t>(r)];
      if (!isSpeck[static_cast<std::size_t>(run.component)])
      {
        continue;
      }
      const auto touch = [&](Id pixel, bool exists)
      {
        if (exists && labels[static_cast<std::size_t>(pixel)] != run.label)
        {
          ++edges[run.component][labels[static_cast<std::size_t>(pixel)]];
        }
      };
      const Id begin = static_cast<Id>(row) * width;
      touch(begin + run.begin - 1, run.begin > 0);
      touch(begin + run.end, run.end < width);
      for (Id p = begin + run.begin; p < begin + run.end; ++p)
      {
        touch(p - width, p >= width);
        touch(p + width, p + width < count);
      }
    }
  }
  return edges;
}

} // namespace

std::vector<Id> SmallestParts(const std::vector<int>& labels, Id width, const std::vector<int>& ids)
{
  std::vector<Id> least(ids.size() + 1, std::numeric_limits<Id>::max());
  for (const Component& part : FindParts(labels, width).components)
  {
    Id& one = least[PlaceOf(part.label, ids)];
    one = std::min(one, part.voxels);
  }
  return least;
}

void RemoveSpecks(std::vector<int>& labels, Id width, const std::vector<int>& ids,
                  const std::vector<Id>& least)
{
  const ComponentMap parts = FindParts(labels, width);
  std::vector<char> isSpeck(parts.components.size());
  std::transform(parts.components.begin(), parts.components.end(), isSpeck.begin(),
                 [&](const Component& part) { return part.voxels < least[PlaceOf(part.label, ids)]; });
  if (std::find(isSpeck.begin(), isSpeck.end(), 1) == isSpeck.end())
  {
    return;
  }
  const std::map<Id, std::map<int, Id>> edges = CountEdges(labels, width, parts, isSpeck);
  for (std::size_t row = 0; row + 1 < parts.rowStart.size(); ++row)
  {
    for (Id r = parts.rowStart[row]; r < parts.rowStart[row + 1]; ++r)
    {
      const LabelRun& run = parts.runs[static_cast<std::size_t>(r)];
      const auto around = edges.find(run.component);
      if (around != edges.end())
      {
        const auto most = std::max_element(around->second.begin(), around->second.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
        const auto begin = labels.begin() + static_cast<std::ptrdiff_t>(static_cast<Id>(row) * width);
        std::fill(begin + run.begin, begin + run.end, most->first);
      }
    }
  }
}

} // namespace lamina
