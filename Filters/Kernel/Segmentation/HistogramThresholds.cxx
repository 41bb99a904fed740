// SPDX-License-Identifier: BSD-3-Clause
#include "HistogramThresholds.h"

#include "Histogram.h"

#include <vector>

namespace lamina
{

namespace
{

constexpr int Bins = 256;

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

} // namespace

std::array<double, 2> HistogramThresholds(const GreyView& grey, double least, double greatest,
                                          Monitor& monitor)
{
  const GreyRange range = WithoutTails(grey, { least, greatest }, monitor);
  const auto [low, high] = BestParting(CountValues(grey, range, Bins, monitor));
  return { range.ValueOf(low, Bins), range.ValueOf(high, Bins) };
}

} // namespace lamina
