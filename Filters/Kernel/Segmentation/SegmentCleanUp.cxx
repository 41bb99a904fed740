// SPDX-License-Identifier: BSD-3-Clause
// Walls between blood and background, and components too small to keep.
#include "SegmentRules.h"

#include <algorithm>

namespace lamina
{
namespace segment
{

namespace
{

constexpr Id Grain = 16384;

enum class Wall : unsigned char
{
  None,
  OverBlood,   ///< background that touches blood
  ImageBorder, ///< blood at the image's border
  MaskBorder   ///< blood at the mask's edge
};

/// What the wall rule makes of a voxel. Outside the mask nothing may change, so there the blood itself gives
/// way.
Wall WallAt(const Work& work, Id voxel)
{
  const int label = work.labels[voxel];
  if (label != Background && label != Blood)
  {
    return Wall::None;
  }
  bool blood = false;
  bool outside = false;
  ForEachNeighbour26(work.Size(), voxel,
                     [&](Id n)
                     {
                       blood = blood || work.labels[n] == Blood;
                       outside = outside || work.labels[n] == Outside;
                     });
  if (label == Background)
  {
    return blood ? Wall::OverBlood : Wall::None;
  }
  if (!work.options.openAtImageBorder && IsAtBorder(work.Size(), voxel))
  {
    return Wall::ImageBorder;
  }
  return outside && !work.options.openAtMaskBorder ? Wall::MaskBorder : Wall::None;
}

/// Faces that each small component shares with components that stay, by material.
struct Contacts
{
  Contacts(std::size_t components, int materialCount)
    : Materials(materialCount)
    , Faces(components * materialCount, 0)
  {
  }
  Id& At(Id component, int material) { return this->Faces[component * this->Materials + material]; }
  /// The material with most faces, from id `first` on, the lowest id where they are equal; -1 without a face.
  int Majority(Id component, int first)
  {
    int best = -1;
    for (int m = first; m < this->Materials; ++m)
    {
      if (this->At(component, m) > 0 && (best < 0 || this->At(component, m) > this->At(component, best)))
      {
        best = m;
      }
    }
    return best;
  }
  int Materials;
  std::vector<Id> Faces;
};

/// Find the components that are too small, numbering them in `small` (-1: stays).
Id NumberSmall(const Work& work, const IslandLimits& limits, const ComponentMap& map, std::vector<Id>& small)
{
  const int materials = static_cast<int>(limits.least.size());
  std::vector<Id> largest(materials, -1);
  std::vector<unsigned char> atBorder(map.components.size(), 0);
  for (std::size_t c = 0; c < map.components.size(); ++c)
  {
    const Component& component = map.components[c];
    if (component.label >= 0 &&
        (largest[component.label] < 0 || component.voxels > map.components[largest[component.label]].voxels))
    {
      largest[component.label] = static_cast<Id>(c);
    }
  }
  const Id rows = map.size[1] * map.size[2];
  for (Id r = 0; r < rows; ++r)
  {
    const Id j = r % map.size[1];
    const Id k = r / map.size[1];
    const bool edge = j == 0 || k == 0 || j == map.size[1] - 1 || k == map.size[2] - 1;
    for (Id at = map.rowStart[r]; at < map.rowStart[r + 1]; ++at)
    {
      const LabelRun& run = map.runs[at];
      atBorder[run.component] |= edge || run.begin == 0 || run.end == map.size[0];
    }
  }
  Id count = 0;
  small.assign(map.components.size(), -1);
  for (std::size_t c = 0; c < map.components.size(); ++c)
  {
    const Component& component = map.components[c];
    // Background at the image's border is part of the background around the image: only specks of it are
    // filled.
    const bool borderland = component.label == Background && atBorder[c];
    const bool isLargest = component.label >= 0 && largest[component.label] == static_cast<Id>(c);
    if (component.label < 0 || (borderland && (isLargest || component.voxels >= work.options.minimumVoxels)))
    {
      continue;
    }
    const bool alone = work.options.largestOnly && (!isLargest || component.label == Background);
    if (alone || component.voxels < limits.least[component.label])
    {
      small[c] = count++;
    }
  }
  return count;
}

enum Touch : unsigned char
{
  TouchesOutside = 1,    ///< lies at the mask's edge
  TouchesBackground = 2, ///< has a face in common with background of the image itself
  TouchesBorder = 4      ///< lies at the image's border
};

/// Count the faces between small components and those that stay; `touches` collects Touch flags of the small
/// ones.
Contacts CountContacts(const Work& work, const ComponentMap& map, const std::vector<Id>& componentOf,
                       const std::vector<Id>& small, Id count, std::vector<unsigned char>& touches)
{
  Contacts contacts(count, static_cast<int>(work.options.thresholds.size()) + 1);
  const auto& size = map.size;
  const Id step[3] = { 1, size[0], size[0] * size[1] };
  const Id rows = size[1] * size[2];
  for (Id r = 0; r < rows; ++r)
  {
    const Id j = r % size[1];
    const Id k = r / size[1];
    for (Id at = map.rowStart[r]; at < map.rowStart[r + 1]; ++at)
    {
      const LabelRun& run = map.runs[at];
      const Id id = small[run.component];
      if (id < 0)
      {
        continue;
      }
      for (Id i = run.begin; i < run.end; ++i)
      {
        const Id voxel = r * size[0] + i;
        const Id place[3] = { i, j, k };
        for (int face = 0; face < 6; ++face)
        {
          const int axis = face / 2;
          const bool up = face % 2;
          if (up ? place[axis] + 1 >= size[axis] : place[axis] == 0)
          {
            contacts.At(id, Background) += 1; // outside the image is background
            touches[id] |= TouchesBorder;
            continue;
          }
          const Id n = voxel + (up ? step[axis] : -step[axis]);
          if (work.labels[n] == work.labels[voxel])
          {
            continue;
          }
          touches[id] |= work.labels[n] == Outside ? TouchesOutside : 0;
          touches[id] |= work.labels[n] == Background ? TouchesBackground : 0;
          if (small[componentOf[n]] < 0)
          {
            contacts.At(id, std::max(work.labels[n], 0)) += 1;
          }
        }
      }
    }
  }
  return contacts;
}

/// A piece of tissue between kept blood and background is no island but a wall: without it the next pass would build
/// it again. So is one at a border that is closed.
bool IsWall(const SegmentOptions& options, unsigned char touches)
{
  return (touches & TouchesBackground) || ((touches & TouchesOutside) && !options.openAtMaskBorder) ||
    ((touches & TouchesBorder) && !options.openAtImageBorder);
}

/// The component of each voxel.
std::vector<Id> SpreadComponents(const ComponentMap& map, Monitor& monitor)
{
  std::vector<Id> componentOf(map.size[0] * map.size[1] * map.size[2]);
  monitor.For(map.size[1] * map.size[2], 64,
              [&](Id begin, Id end)
              {
                for (Id r = begin; r < end; ++r)
                {
                  for (Id at = map.rowStart[r]; at < map.rowStart[r + 1]; ++at)
                  {
                    const LabelRun& run = map.runs[at];
                    const auto row = componentOf.begin() + r * map.size[0];
                    std::fill(row + run.begin, row + run.end, run.component);
                  }
                }
              });
  return componentOf;
}

} // namespace

Id BuildWalls(Work& work, Monitor& monitor)
{
  if (!work.HasBlood())
  {
    return 0;
  }
  std::vector<Wall> walls(work.labels.size(), Wall::None);
  monitor.For(work.Count(), Grain,
              [&](Id begin, Id end)
              {
                for (Id v = begin; v < end; ++v)
                {
                  walls[v] = WallAt(work, v);
                }
              });
  Id counts[4] = { 0, 0, 0, 0 };
  for (Id v = 0; v < work.Count(); ++v)
  {
    if (walls[v] != Wall::None)
    {
      work.labels[v] = Tissue;
      ++counts[static_cast<int>(walls[v])];
    }
  }
  work.Note("background that touches blood", Tissue, 0, counts[static_cast<int>(Wall::OverBlood)]);
  work.Note("blood at the image's border, closed", Tissue, 0, counts[static_cast<int>(Wall::ImageBorder)]);
  if (work.options.mask)
  {
    work.Note("blood at the mask's edge, closed", Tissue, 0, counts[static_cast<int>(Wall::MaskBorder)]);
  }
  return counts[1] + counts[2] + counts[3];
}

IslandLimits MakeIslandLimits(const Work& work)
{
  std::vector<Id> voxels(work.options.thresholds.size() + 1, 0);
  for (const int label : work.labels)
  {
    if (label >= 0)
    {
      ++voxels[label];
    }
  }
  IslandLimits limits;
  for (const Id count : voxels)
  {
    limits.least.push_back(
      std::max(work.options.minimumVoxels, static_cast<Id>(work.options.minimumShare * count)));
  }
  return limits;
}

Id RemoveIslands(Work& work, const IslandLimits& limits, Monitor& monitor)
{
  const ComponentMap map = FindComponents(work.labels, work.Size(), Connectivity::Faces, monitor);
  if (monitor.Cancelled())
  {
    return 0;
  }
  std::vector<Id> small;
  const Id count = NumberSmall(work, limits, map, small);
  if (count == 0)
  {
    return 0;
  }
  const std::vector<Id> componentOf = SpreadComponents(map, monitor);
  std::vector<unsigned char> touches(count, 0);
  Contacts contacts = CountContacts(work, map, componentOf, small, count, touches);
  std::vector<int> target(map.components.size(), Undecided);
  Id changed = 0;
  for (std::size_t c = 0; c < map.components.size(); ++c)
  {
    const Id id = small[c];
    if (id < 0)
    {
      continue;
    }
    const Component& component = map.components[c];
    const bool pocket = component.label == Background;
    const bool atBlood = component.label == Tissue && work.HasBlood() && contacts.At(id, Blood) > 0;
    // As at the image's border, only specks of background are filled at the mask's edge.
    const bool outside = pocket && (touches[id] & TouchesOutside) && component.voxels >= work.options.minimumVoxels;
    const bool stays = outside || (atBlood && IsWall(work.options, touches[id]));
    // Tissue at an open end is given to no background: the next pass would make it tissue again.
    const int material = stays ? -1 : contacts.Majority(id, atBlood ? Tissue : Background);
    if (material >= 0 && material != component.label)
    {
      target[c] = material;
      changed += component.voxels;
      work.Note(pocket ? "enclosed background filled" : "island given to its neighbour", material, 1,
                component.voxels);
    }
  }
  monitor.For(work.Count(), Grain,
              [&](Id begin, Id end)
              {
                for (Id v = begin; v < end; ++v)
                {
                  const int material = target[componentOf[v]];
                  work.labels[v] = material >= 0 ? material : work.labels[v];
                }
              });
  return changed;
}

} // namespace segment
} // namespace lamina
