// SPDX-License-Identifier: BSD-3-Clause
// The voxels between tissue and blood.
#include "SegmentRules.h"

#include <algorithm>
#include <iterator>

namespace lamina
{
namespace segment
{

namespace
{

constexpr Id Grain = 4096;
constexpr int Axes[3] = { 0, 1, 2 };

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

/// Call visit(run, first voxel) for each run of undecided voxels in rows [begin, end).
template<typename Visit>
void ForEachUndecidedRun(const ComponentMap& map, Id begin, Id end, const Visit& visit)
{
  for (Id r = begin; r < end; ++r)
  {
    for (Id at = map.rowStart[r]; at < map.rowStart[r + 1]; ++at)
    {
      if (map.runs[at].label == Undecided)
      {
        visit(map.runs[at], r * map.size[0]);
      }
    }
  }
}

/// The one material around each undecided group; Undecided where there are several, or none.
std::vector<int> MaterialsAround(const Work& work, const ComponentMap& map)
{
  constexpr int none = -3;
  std::vector<int> around(map.components.size(), none);
  ForEachUndecidedRun(map, 0, map.size[1] * map.size[2],
                      [&](const LabelRun& run, Id row)
                      {
                        int& material = around[run.component];
                        for (Id i = run.begin; i < run.end && material != Undecided; ++i)
                        {
                          ForEachNeighbour26(map.size, row + i,
                                             [&](Id n)
                                             {
                                               const int label = std::max(work.labels[n], int{ Undecided });
                                               if (label != Undecided)
                                               {
                                                 const bool same = material == none || material == label;
                                                 material = same ? label : int{ Undecided };
                                               }
                                             });
                        }
                      });
  std::replace(around.begin(), around.end(), none, int{ Undecided });
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
  monitor.For(map.size[1] * map.size[2], 64,
              [&](Id begin, Id end)
              {
                ForEachUndecidedRun(map, begin, end,
                                    [&](const LabelRun& run, Id row)
                                    {
                                      const auto at = work.labels.begin() + row;
                                      std::fill(at + run.begin, at + run.end, around[run.component]);
                                    });
              });
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

/// Whether blood is three voxels thick within two voxels of one: there ends a chamber, or a wide vessel.
bool IsAtChamber(const Work& work, Id voxel)
{
  const auto& size = work.Size();
  const Id centre[3] = { voxel % size[0], voxel / size[0] % size[1], voxel / (size[0] * size[1]) };
  bool found = false;
  for (Id n = 0; n < 125 && !found; ++n)
  {
    const Id place[3] = { centre[0] + n % 5 - 2, centre[1] + n / 5 % 5 - 2, centre[2] + n / 25 - 2 };
    const bool inner = std::all_of(std::begin(Axes), std::end(Axes),
                                   [&](int a) { return place[a] > 0 && place[a] + 1 < size[a]; });
    const Id at = place[0] + size[0] * (place[1] + size[1] * place[2]);
    found = inner && work.labels[at] == Blood && CountAround(work, at, Blood) == 26;
  }
  return found;
}

/// What a voxel between the thresholds may be.
enum Lumen : unsigned char
{
  NoLumen,
  AtChamber, ///< mostly among tissue, but a chamber ends here: a dent of its wall, or the mouth of a vessel
  OfVessel
};

/// The mouth of a vessel goes to it: two steps lead from a vessel away from chambers into one.
void AddMouths(const Work& work, const std::vector<Id>& voxels, std::vector<unsigned char>& lumens)
{
  for (int step = 0; step < 2; ++step)
  {
    std::vector<std::size_t> mouths;
    for (std::size_t v = 0; v < voxels.size(); ++v)
    {
      if (lumens[v] != OfVessel)
      {
        continue;
      }
      ForEachNeighbour26(work.Size(), voxels[v],
                         [&](Id n)
                         {
                           const auto at = std::lower_bound(voxels.begin(), voxels.end(), n);
                           const std::size_t index = static_cast<std::size_t>(at - voxels.begin());
                           if (at != voxels.end() && *at == n && lumens[index] == AtChamber)
                           {
                             mouths.push_back(index);
                           }
                         });
    }
    for (const std::size_t mouth : mouths)
    {
      lumens[mouth] = OfVessel;
    }
  }
}

/// A voxel between the thresholds that lies mostly among tissue is the lumen of a thin vessel, but not where
/// a chamber ends: dents of its wall would be dug into tunnels. One sweep is all: what it changes never adds
/// to the tissue around another voxel.
void ResolveVessels(Work& work, const std::vector<Id>& voxels, Monitor& monitor)
{
  std::vector<unsigned char> lumens(voxels.size(), NoLumen);
  monitor.For(static_cast<Id>(voxels.size()), Grain,
              [&](Id begin, Id end)
              {
                for (Id v = begin; v < end; ++v)
                {
                  if (CountAround(work, voxels[v], Tissue) >= work.options.coronaryMajority)
                  {
                    lumens[v] = IsAtChamber(work, voxels[v]) ? AtChamber : OfVessel;
                  }
                }
              });
  AddMouths(work, voxels, lumens);
  Id changed = 0;
  for (std::size_t v = 0; v < voxels.size(); ++v)
  {
    if (lumens[v] == OfVessel)
    {
      work.labels[voxels[v]] = Blood;
      ++changed;
    }
  }
  work.Note("disputed, thin vessel in tissue", Blood, 0, changed);
}

/// Whether the voxels are nearer to the mean of blood than to that of tissue: 1 or 0.
std::vector<double> NearestToBlood(const Work& work, const std::vector<Id>& voxels)
{
  const double middle = 0.5 * (work.classes[Tissue].mean + work.classes[Blood].mean);
  std::vector<double> shares;
  for (const Id v : voxels)
  {
    shares.push_back(work.grey.At(v) > middle ? 1 : 0);
  }
  return shares;
}

void ResolveRest(Work& work, const std::vector<Id>& voxels, Monitor& monitor)
{
  const bool person = work.options.disputed == DisputedChoice::Person;
  const std::vector<double> shares =
    person ? NearestToBlood(work, voxels) : WalkToBlood(work, voxels, monitor);
  if (monitor.Cancelled())
  {
    return;
  }
  Id toBlood = 0;
  for (std::size_t v = 0; v < voxels.size(); ++v)
  {
    const bool blood = shares[v] > 0.5;
    work.labels[voxels[v]] = blood ? Blood : Tissue;
    work.flags[voxels[v]] |= FlagDisputed;
    toBlood += blood;
  }
  const Id rest = static_cast<Id>(voxels.size());
  work.report.disputed = rest;
  const char* rule = person ? "disputed, left to a person" : "disputed, given to the likelier";
  work.Note(rule, Tissue, 0, rest - toBlood);
  work.Note(rule, Blood, 0, toBlood);
}

} // namespace

void ResolveUndecided(Work& work, Monitor& monitor)
{
  if (!work.HasDisputed())
  {
    return;
  }
  monitor.For(work.Count(), Grain,
              [&](Id begin, Id end)
              {
                for (Id v = begin; v < end; ++v)
                {
                  work.flags[v] |= work.labels[v] == Undecided ? MadeByRule : 0;
                }
              });
  ResolveEnclosed(work, monitor);
  if (!monitor.Cancelled())
  {
    ResolveVessels(work, UndecidedVoxels(work.labels), monitor);
  }
  if (!monitor.Cancelled())
  {
    ResolveRest(work, UndecidedVoxels(work.labels), monitor);
  }
}

} // namespace segment
} // namespace lamina
