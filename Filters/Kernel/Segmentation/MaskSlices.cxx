// SPDX-License-Identifier: BSD-3-Clause
#include "MaskSlices.h"

#include <algorithm>

namespace lamina
{

namespace
{

constexpr std::size_t MostRegions = 64;

/// Put `value` into an ascending list.
void Insert(std::vector<int>& values, int value)
{
  const auto place = std::lower_bound(values.begin(), values.end(), value);
  if (place == values.end() || *place != value)
  {
    values.insert(place, value);
  }
}

/// All values but 0, or the one that is asked for, ascending; of too many only some.
std::vector<int> FindValues(const LabelImage& mask, int only, Monitor& monitor)
{
  const Id area = mask.grid.size[0] * mask.grid.size[1];
  std::vector<std::vector<int>> ofSlice(static_cast<std::size_t>(mask.grid.size[2]));
  monitor.For(mask.grid.size[2], 1,
              [&](Id begin, Id end)
              {
                for (Id k = begin; k < end; ++k)
                {
                  int last = 0; // masks are long runs of the same value
                  std::vector<int>& values = ofSlice[static_cast<std::size_t>(k)];
                  for (Id v = k * area; v < (k + 1) * area && values.size() <= MostRegions; ++v)
                  {
                    const int label = mask.labels[static_cast<std::size_t>(v)];
                    if (label != 0 && label != last && (only == 0 || label == only))
                    {
                      Insert(values, label);
                    }
                    last = label;
                  }
                }
              });
  std::vector<int> values;
  for (const std::vector<int>& some : ofSlice)
  {
    for (const int value : some)
    {
      Insert(values, value);
    }
  }
  return values;
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

Result<std::vector<int>> FindRegions(const LabelImage& mask, int maskValue, Monitor& monitor)
{
  std::vector<int> values = FindValues(mask, maskValue, monitor);
  const bool missing = values.empty() && maskValue != 0;
  if (missing)
  {
    values = FindValues(mask, 0, monitor);
  }
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  if (values.empty())
  {
    return InvalidInput("no slice is drawn: the mask is 0 everywhere");
  }
  if (missing)
  {
    return InvalidInput("no slice is drawn: the mask is " + std::to_string(maskValue) +
                        " nowhere; it has the value " + std::to_string(values.front()) +
                        (values.size() > 1 ? " and others" : ""));
  }
  if (values.size() > MostRegions)
  {
    return InvalidInput("the mask has more than " + std::to_string(MostRegions) +
                        " different values: choose one with MaskValue, or is this a grey image?");
  }
  return values;
}

SliceFlags FindSlices(const LabelImage& mask, const std::vector<int>& ids, Monitor& monitor)
{
  const auto& size = mask.grid.size;
  const auto length = [&](std::size_t axis) { return static_cast<std::size_t>(size[axis]); };
  // Each slice across k has flags of its own for i and j, so that threads do not meet.
  std::vector<char> alongI(length(0) * length(2), 0);
  std::vector<char> alongJ(length(1) * length(2), 0);
  SliceFlags flags{ { std::vector<char>(length(0), 0), std::vector<char>(length(1), 0),
                      std::vector<char>(length(2), 0) } };
  monitor.For(size[2], 1,
              [&](Id begin, Id end)
              {
                for (Id v = begin * size[0] * size[1]; v < end * size[0] * size[1]; ++v)
                {
                  const int label = mask.labels[static_cast<std::size_t>(v)];
                  if (label != 0 && std::binary_search(ids.begin(), ids.end(), label))
                  {
                    const Id k = v / (size[0] * size[1]);
                    alongI[static_cast<std::size_t>(k * size[0] + v % size[0])] = 1;
                    alongJ[static_cast<std::size_t>(k * size[1] + v / size[0] % size[1])] = 1;
                    flags[2][static_cast<std::size_t>(k)] = 1;
                  }
                }
              });
  for (std::size_t n = 0; n < alongI.size(); ++n)
  {
    flags[0][n % length(0)] |= alongI[n];
  }
  for (std::size_t n = 0; n < alongJ.size(); ++n)
  {
    flags[1][n % length(1)] |= alongJ[n];
  }
  return flags;
}

int FindDrawnAxis(const SliceFlags& flags)
{
  std::array<Occurrence, 3> found;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    found[axis] = MeasureOccurrence(flags[axis]);
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

Result<std::vector<Id>> FindDrawnSlices(const SliceFlags& flags, int axis, const std::vector<Id>& listed,
                                        Id first)
{
  const std::vector<char>& has = flags[static_cast<std::size_t>(axis)];
  const Id slices = static_cast<Id>(has.size());
  std::vector<Id> drawn;
  if (listed.empty())
  {
    for (Id k = 0; k < slices; ++k)
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
    if (k < 0 || k >= slices)
    {
      return InvalidOption("drawn slice " + std::to_string(number) + " is outside the image: across axis " +
                           std::string(1, "ijk"[axis]) + " its slices are " + std::to_string(first) + " to " +
                           std::to_string(first + slices - 1));
    }
    drawn.push_back(k);
    any = any || has[static_cast<std::size_t>(k)];
  }
  std::sort(drawn.begin(), drawn.end());
  drawn.erase(std::unique(drawn.begin(), drawn.end()), drawn.end());
  if (!any)
  {
    return InvalidInput("no slice is drawn: the mask is 0 on all slices that are listed across axis " +
                        std::string(1, "ijk"[axis]));
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
