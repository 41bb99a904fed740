// SPDX-License-Identifier: BSD-3-Clause
// What becomes of components too small, or too many, to keep.
#include "IslandList.h"

namespace lamina
{
namespace segment
{

namespace
{

/// What an island touches over faces.
struct Surroundings
{
  bool outside = false;    ///< lies at the mask's edge
  bool background = false; ///< background of the image itself
  bool border = false;     ///< lies at the image's border
  /// Faces with components that stay, by material ascending; the image's outside counts as background.
  std::vector<std::pair<int, Id>> faces;

  void Add(int material, Id count)
  {
    auto at = std::lower_bound(this->faces.begin(), this->faces.end(), std::make_pair(material, Id{ 0 }));
    if (at == this->faces.end() || at->first != material)
    {
      at = this->faces.insert(at, { material, 0 });
    }
    at->second += count;
  }
  Id At(int material) const
  {
    for (const auto& known : this->faces)
    {
      if (known.first == material)
      {
        return known.second;
      }
    }
    return 0;
  }
};

class IslandJudge
{
public:
  IslandJudge(const Work& work, const ComponentMap& map, const Islands& islands)
    : Image(work)
    , Map(map)
    , All(islands)
  {
  }
  /// The material that the island takes; its own if it stays.
  int Judge(int island) const;

private:
  bool IsOfRepair(int island) const;
  void LookAcross(const LabelRun& run, Id row, Surroundings& around) const;
  void LookAlong(const LabelRun& run, Surroundings& around) const;
  void Meet(const LabelRun& other, Id faces, Surroundings& around) const;
  int Choose(const Surroundings& around, int first) const;

  const Work& Image;
  const ComponentMap& Map;
  const Islands& All;
};

void IslandJudge::Meet(const LabelRun& other, Id faces, Surroundings& around) const
{
  around.outside = around.outside || other.label == Outside;
  around.background = around.background || other.label == Background;
  if (!this->All.Goes(other.component))
  {
    around.Add(std::max(other.label, 0), faces);
  }
}

/// The neighbours before and behind in the same row.
void IslandJudge::LookAlong(const LabelRun& run, Surroundings& around) const
{
  const LabelRun* at = &run;
  const bool first = run.begin == 0;
  const bool last = run.end == this->Map.size[0];
  if (first || last)
  {
    around.border = true;
    around.Add(Background, Id{ first } + Id{ last });
  }
  if (!first)
  {
    this->Meet(at[-1], 1, around);
  }
  if (!last)
  {
    this->Meet(at[1], 1, around);
  }
}

/// The neighbours in the four rows beside.
void IslandJudge::LookAcross(const LabelRun& run, Id row, Surroundings& around) const
{
  const auto& size = this->Map.size;
  const Id j = row % size[1];
  const Id k = row / size[1];
  const bool inside[4] = { j > 0, j + 1 < size[1], k > 0, k + 1 < size[2] };
  const Id rows[4] = { row - 1, row + 1, row - size[1], row + size[1] };
  for (int side = 0; side < 4; ++side)
  {
    if (!inside[side])
    {
      around.border = true;
      around.Add(Background, run.end - run.begin);
      continue;
    }
    const auto from = this->Map.runs.begin() + this->Map.rowStart[rows[side]];
    const auto to = this->Map.runs.begin() + this->Map.rowStart[rows[side] + 1];
    auto other = std::upper_bound(from, to, run.begin, [](int i, const LabelRun& r) { return i < r.end; });
    for (; other != to && other->begin < run.end; ++other)
    {
      if (other->label != run.label)
      {
        this->Meet(*other, std::min(run.end, other->end) - std::max(run.begin, other->begin), around);
      }
    }
  }
}

/// The material with most faces, from id `first` on, the lowest id among equals, whose spread brings no
/// forbidden contact; -1 if there is none.
int IslandJudge::Choose(const Surroundings& around, int first) const
{
  int best = -1;
  Id most = 0;
  for (const auto& [material, faces] : around.faces)
  {
    const int candidate = material;
    const bool harmless =
      std::none_of(around.faces.begin(), around.faces.end(),
                   [&](const auto& other) { return this->Image.IsForbidden(candidate, other.first); });
    // Blood and background are kept apart by the walls, which know about openings.
    if (material >= first && faces > most && (harmless || this->Image.HasWalls()))
    {
      best = material;
      most = faces;
    }
  }
  return best;
}

/// True if the repair made all of it.
bool IslandJudge::IsOfRepair(int island) const
{
  bool all = true;
  this->All.ForEachRun(island,
                       [&](const LabelRun& run, Id row)
                       {
                         for (Id i = run.begin; i < run.end && all; ++i)
                         {
                           all = (this->Image.flags[row * this->Map.size[0] + i] & FlagRepaired) != 0;
                         }
                       });
  return all;
}

int IslandJudge::Judge(int island) const
{
  const Component& component = this->Map.components[this->All.ComponentOf(island)];
  const SegmentOptions& options = this->Image.options;
  // What the repair makes again and again, where nothing else is well-composed, stays in the end.
  constexpr int patience = 3;
  if (this->Image.report.passes >= patience && this->IsOfRepair(island))
  {
    return component.label;
  }
  Surroundings around;
  this->All.ForEachRun(island,
                       [&](const LabelRun& run, Id row)
                       {
                         this->LookAlong(run, around);
                         this->LookAcross(run, row, around);
                       });
  // As at the image's border, only specks of background are filled at the mask's edge.
  if (component.label == Background && around.outside && component.voxels >= options.minimumVoxels)
  {
    return component.label;
  }
  const bool atBlood = component.label == Tissue && this->Image.HasWalls() && around.At(Blood) > 0;
  // A piece of tissue between kept blood and background is no island but a wall: without it the next pass
  // would build it again. So is one at a border that is closed.
  const bool wall = around.background || (around.outside && !options.openAtMaskBorder) ||
                    (around.border && !options.openAtImageBorder);
  if (atBlood && wall)
  {
    return component.label;
  }
  // Tissue at an open end is given to no background: the next pass would make it tissue again.
  const int material = this->Choose(around, atBlood ? Tissue : Background);
  return material < 0 ? component.label : material;
}

} // namespace

Id RemoveIslands(Work& work, const IslandLimits& limits, Monitor& monitor)
{
  const ComponentMap map = FindComponents(work.labels, work.Size(), Connectivity::Faces, monitor);
  if (monitor.Cancelled())
  {
    return 0;
  }
  const Islands islands(work, limits, map);
  std::vector<int> target(islands.Count());
  const IslandJudge judge(work, map, islands);
  monitor.For(islands.Count(), 256,
              [&](Id begin, Id end)
              {
                for (Id island = begin; island < end; ++island)
                {
                  target[island] = judge.Judge(static_cast<int>(island));
                }
              });
  if (monitor.Cancelled())
  {
    return 0;
  }
  Id changed = 0;
  for (int island = 0; island < islands.Count(); ++island)
  {
    const Component& component = map.components[islands.ComponentOf(island)];
    if (target[island] == component.label)
    {
      continue;
    }
    islands.ForEachRun(island,
                       [&](const LabelRun& run, Id row)
                       {
                         const auto at = work.labels.begin() + row * map.size[0];
                         std::fill(at + run.begin, at + run.end, target[island]);
                       });
    const bool pocket = component.label == Background;
    work.Note(pocket ? "enclosed background filled" : "island given to its neighbour", target[island], 1,
              component.voxels);
    changed += component.voxels;
  }
  return changed;
}

} // namespace segment
} // namespace lamina
