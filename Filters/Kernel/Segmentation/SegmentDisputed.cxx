// SPDX-License-Identifier: BSD-3-Clause
// Classes by thresholds, and the voxels between tissue and blood.
#include "SegmentRules.h"

#include <algorithm>
#include <cmath>

namespace lamina
{
namespace segment
{

namespace
{

constexpr Id Grain = 16384;

/// The voxels still undecided, in memory order.
std::vector<Id> UndecidedVoxels(const std::vector<int>& labels)
{
  std::vector<Id> voxels;
  for (Id v = 0; v < static_cast<Id>(labels.size()); ++v)
  {
    if (labels[v] == Undecided)
    {
      voxels.push_back(v);
    }
  }
  return voxels;
}

/// The one material around each undecided group; Undecided where there are several, or none.
std::vector<int> MaterialsAround(const Work& work, const ComponentMap& map)
{
  constexpr int none = -3;
  std::vector<int> around(map.components.size(), none);
  const Id rows = map.size[1] * map.size[2];
  for (Id r = 0; r < rows; ++r)
  {
    for (Id at = map.rowStart[r]; at < map.rowStart[r + 1]; ++at)
    {
      const LabelRun& run = map.runs[at];
      if (run.label != Undecided)
      {
        continue;
      }
      int& material = around[run.component];
      for (Id i = run.begin; i < run.end && material != Undecided; ++i)
      {
        ForEachNeighbour26(map.size, r * map.size[0] + i,
                           [&](Id n)
                           {
                             const int label = std::max(work.labels[n], static_cast<int>(Undecided));
                             if (label != Undecided)
                             {
                               material = (material == none || material == label) ? label : Undecided;
                             }
                           });
      }
    }
  }
  std::replace(around.begin(), around.end(), none, static_cast<int>(Undecided));
  return around;
}

/// Groups whose whole surroundings are one material take it.
void ResolveEnclosed(Work& work, Monitor& monitor)
{
  const ComponentMap map = FindComponents(work.labels, work.Size(), Connectivity::Corners, monitor);
  if (monitor.Cancelled())
  {
    return;
  }
  const std::vector<int> around = MaterialsAround(work, map);
  const Id rows = map.size[1] * map.size[2];
  for (Id r = 0; r < rows; ++r)
  {
    for (Id at = map.rowStart[r]; at < map.rowStart[r + 1]; ++at)
    {
      const LabelRun& run = map.runs[at];
      if (run.label == Undecided && around[run.component] != Undecided)
      {
        const auto row = work.labels.begin() + r * map.size[0];
        std::fill(row + run.begin, row + run.end, around[run.component]);
      }
    }
  }
  for (std::size_t c = 0; c < map.components.size(); ++c)
  {
    if (map.components[c].label == Undecided && around[c] != Undecided)
    {
      work.Note("disputed, enclosed by one material", std::max(around[c], 0), 1, map.components[c].voxels);
    }
  }
}

int CountAround(const Work& work, Id voxel, int material)
{
  int count = 0;
  ForEachNeighbour26(work.Size(), voxel, [&](Id n) { count += work.labels[n] == material; });
  return count;
}

/// A voxel between the thresholds that lies mostly among tissue is the lumen of a thin vessel. One sweep is
/// all: what it changes never adds to the tissue around another voxel.
void ResolveVessels(Work& work, const std::vector<Id>& voxels, Monitor& monitor)
{
  std::vector<unsigned char> vessel(voxels.size(), 0);
  monitor.For(static_cast<Id>(voxels.size()), Grain,
              [&](Id begin, Id end)
              {
                for (Id v = begin; v < end; ++v)
                {
                  vessel[v] = CountAround(work, voxels[v], Tissue) >= work.options.coronaryMajority;
                }
              });
  Id changed = 0;
  for (std::size_t v = 0; v < voxels.size(); ++v)
  {
    if (vessel[v])
    {
      work.labels[voxels[v]] = Blood;
      ++changed;
    }
  }
  work.Note("disputed, thin vessel in tissue", Blood, 0, changed);
}

/// Mean grey value of a material; `otherwise` if it has no voxel.
double MeanOf(const Work& work, int material, double otherwise)
{
  double sum = 0;
  Id count = 0;
  for (Id v = 0; v < work.Count(); ++v)
  {
    if (work.labels[v] == material && std::isfinite(work.grey.values[v]))
    {
      sum += work.grey.values[v];
      ++count;
    }
  }
  return count > 0 ? sum / count : otherwise;
}

/// The rest goes to the likelier of tissue and blood: nearness of the grey value to each one's mean, and
/// agreement with the neighbours, weighed equally. A few sweeps, each from the state before it, let the
/// neighbours settle.
void ResolveLikelier(Work& work, const std::vector<Id>& voxels, Monitor& monitor)
{
  const double tissue = MeanOf(work, Tissue, work.options.thresholds[1]);
  const double blood = MeanOf(work, Blood, work.options.thresholds[2]);
  const double step = std::max(blood - tissue, 1e-300);
  std::vector<int> choice(voxels.size(), Tissue);
  const auto settle = [&](double agreement)
  {
    monitor.For(static_cast<Id>(voxels.size()), Grain,
                [&](Id begin, Id end)
                {
                  for (Id v = begin; v < end; ++v)
                  {
                    const double share = (work.grey.values[voxels[v]] - tissue) / step;
                    const int balance =
                      CountAround(work, voxels[v], Blood) - CountAround(work, voxels[v], Tissue);
                    choice[v] = (2 * share - 1) + agreement * balance / 26.0 > 0 ? Blood : Tissue;
                  }
                });
    for (std::size_t v = 0; v < voxels.size() && !monitor.Cancelled(); ++v)
    {
      work.labels[voxels[v]] = choice[v];
    }
  };
  settle(0.0);
  for (int sweep = 0; sweep < 3; ++sweep)
  {
    settle(1.0);
  }
  const Id toBlood = std::count(choice.begin(), choice.end(), static_cast<int>(Blood));
  work.Note("disputed, given to the likelier", Tissue, 0, static_cast<Id>(voxels.size()) - toBlood);
  work.Note("disputed, given to the likelier", Blood, 0, toBlood);
}

} // namespace

void Classify(Work& work, Monitor& monitor)
{
  const std::vector<double>& thresholds = work.options.thresholds;
  const LabelImage* mask = work.options.mask;
  monitor.For(work.Count(), Grain,
              [&](Id begin, Id end)
              {
                for (Id v = begin; v < end; ++v)
                {
                  const double value = work.grey.values[v];
                  // NaN compares false with everything and so falls into no class above background.
                  int label = 0;
                  for (const double threshold : thresholds)
                  {
                    label += value >= threshold;
                  }
                  if (thresholds.size() == 3 && label >= 2)
                  {
                    label = label == 2 ? Undecided : static_cast<int>(Blood);
                  }
                  work.labels[v] = mask && mask->labels[v] != 1 ? Outside : label;
                }
              });
  std::vector<Id> counts(thresholds.size() + 3, 0);
  for (const int label : work.labels)
  {
    ++counts[label + 2];
  }
  if (mask)
  {
    work.Note("outside the mask", Background, 0, counts[Outside + 2]);
  }
  for (std::size_t label = 0; label + 2 < counts.size(); ++label)
  {
    if (thresholds.size() != 3 || label <= Blood)
    {
      work.Note("thresholds", static_cast<int>(label), 0, counts[label + 2]);
    }
  }
}

void ResolveUndecided(Work& work, Monitor& monitor)
{
  if (work.options.thresholds.size() != 3)
  {
    return;
  }
  ResolveEnclosed(work, monitor);
  const std::vector<Id> open = UndecidedVoxels(work.labels);
  ResolveVessels(work, open, monitor);
  const std::vector<Id> rest = UndecidedVoxels(work.labels);
  if (monitor.Cancelled())
  {
    return;
  }
  for (const Id v : rest)
  {
    work.disputed[v] = 1;
  }
  work.report.disputed = static_cast<Id>(rest.size());
  ResolveLikelier(work, rest, monitor);
}

} // namespace segment
} // namespace lamina
