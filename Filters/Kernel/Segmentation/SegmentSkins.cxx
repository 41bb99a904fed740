// SPDX-License-Identifier: BSD-3-Clause
// Shells that partial volume draws between two materials which in truth touch: a voxel that is half air and
// half enamel has the grey value of dentine.
#include "ThinSheets.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <sstream>

namespace lamina
{
namespace segment
{

namespace
{

/// Of the border of material 2: more skins than that and the user is asked.
constexpr double SuspiciousShare = 0.5;

using Sheets = std::vector<std::vector<SheetVoxel>>;

/// True if the sheet around a voxel is a ramp rather than a thin layer of its own material: by the values of
/// the sheet within two voxels, all of them, as one value alone tells little.
bool IsRamp(const Work& work, const Sheets& slices, const SheetVoxel& voxel)
{
  const auto& size = work.Size();
  const Id i = voxel.voxel % size[0];
  const Id j = voxel.voxel / size[0] % size[1];
  const Id k = voxel.voxel / (size[0] * size[1]);
  const int material = work.labels[voxel.voxel];
  double sum = 0;
  for (Id c = std::max<Id>(k - 2, 0); c <= std::min(k + 2, size[2] - 1); ++c)
  {
    for (Id b = std::max<Id>(j - 2, 0); b <= std::min(j + 2, size[1] - 1); ++b)
    {
      const Id first = work.image.grid.Index(std::max<Id>(i - 2, 0), b, c);
      const Id last = work.image.grid.Index(std::min(i + 2, size[0] - 1), b, c);
      auto at = std::lower_bound(slices[c].begin(), slices[c].end(), first,
                                 [](const SheetVoxel& v, Id id) { return v.voxel < id; });
      for (; at != slices[c].end() && at->voxel <= last; ++at)
      {
        sum += work.labels[at->voxel] == material ? at->own : 0;
      }
    }
  }
  return sum <= 0;
}

/// Keeps the voxels of skins alone.
Sheets OnlySkins(const Work& work, const Sheets& sheets, Monitor& monitor)
{
  Sheets skins(sheets.size());
  monitor.For(static_cast<Id>(sheets.size()), 1,
              [&](Id begin, Id end)
              {
                for (Id k = begin; k < end; ++k)
                {
                  std::copy_if(sheets[k].begin(), sheets[k].end(), std::back_inserter(skins[k]),
                               [&](const SheetVoxel& voxel)
                               { return voxel.climbs && IsRamp(work, sheets, voxel); });
                }
              });
  return skins;
}

/// All voxels that look like skins between materials that may touch, or between those that may not.
Sheets FindSkins(const Work& work, SheetsBetween which, Monitor& monitor)
{
  Sheets found(work.Size()[2]);
  const SheetFinder finder(work, which);
  monitor.For(work.Size()[2], 1,
              [&](Id begin, Id end)
              {
                for (Id k = begin; k < end; ++k)
                {
                  found[k] = finder.Find(k);
                }
              });
  return monitor.Cancelled() ? Sheets() : OnlySkins(work, found, monitor);
}

/// The voxels of a material that share a face with another one.
Id CountBorder(const Work& work, int material, Monitor& monitor)
{
  const auto& size = work.Size();
  std::vector<Id> counts(size[2], 0);
  const std::array<Id, 3> steps{ { 1, size[0], size[0] * size[1] } };
  const auto isBorder = [&](Id v)
  {
    const std::array<Id, 3> at{ { v % size[0], v / size[0] % size[1], v / (size[0] * size[1]) } };
    bool any = false;
    for (std::size_t a = 0; a < 3; ++a)
    {
      any = any || (at[a] > 0 && work.labels[v - steps[a]] != material) ||
            (at[a] + 1 < size[a] && work.labels[v + steps[a]] != material);
    }
    return any;
  };
  monitor.For(size[2], 1,
              [&](Id begin, Id end)
              {
                for (Id v = begin * steps[2]; v < end * steps[2]; ++v)
                {
                  counts[v / steps[2]] += work.labels[v] == material && isBorder(v) ? 1 : 0;
                }
              });
  return std::accumulate(counts.begin(), counts.end(), Id{ 0 });
}

/// Walls are kept between materials that may not touch. Where much of such a wall looks like partial volume
/// the rule may be the wrong one for this image.
void WarnOfForbiddenSkins(const Work& work, Monitor& monitor)
{
  if (!work.IsForbidden(Background, Blood) || work.Materials() != 3 || work.HasDisputed())
  {
    return;
  }
  Id skins = 0;
  for (const auto& slice : FindSkins(work, SheetsBetween::Forbidden, monitor))
  {
    skins += static_cast<Id>(slice.size());
  }
  const Id border = CountBorder(work, Blood, monitor);
  if (!monitor.Cancelled() && skins > SuspiciousShare * static_cast<double>(border))
  {
    std::ostringstream text;
    text << skins
         << " voxels of material 1 look like partial volume between materials 0 and 2, whose border has "
         << border
         << " voxels, but forbidden contacts keep these two apart; if they touch in truth (as enamel and "
         << "air do), take the pair 0, 2 out of the forbidden contacts";
    work.report.warnings.push_back(text.str());
  }
}

/// True if any two materials with another between them may touch.
bool MayHaveSkins(const Work& work)
{
  return work.Materials() > 3 || (work.Materials() == 3 && !work.IsForbidden(Background, Blood));
}

} // namespace

void DissolveSkins(Work& work, Monitor& monitor)
{
  if (!work.options.dissolveSkins)
  {
    return;
  }
  if (!MayHaveSkins(work))
  {
    WarnOfForbiddenSkins(work, monitor);
    return;
  }
  const Sheets found = FindSkins(work, SheetsBetween::Allowed, monitor);
  if (monitor.Cancelled())
  {
    return;
  }
  std::vector<Id> given(work.Materials(), 0);
  for (const auto& slice : found)
  {
    for (const SheetVoxel& skin : slice)
    {
      const double value = work.grey.At(skin.voxel);
      const double toLower = std::abs(value - work.classes[skin.lower].mean);
      const double toUpper = std::abs(value - work.classes[skin.upper].mean);
      const int material = toUpper < toLower ? skin.upper : skin.lower;
      work.labels[skin.voxel] = material;
      ++given[material];
    }
  }
  for (std::size_t m = 0; m < given.size(); ++m)
  {
    if (given[m] > 0)
    {
      work.Note("skin dissolved", static_cast<int>(m), 0, given[m]);
    }
  }
}

} // namespace segment
} // namespace lamina
