// SPDX-License-Identifier: BSD-3-Clause
// Shells that partial volume draws between two materials which in truth touch: a voxel that is half air and
// half enamel has the grey value of dentine.
#include "ThinSheets.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace lamina
{
namespace segment
{

namespace
{

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

/// True if any two materials with another between them may touch.
bool MayHaveSkins(const Work& work)
{
  return work.options.dissolveSkins &&
         (work.Materials() > 3 || (work.Materials() == 3 && !work.IsForbidden(Background, Blood)));
}

} // namespace

void DissolveSkins(Work& work, Monitor& monitor)
{
  if (!MayHaveSkins(work))
  {
    return;
  }
  const Id slices = work.Size()[2];
  Sheets found(slices);
  const SheetFinder finder(work);
  monitor.For(slices, 1,
              [&](Id begin, Id end)
              {
                for (Id k = begin; k < end; ++k)
                {
                  found[k] = finder.Find(k);
                }
              });
  if (monitor.Cancelled())
  {
    return;
  }
  found = OnlySkins(work, found, monitor);
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
