// SPDX-License-Identifier: BSD-3-Clause
#include "GreyImages.h"
#include "Segmentation/HistogramThresholds.h"
#include "Segmentation/Segment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace lamina;
using namespace lamina::greys;

namespace
{

/// Thirds of 20, 85 and 190 along i, times `scale` and moved by `offset`, with normal noise.
GreyImage Thirds(double deviation, double scale = 1, double offset = 0)
{
  GreyImage image = Cube(30, 20);
  Fill(image, { 10, 0, 0 }, { 19, 29, 29 }, 85);
  Fill(image, { 20, 0, 0 }, { 29, 29, 29 }, 190);
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 1);
  for (double& value : image.values)
  {
    value = offset + scale * (value + deviation * noise(random));
  }
  return image;
}

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

TEST(HistogramThresholds, AreSuggestedWhereThoseGivenDoNotFit)
{
  ThreadMonitor monitor(2);
  LabelImage labels;
  std::vector<unsigned char> flags;
  const GreyImage image = Thirds(5, 10, -3000);
  const auto outcome = Segment(image, labels, flags, SegmentOptions{}, monitor);
  ASSERT_FALSE(outcome);
  EXPECT_NE(outcome.GetError().message.find("its histogram suggests -24"), std::string::npos)
    << outcome.GetError().message;
}

TEST(HistogramThresholds, ServeWhereNoneAreGiven)
{
  ThreadMonitor monitor(2);
  LabelImage labels;
  std::vector<unsigned char> flags;
  const GreyImage image = Thirds(8, 10, -3000);
  SegmentOptions options;
  options.thresholds.clear();
  const auto outcome = Segment(image, labels, flags, options, monitor);
  ASSERT_TRUE(outcome) << outcome.GetError().message;
  ASSERT_EQ(outcome->thresholds.size(), 3u);
  EXPECT_NEAR(outcome->thresholds[0], -3000 + 525, 120);
  // 35 and 65 % of the way from 85 to 190
  EXPECT_NEAR(outcome->thresholds[1], -3000 + 1217, 40);
  EXPECT_NEAR(outcome->thresholds[2], -3000 + 1532, 40);
  Id right = 0;
  for (std::size_t v = 0; v < labels.labels.size(); ++v)
  {
    right += labels.labels[v] == static_cast<int>(v % 30 / 10) ? 1 : 0;
  }
  // Blood at the image's border becomes tissue: its two outermost layers all around.
  EXPECT_GT(static_cast<double>(right), 0.9 * 30 * 28 * 28);
}

TEST(HistogramThresholds, LeaveTheDisputedClassOutWhereNothingLiesBetween)
{
  GreyImage image = Thirds(0);
  for (double& value : image.values)
  {
    value = value > 100 ? 1 : 0;
  }
  ThreadMonitor monitor(2);
  const auto found = HistogramClasses(image, 0, 1, monitor);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_GT(found[0], 0);
  EXPECT_LT(found[0], found[1]);
  EXPECT_LT(found[1], 1);
}
