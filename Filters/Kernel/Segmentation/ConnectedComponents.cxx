// SPDX-License-Identifier: BSD-3-Clause
#include "ConnectedComponents.h"

#include <algorithm>
#include <numeric>

namespace lamina
{

namespace
{

/// Disjoint sets whose representative is always the least member, so that numbering needs no second rule.
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t count)
    : Parent(count)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), Id{ 0 });
  }
  Id Find(Id a)
  {
    while (this->Parent[a] != a)
    {
      this->Parent[a] = this->Parent[this->Parent[a]];
      a = this->Parent[a];
    }
    return a;
  }
  void Join(Id a, Id b)
  {
    a = this->Find(a);
    b = this->Find(b);
    this->Parent[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<Id> Parent;
};

/// Call visit(begin, end, label) for each run of one row.
template<typename Visit>
void ForEachRun(const int* row, Id length, const Visit& visit)
{
  for (Id i = 0; i < length;)
  {
    const Id begin = i;
    const int label = row[begin];
    while (i < length && row[i] == label)
    {
      ++i;
    }
    visit(static_cast<int>(begin), static_cast<int>(i), label);
  }
}

void CollectRuns(const std::vector<int>& labels, ComponentMap& map, Monitor& monitor)
{
  const Id length = map.size[0];
  const Id rows = map.size[1] * map.size[2];
  map.rowStart.assign(rows + 1, 0);
  monitor.For(rows, 64,
              [&](Id begin, Id end)
              {
                for (Id r = begin; r < end; ++r)
                {
                  ForEachRun(labels.data() + r * length, length,
                             [&](int, int, int) { ++map.rowStart[r + 1]; });
                }
              });
  std::partial_sum(map.rowStart.begin(), map.rowStart.end(), map.rowStart.begin());
  map.runs.resize(map.rowStart[rows]);
  monitor.For(rows, 64,
              [&](Id begin, Id end)
              {
                for (Id r = begin; r < end; ++r)
                {
                  Id at = map.rowStart[r];
                  ForEachRun(labels.data() + r * length, length,
                             [&](int first, int last, int label) {
                               map.runs[at++] = { first, last, label, 0 };
                             });
                }
              });
}

/// Join the runs of two neighbouring rows that share a label and overlap, or touch within `reach` voxels.
void JoinRows(const ComponentMap& map, Id rowA, Id rowB, int reach, DisjointSets& sets)
{
  Id a = map.rowStart[rowA];
  Id b = map.rowStart[rowB];
  const Id endA = map.rowStart[rowA + 1];
  const Id endB = map.rowStart[rowB + 1];
  while (a < endA && b < endB)
  {
    const LabelRun& runA = map.runs[a];
    const LabelRun& runB = map.runs[b];
    if (runA.label == runB.label && runA.begin < runB.end + reach && runB.begin < runA.end + reach)
    {
      sets.Join(a, b);
    }
    // A run may also touch the one after the run that ends with it; the next step would miss that pair.
    if (reach > 0 && runA.end == runB.end && b + 1 < endB && map.runs[b + 1].label == runA.label)
    {
      sets.Join(a, b + 1);
    }
    (runA.end <= runB.end ? a : b) += 1;
  }
}

void JoinNeighbourRows(const ComponentMap& map, Connectivity connectivity, DisjointSets& sets)
{
  const Id rowsJ = map.size[1];
  const bool corners = connectivity == Connectivity::Corners;
  const int reach = corners ? 1 : 0;
  for (Id k = 0; k < map.size[2]; ++k)
  {
    for (Id j = 0; j < rowsJ; ++j)
    {
      const Id row = j + rowsJ * k;
      if (j > 0)
      {
        JoinRows(map, row - 1, row, reach, sets);
      }
      if (k == 0)
      {
        continue;
      }
      JoinRows(map, row - rowsJ, row, reach, sets);
      if (corners && j > 0)
      {
        JoinRows(map, row - rowsJ - 1, row, reach, sets);
      }
      if (corners && j + 1 < rowsJ)
      {
        JoinRows(map, row - rowsJ + 1, row, reach, sets);
      }
    }
  }
}

void NumberComponents(ComponentMap& map, DisjointSets& sets)
{
  const Id rows = map.size[1] * map.size[2];
  for (Id r = 0; r < rows; ++r)
  {
    for (Id at = map.rowStart[r]; at < map.rowStart[r + 1]; ++at)
    {
      LabelRun& run = map.runs[at];
      const Id root = sets.Find(at);
      if (root == at)
      {
        run.component = static_cast<Id>(map.components.size());
        map.components.push_back({ run.label, 0, r * map.size[0] + run.begin });
      }
      else
      {
        run.component = map.runs[root].component;
      }
      map.components[run.component].voxels += run.end - run.begin;
    }
  }
}

} // namespace

Id ComponentMap::CountOf(int label) const
{
  return std::count_if(this->components.begin(), this->components.end(),
                       [label](const Component& component) { return component.label == label; });
}

ComponentMap FindComponents(const std::vector<int>& labels, const std::array<Id, 3>& size,
                            Connectivity connectivity, Monitor& monitor)
{
  ComponentMap map;
  map.size = size;
  CollectRuns(labels, map, monitor);
  if (monitor.Cancelled())
  {
    return map;
  }
  DisjointSets sets(map.runs.size());
  JoinNeighbourRows(map, connectivity, sets);
  NumberComponents(map, sets);
  return map;
}

} // namespace lamina
