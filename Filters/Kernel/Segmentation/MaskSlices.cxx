// SPDX-License-Identifier: BSD-3-Clause
#include "MaskSlices.h"

#include <algorithm>

namespace lamina
{

namespace
{

constexpr std::size_t MostRegions = 64;

/// For each slice across an axis, whether it has a voxel of the regions.
std::vector<char> HasVoxels(const SliceGrid& grid, const LabelImage& mask, const std::vector<int>& ids)
{
  std::vector<char> has(static_cast<std::size_t>(grid.slices), 0);
  std::array<Id, 3> index;
  std::size_t v = 0;
  for (index[2] = 0; index[2] < grid.size[2]; ++index[2])
  {
    for (index[1] = 0; index[1] < grid.size[1]; ++index[1])
    {
      for (index[0] = 0; index[0] < grid.size[0]; ++index[0], ++v)
      {
        if (mask.labels[v] != 0 && std::binary_search(ids.begin(), ids.end(), mask.labels[v]))
        {
          has[static_cast<std::size_t>(index[static_cast<std::size_t>(grid.axis)])] = 1;
        }
      }
    }
  }
  return has;
}

struct Occurrence
{
  double count = 0;
  double share = 1; ///< of the slices between the first and the last
};

Occurrence MeasureOccurrence(const std::vector<char>& has)
{
  const auto first = std::find(has.begin(), has.end(), 1);
  const auto last = std::find(has.rbegin(), has.rend(), 1).base();
  Occurrence found;
  found.count = static_cast<double>(std::count(has.begin(), has.end(), 1));
  found.share = found.count > 0 ? found.count / static_cast<double>(last - first) : 1;
  return found;
}

/// How many slices beyond a drawn one the mask is carried: `next` is the distance to its drawn neighbour, 0
/// if it has none, `room` what the image has.
Id CarriedBeyond(Id maximumSlices, Id next, Id room)
{
  const Id wanted = maximumSlices >= 0 ? maximumSlices : (next > 0 ? next - 1 : room);
  return std::min(wanted, room);
}

/// True if the next slice that would have been drawn lies in the image, and thus is empty.
bool EndsBeforeNext(Id maximumSlices, Id next, Id room)
{
  return maximumSlices < 0 && next > 1 && next <= room;
}

} // namespace

Result<std::vector<int>> FindRegions(const LabelImage& mask, int maskValue)
{
  std::vector<int> values;
  for (const int label : mask.labels)
  {
    // Masks are long runs of the same value.
    if (label == 0 || (!values.empty() && label == values.back()))
    {
      continue;
    }
    const auto place = std::lower_bound(values.begin(), values.end(), label);
    if (place == values.end() || *place != label)
    {
      values.insert(place, label);
      if (values.size() > 65535)
      {
        break;
      }
    }
  }
  if (values.empty())
  {
    return InvalidInput("no slice is drawn: the mask is 0 everywhere");
  }
  if (maskValue != 0)
  {
    if (!std::binary_search(values.begin(), values.end(), maskValue))
    {
      return InvalidInput("no slice is drawn: the mask is " + std::to_string(maskValue) +
                          " nowhere; its values are from " + std::to_string(values.front()) + " to " +
                          std::to_string(values.back()));
    }
    return std::vector<int>{ maskValue };
  }
  if (values.size() > MostRegions)
  {
    return InvalidInput("the mask has " + std::to_string(values.size()) + " different values, at most " +
                        std::to_string(MostRegions) +
                        " regions are carried: choose one with MaskValue, or is this a grey image?");
  }
  return values;
}

int FindDrawnAxis(const LabelImage& mask, const std::vector<int>& ids)
{
  std::array<Occurrence, 3> found;
  for (int axis = 0; axis < 3; ++axis)
  {
    found[static_cast<std::size_t>(axis)] =
      MeasureOccurrence(HasVoxels(SliceGrid(mask.grid, axis), mask, ids));
  }
  int best = 2;
  for (const int axis : { 1, 0 })
  {
    best =
      found[static_cast<std::size_t>(axis)].share < found[static_cast<std::size_t>(best)].share ? axis : best;
  }
  if (found[static_cast<std::size_t>(best)].share < 1)
  {
    return best;
  }
  for (const std::size_t axis : { 1, 0 })
  {
    const double others = std::min(found[(axis + 1) % 3].count, found[(axis + 2) % 3].count);
    best = 4 * found[axis].count <= others ? static_cast<int>(axis) : best;
  }
  return best;
}

Result<std::vector<Id>> FindDrawnSlices(const SliceGrid& grid, const LabelImage& mask,
                                        const std::vector<int>& ids, const std::vector<Id>& listed, Id first)
{
  const std::vector<char> has = HasVoxels(grid, mask, ids);
  std::vector<Id> drawn;
  if (listed.empty())
  {
    for (Id k = 0; k < grid.slices; ++k)
    {
      if (has[static_cast<std::size_t>(k)])
      {
        drawn.push_back(k);
      }
    }
    return drawn;
  }
  bool any = false;
  for (const Id number : listed)
  {
    const Id k = number - first;
    if (k < 0 || k >= grid.slices)
    {
      return InvalidOption("drawn slice " + std::to_string(number) + " is outside the image: across axis " +
                           std::string(1, "ijk"[grid.axis]) + " its slices are " + std::to_string(first) +
                           " to " + std::to_string(first + grid.slices - 1));
    }
    drawn.push_back(k);
    any = any || has[static_cast<std::size_t>(k)];
  }
  std::sort(drawn.begin(), drawn.end());
  drawn.erase(std::unique(drawn.begin(), drawn.end()), drawn.end());
  if (!any)
  {
    return InvalidInput("no slice is drawn: the mask is 0 on all slices that are listed across axis " +
                        std::string(1, "ijk"[grid.axis]));
  }
  return drawn;
}

std::vector<MaskGap> FindGaps(const SliceGrid& grid, const std::vector<int>& ids, Id maximumSlices,
                              std::vector<DrawnSlice>& drawn)
{
  const std::size_t n = drawn.size();
  const Id before = drawn.front().slice;
  const Id after = grid.slices - 1 - drawn.back().slice;
  const Id nextLow = n > 1 ? drawn[1].slice - drawn[0].slice : 0;
  const Id nextHigh = n > 1 ? drawn[n - 1].slice - drawn[n - 2].slice : 0;
  const bool lowTail = !drawn.front().empty;
  const bool highTail = !drawn.back().empty;
  const bool lowEnds = lowTail && EndsBeforeNext(maximumSlices, nextLow, before);
  const bool highEnds = highTail && EndsBeforeNext(maximumSlices, nextHigh, after);
  const Id low = lowTail ? CarriedBeyond(maximumSlices, nextLow, before) : 0;
  const Id high = highTail ? CarriedBeyond(maximumSlices, nextHigh, after) : 0;
  const Id first = drawn.front().slice;
  const Id last = drawn.back().slice;
  if (lowEnds)
  {
    drawn.insert(drawn.begin(), EmptySlice(grid, ids, first - nextLow));
  }
  if (highEnds)
  {
    drawn.push_back(EmptySlice(grid, ids, last + nextHigh));
  }
  std::vector<MaskGap> gaps;
  if (!lowEnds && low > 0)
  {
    gaps.push_back({ first - low, first - 1, -1, 0 });
  }
  for (std::size_t d = 0; d + 1 < drawn.size(); ++d)
  {
    const bool nothing = drawn[d].empty && drawn[d + 1].empty;
    if (!nothing && drawn[d + 1].slice - drawn[d].slice > 1)
    {
      gaps.push_back(
        { drawn[d].slice + 1, drawn[d + 1].slice - 1, static_cast<Id>(d), static_cast<Id>(d) + 1 });
    }
  }
  if (!highEnds && high > 0)
  {
    gaps.push_back({ last + 1, last + high, static_cast<Id>(drawn.size()) - 1, -1 });
  }
  return gaps;
}

} // namespace lamina
