// SPDX-License-Identifier: BSD-3-Clause
#include "GreyImages.h"
#include "Segmentation/HistogramThresholds.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace lamina;
using namespace lamina::greys;

namespace
{

std::array<double, 2> ThresholdsOf(const GreyImage& image, int threads = 2)
{
  const auto range = std::minmax_element(image.values.begin(), image.values.end());
  ThreadMonitor monitor(threads);
  return HistogramThresholds(image, *range.first, *range.second, monitor);
}

} // namespace

TEST(HistogramThresholds, LieBetweenTheClasses)
{
  for (const double deviation : { 0.0, 5.0, 12.0 })
  {
    const auto found = ThresholdsOf(Thirds(deviation));
    EXPECT_NEAR(found[0], 52.5, 12) << deviation;
    EXPECT_NEAR(found[1], 137.5, 15) << deviation;
  }
}

TEST(HistogramThresholds, FollowScaleAndOffset)
{
  const auto plain = ThresholdsOf(Thirds(8));
  const auto other = ThresholdsOf(Thirds(8, 10, -3000));
  for (int k = 0; k < 2; ++k)
  {
    EXPECT_NEAR(other[static_cast<std::size_t>(k)], -3000 + 10 * plain[static_cast<std::size_t>(k)], 10);
  }
}

TEST(HistogramThresholds, AreNotLedAstrayByAFewFarValues)
{
  GreyImage image = Thirds(8);
  const auto plain = ThresholdsOf(image);
  for (std::size_t v = 0; v < 10; ++v)
  {
    image.values[2700 * v] = v % 2 == 0 ? 20000 : -20000;
  }
  const auto found = ThresholdsOf(image);
  EXPECT_NEAR(found[0], plain[0], 8);
  EXPECT_NEAR(found[1], plain[1], 8);
}

TEST(HistogramThresholds, AreTheSameForAnyNumberOfThreads)
{
  const GreyImage image = Thirds(12);
  EXPECT_EQ(ThresholdsOf(image, 1), ThresholdsOf(image, 3));
}
