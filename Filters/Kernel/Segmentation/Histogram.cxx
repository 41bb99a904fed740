// SPDX-License-Identifier: BSD-3-Clause
#include "Histogram.h"

#include <algorithm>
#include <mutex>

namespace lamina
{

namespace
{

/// Fine enough to find the range without its tails in an image with a few far values.
constexpr int FineBins = 1 << 16;
constexpr double Tail = 0.001;
constexpr Id Grain = 1 << 16;

} // namespace

int GreyRange::BinOf(double value, int bins) const
{
  const double share = (value - this->least) / (this->greatest - this->least);
  return std::clamp(static_cast<int>(share * bins), 0, bins - 1);
}

std::vector<Id> CountValues(const GreyView& grey, const GreyRange& range, int bins, Monitor& monitor)
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
                    if (range.Holds(value))
                    {
                      ++own[static_cast<std::size_t>(range.BinOf(value, bins))];
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

GreyRange WithoutTails(const GreyView& grey, const GreyRange& range, Monitor& monitor)
{
  const std::vector<Id> counts = CountValues(grey, range, FineBins, monitor);
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
  return { range.ValueOf(low, FineBins), range.ValueOf(high, FineBins) };
}

} // namespace lamina
