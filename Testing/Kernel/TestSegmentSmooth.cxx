// SPDX-License-Identifier: BSD-3-Clause
#include "GreyImages.h"
#include "Segmentation/SegmentRules.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace lamina;
using namespace lamina::greys;

namespace
{

/// Two halves of 50 and 150 along i with normal noise.
GreyImage NoisyHalves(double deviation)
{
  GreyImage image = Cube(40, 50);
  Fill(image, { 20, 0, 0 }, { 39, 39, 39 }, 150);
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 1);
  for (double& value : image.values)
  {
    value += deviation * noise(random);
  }
  return image;
}

struct Smoothing
{
  SegmentReport report;
  std::vector<double> values;
};

Smoothing SmoothedOf(const GreyImage& image, int sweeps, int threads = 2)
{
  SegmentOptions options;
  options.thresholds = { 100 };
  options.smoothingSweeps = sweeps;
  Smoothing result;
  result.report.least = 0;
  result.report.greatest = 200;
  ThreadMonitor monitor(threads);
  const GreyView view = segment::Smoothed(image, options, result.report, monitor);
  result.values.resize(image.values.size());
  view.Read(0, view.Count(), result.values.data());
  return result;
}

/// Deviation from `mean` over the voxels with i in [from, to].
double Deviation(const GreyImage& image, const std::vector<double>& values, Id from, Id to, double mean)
{
  double squares = 0;
  Id count = 0;
  for (Id v = 0; v < image.grid.Count(); ++v)
  {
    if (v % 40 >= from && v % 40 <= to)
    {
      squares += (values[v] - mean) * (values[v] - mean);
      ++count;
    }
  }
  return std::sqrt(squares / count);
}

} // namespace

TEST(SegmentSmooth, NoiseIsEstimatedAndTakenOffWithoutCrossingEdges)
{
  const GreyImage image = NoisyHalves(10);
  const Smoothing smooth = SmoothedOf(image, 2);
  EXPECT_NEAR(smooth.report.noise, 10, 0.5);
  EXPECT_LT(Deviation(image, smooth.values, 2, 17, 50), 4);
  // The layers at the edge, too: 100 grey levels are ten deviations.
  EXPECT_LT(Deviation(image, smooth.values, 19, 19, 50), 5);
  EXPECT_LT(Deviation(image, smooth.values, 20, 20, 150), 5);
}

TEST(SegmentSmooth, WithoutNoiseNothingChanges)
{
  const GreyImage heart = Heart();
  EXPECT_EQ(SmoothedOf(heart, 2).values, heart.values);
  EXPECT_EQ(SmoothedOf(heart, 2).report.noise, 0);
  const GreyImage noisy = NoisyHalves(10);
  EXPECT_EQ(SmoothedOf(noisy, 0).values, noisy.values);
}

TEST(SegmentSmooth, AnEmptySurroundingDoesNotHideTheNoise)
{
  GreyImage image = NoisyHalves(10);
  Fill(image, { 0, 0, 0 }, { 39, 39, 27 }, 0);
  EXPECT_NEAR(SmoothedOf(image, 2).report.noise, 10, 1);
}

TEST(SegmentSmooth, WhatIsNoNumberStaysAndSpoilsNothing)
{
  GreyImage image = NoisyHalves(10);
  image.values[image.grid.Index(10, 10, 10)] = std::numeric_limits<double>::quiet_NaN();
  image.values[image.grid.Index(30, 10, 10)] = std::numeric_limits<double>::infinity();
  const Smoothing smooth = SmoothedOf(image, 2);
  EXPECT_TRUE(std::isnan(smooth.values[image.grid.Index(10, 10, 10)]));
  EXPECT_EQ(smooth.values[image.grid.Index(30, 10, 10)], std::numeric_limits<double>::infinity());
  EXPECT_NEAR(smooth.values[image.grid.Index(11, 10, 10)], 50, 25);
  EXPECT_NEAR(smooth.values[image.grid.Index(31, 10, 10)], 150, 25);
}

TEST(SegmentSmooth, LongVoxelEdgesAreNotMixedAcross)
{
  // Slices of 40 and 60 by turns, in voxels eight times as high: they stay apart, which with cubes they do
  // not.
  GreyImage image = NoisyHalves(10);
  for (Id v = 0; v < image.grid.Count(); ++v)
  {
    image.values[v] += v / 1600 % 2 == 0 ? -10 : 10;
  }
  const auto step = [&](const std::vector<double>& values)
  {
    double sum = 0;
    for (Id v = 0; v < image.grid.Count(); ++v)
    {
      sum += values[v] * (v / 1600 % 2 == 0 ? -1 : 1);
    }
    return 2 * sum / image.grid.Count();
  };
  EXPECT_LT(step(SmoothedOf(image, 2).values), 15);
  image.grid.spacing = { 1, 1, 8 };
  EXPECT_GT(step(SmoothedOf(image, 2).values), 18);
}

TEST(SegmentSmooth, SameForAnyThreads)
{
  const GreyImage image = NoisyHalves(10);
  EXPECT_EQ(SmoothedOf(image, 3, 1).values, SmoothedOf(image, 3, 3).values);
}
