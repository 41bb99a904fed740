// SPDX-License-Identifier: BSD-3-Clause
// Classes by thresholds, and what their grey values are like.
#include "SegmentRules.h"

#include <algorithm>
#include <cmath>

namespace lamina
{
namespace segment
{

namespace
{

/// The material of a grey value. NaN compares false with everything and so falls into no class above
/// background.
int ClassOf(double value, const std::vector<double>& thresholds)
{
  if (thresholds.size() > 8)
  {
    const auto above = std::upper_bound(thresholds.begin(), thresholds.end(), value);
    return std::isnan(value) ? Background : static_cast<int>(above - thresholds.begin());
  }
  int label = 0;
  for (const double threshold : thresholds)
  {
    label += value >= threshold;
  }
  return label;
}

/// Sums of one class's grey values, taken from the image's least so that squares lose no digits.
struct Sums
{
  double values = 0;
  double squares = 0;
  Id count = 0;
};

/// Add the voxels of one row whose six neighbours are of their own material.
void AddRow(const Work& work, Id j, Id k, std::vector<double>& row, std::vector<Sums>& sums)
{
  const auto& size = work.Size();
  const Id first = work.image.grid.Index(0, j, k);
  work.grey.Read(first, first + size[0], row.data());
  const int* labels = work.labels.data() + first;
  const Id up = size[0];
  const Id over = size[0] * size[1];
  for (Id i = 1; i + 1 < size[0]; ++i)
  {
    const int m = labels[i];
    const bool inside = m >= 0 && labels[i - 1] == m && labels[i + 1] == m && labels[i - up] == m &&
                        labels[i + up] == m && labels[i - over] == m && labels[i + over] == m;
    if (inside && std::isfinite(row[i]))
    {
      const double value = row[i] - work.report.least;
      sums[m].values += value;
      sums[m].squares += value * value;
      ++sums[m].count;
    }
  }
}

} // namespace

void Classify(Work& work, Monitor& monitor)
{
  const std::vector<double>& thresholds = work.options.thresholds;
  const unsigned char* inside = work.options.mask ? work.options.mask->inside.data() : nullptr;
  const bool disputed = work.HasDisputed();
  const Id length = work.Size()[0];
  monitor.For(work.Size()[1] * work.Size()[2], 64,
              [&](Id begin, Id end)
              {
                std::vector<double> row(length);
                for (Id r = begin; r < end; ++r)
                {
                  const Id first = r * length;
                  work.grey.Read(first, first + length, row.data());
                  for (Id i = 0; i < length; ++i)
                  {
                    int label = ClassOf(row[i], thresholds);
                    if (disputed && label >= 2)
                    {
                      label = label == 2 ? Undecided : static_cast<int>(Blood);
                    }
                    work.labels[first + i] = inside && !inside[first + i] ? Outside : label;
                  }
                }
              });
}

void MeasureClasses(Work& work, Monitor& monitor)
{
  // A fixed number of blocks, each summed in order, whatever the number of threads.
  constexpr Id blocks = 16;
  const auto& size = work.Size();
  const Id slices = std::max<Id>(size[2] - 2, 0);
  const std::size_t materials = static_cast<std::size_t>(work.Materials());
  std::vector<std::vector<Sums>> sums(blocks, std::vector<Sums>(materials));
  monitor.For(blocks, 1,
              [&](Id begin, Id end)
              {
                std::vector<double> row(size[0]);
                for (Id b = begin; b < end; ++b)
                {
                  for (Id k = 1 + slices * b / blocks; k < 1 + slices * (b + 1) / blocks; ++k)
                  {
                    for (Id j = 1; j + 1 < size[1]; ++j)
                    {
                      AddRow(work, j, k, row, sums[b]);
                    }
                  }
                }
              });
  const std::vector<double>& thresholds = work.options.thresholds;
  work.classes.assign(materials, {});
  for (std::size_t m = 0; m < materials; ++m)
  {
    // The thresholds around the class: with a disputed class, blood begins at the last of them.
    const std::size_t above = work.HasDisputed() && m == Blood ? m + 1 : m;
    const double from = m == 0 ? work.report.least : thresholds[above - 1];
    const double to = above < thresholds.size() ? thresholds[above] : work.report.greatest;
    Sums all;
    for (const auto& block : sums)
    {
      all.values += block[m].values;
      all.squares += block[m].squares;
      all.count += block[m].count;
    }
    ClassValues& values = work.classes[m];
    values = { 0.5 * (from + to), 0.25 * (to - from), all.count };
    if (all.count > 0)
    {
      const double mean = all.values / all.count;
      values.mean = mean + work.report.least;
      values.deviation = std::sqrt(std::max(0.0, all.squares / all.count - mean * mean));
    }
  }
}

} // namespace segment
} // namespace lamina
