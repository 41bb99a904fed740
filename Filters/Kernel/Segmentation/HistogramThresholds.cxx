// SPDX-License-Identifier: BSD-3-Clause
#include "HistogramThresholds.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <vector>

namespace lamina
{

namespace
{

constexpr int Bins = 256;
/// Fine enough to find the range without its tails in an image with a few far values.
constexpr int FineBins = 1 << 16;
constexpr double Tail = 0.001;
constexpr Id Grain = 1 << 16;
/// What of the way from tissue to blood may be either.
constexpr double DisputedFrom = 0.35;
constexpr double DisputedTo = 0.65;

struct Range
{
  double least;
  double greatest;
};

int BinOf(double value, const Range& range, int bins)
{
  const double share = (value - range.least) / (range.greatest - range.least);
  return std::clamp(static_cast<int>(share * bins), 0, bins - 1);
}

/// How many values fall into each bin. Sums of whole numbers: the same for any number of threads.
std::vector<Id> Count(const GreyView& grey, const Range& range, int bins, Monitor& monitor)
{
  std::vector<Id> counts(static_cast<std::size_t>(bins), 0);
  std::mutex guard;
  monitor.For(grey.Count(), Grain,
              [&](Id begin, Id end)
              {
                std::vector<double> values(static_cast<std::size_t>(std::min(end - begin, Grain)));
                std::vector<Id> own(counts.size(), 0);
                for (Id from = begin; from < end; from += Grain)
                {
                  const Id to = std::min(end, from + Grain);
                  grey.Read(from, to, values.data());
                  for (Id v = 0; v < to - from; ++v)
                  {
                    const double value = values[static_cast<std::size_t>(v)];
                    if (value >= range.least && value <= range.greatest) // neither holds for NaN
                    {
                      ++own[static_cast<std::size_t>(BinOf(value, range, bins))];
                    }
                  }
                }
                const std::lock_guard<std::mutex> lock(guard);
                for (std::size_t b = 0; b < counts.size(); ++b)
                {
                  counts[b] += own[b];
                }
              });
  return counts;
}

double ValueOf(double bin, const Range& range, int bins)
{
  return range.least + (range.greatest - range.least) * bin / bins;
}

/// The range without its tails.
Range WithoutTails(const GreyView& grey, const Range& range, Monitor& monitor)
{
  const std::vector<Id> counts = Count(grey, range, FineBins, monitor);
  Id all = 0;
  for (const Id count : counts)
  {
    all += count;
  }
  const double part = Tail * static_cast<double>(all);
  int low = 0;
  int high = FineBins;
  for (Id below = counts[0]; static_cast<double>(below) <= part && low < FineBins - 1;)
  {
    below += counts[static_cast<std::size_t>(++low)];
  }
  for (Id above = counts[FineBins - 1]; static_cast<double>(above) <= part && high - 1 > low;)
  {
    above += counts[static_cast<std::size_t>(--high - 1)];
  }
  return { ValueOf(low, range, FineBins), ValueOf(high, range, FineBins) };
}

/// The bins where the second and the third class of the largest variance between classes begin. Over a valley
/// without values every place is as good: the middle of the best ones is taken.
std::array<double, 2> BestParting(const std::vector<Id>& counts)
{
  std::vector<double> weight(Bins + 1, 0);
  std::vector<double> moment(Bins + 1, 0);
  for (int b = 0; b < Bins; ++b)
  {
    const double count = static_cast<double>(counts[static_cast<std::size_t>(b)]);
    weight[static_cast<std::size_t>(b) + 1] = weight[static_cast<std::size_t>(b)] + count;
    moment[static_cast<std::size_t>(b) + 1] = moment[static_cast<std::size_t>(b)] + count * b;
  }
  // What bins [from, to) add to the variance between classes, but for what is the same for all choices.
  const auto between = [&](std::size_t from, std::size_t to)
  {
    const double w = weight[to] - weight[from];
    const double m = moment[to] - moment[from];
    return w > 0 ? m * m / w : 0.0;
  };
  double best = -1;
  std::array<double, 2> sum{};
  int ties = 0;
  for (std::size_t low = 1; low + 1 < Bins; ++low)
  {
    for (std::size_t high = low + 1; high < Bins; ++high)
    {
      const double spread = between(0, low) + between(low, high) + between(high, Bins);
      if (spread > best * (1 + 1e-12))
      {
        best = spread;
        sum = {};
        ties = 0;
      }
      if (spread >= best * (1 - 1e-12))
      {
        sum[0] += static_cast<double>(low);
        sum[1] += static_cast<double>(high);
        ++ties;
      }
    }
  }
  return { sum[0] / ties, sum[1] / ties };
}

/// The bin that halves what bins [from, to) hold, or -1 if they hold nothing.
double MedianBin(const std::vector<Id>& counts, double from, double to)
{
  Id all = 0;
  for (int b = static_cast<int>(from); b < static_cast<int>(to); ++b)
  {
    all += counts[static_cast<std::size_t>(b)];
  }
  Id below = 0;
  for (int b = static_cast<int>(from); all > 0 && b < static_cast<int>(to); ++b)
  {
    below += counts[static_cast<std::size_t>(b)];
    if (2 * below >= all)
    {
      return b + 0.5;
    }
  }
  return -1;
}

} // namespace

std::array<double, 2> HistogramThresholds(const GreyView& grey, double least, double greatest,
                                          Monitor& monitor)
{
  const Range range = WithoutTails(grey, { least, greatest }, monitor);
  const auto [low, high] = BestParting(Count(grey, range, Bins, monitor));
  return { ValueOf(low, range, Bins), ValueOf(high, range, Bins) };
}

std::vector<double> HistogramClasses(const GreyView& grey, double least, double greatest, Monitor& monitor)
{
  const Range range = WithoutTails(grey, { least, greatest }, monitor);
  const std::vector<Id> counts = Count(grey, range, Bins, monitor);
  const auto [low, high] = BestParting(counts);
  const double middle = MedianBin(counts, low, high);
  const double upper = MedianBin(counts, high, Bins);
  if (middle < 0 || upper < 0)
  {
    return { ValueOf(low, range, Bins), ValueOf(high, range, Bins) };
  }
  const auto between = [&](double share) { return ValueOf(middle + share * (upper - middle), range, Bins); };
  return { ValueOf(low, range, Bins), between(DisputedFrom), between(DisputedTo) };
}

} // namespace lamina
