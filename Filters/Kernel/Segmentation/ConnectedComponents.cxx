// SPDX-License-Identifier: BSD-3-Clause
#include "ConnectedComponents.h"

#include <algorithm>
#include <numeric>

namespace lamina
{

namespace
{

/// Disjoint sets of runs, linked through their component field until the components are numbered. The
/// representative is always the least member, so that numbering needs no second rule.
class DisjointRuns
{
public:
  explicit DisjointRuns(std::vector<LabelRun>& runs)
    : Runs(runs)
  {
  }
  int Find(int a) const
  {
    while (this->Runs[a].component != a)
    {
      this->Runs[a].component = this->Runs[this->Runs[a].component].component;
      a = this->Runs[a].component;
    }
    return a;
  }
  void Join(Id a, Id b) const
  {
    const int first = this->Find(static_cast<int>(a));
    const int second = this->Find(static_cast<int>(b));
    this->Runs[std::max(first, second)].component = std::min(first, second);
  }

private:
  std::vector<LabelRun>& Runs;
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
                             [&](int first, int last, int label)
                             {
                               map.runs[at] = { first, last, label, static_cast<int>(at) };
                               ++at;
                             });
                }
              });
}

/// Join the runs of two neighbouring rows that share a label and overlap, or touch within `reach` voxels.
void JoinRows(const ComponentMap& map, Id rowA, Id rowB, int reach, const DisjointRuns& sets)
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

/// Join the rows of slice k to each other.
void JoinInside(const ComponentMap& map, Id k, int reach, const DisjointRuns& sets)
{
  for (Id j = 1; j < map.size[1]; ++j)
  {
    const Id row = j + map.size[1] * k;
    JoinRows(map, row - 1, row, reach, sets);
  }
}

/// Join the rows of slice k to those of the slice before.
void JoinToSliceBefore(const ComponentMap& map, Id k, int reach, const DisjointRuns& sets)
{
  for (Id j = 0; j < map.size[1]; ++j)
  {
    const Id row = j + map.size[1] * k;
    for (Id b = std::max<Id>(j - reach, 0); b <= std::min(j + reach, map.size[1] - 1); ++b)
    {
      JoinRows(map, b + map.size[1] * (k - 1), row, reach, sets);
    }
  }
}

/// Blocks of slices first, each with runs of its own, then the blocks to each other. The representatives are
/// the same whatever the order.
void JoinNeighbourRows(ComponentMap& map, Connectivity connectivity, Monitor& monitor)
{
  constexpr Id block = 16;
  const int reach = connectivity == Connectivity::Corners ? 1 : 0;
  DisjointRuns sets(map.runs);
  monitor.For((map.size[2] + block - 1) / block, 1,
              [&](Id begin, Id end)
              {
                for (Id k = begin * block; k < std::min(end * block, map.size[2]); ++k)
                {
                  JoinInside(map, k, reach, sets);
                  if (k % block != 0)
                  {
                    JoinToSliceBefore(map, k, reach, sets);
                  }
                }
              });
  for (Id k = block; k < map.size[2]; k += block)
  {
    JoinToSliceBefore(map, k, reach, sets);
  }
}

/// The runs come in memory order and a representative before the runs it stands for: one pass turns links
/// into numbers.
void NumberComponents(ComponentMap& map)
{
  const Id rows = map.size[1] * map.size[2];
  for (Id r = 0; r < rows; ++r)
  {
    for (Id at = map.rowStart[r]; at < map.rowStart[r + 1]; ++at)
    {
      LabelRun& run = map.runs[at];
      if (run.component == at)
      {
        run.component = static_cast<int>(map.components.size());
        map.components.push_back({ run.label, 0, r * map.size[0] + run.begin });
      }
      else
      {
        run.component = map.runs[run.component].component;
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
  JoinNeighbourRows(map, connectivity, monitor);
  NumberComponents(map);
  return map;
}

} // namespace lamina
