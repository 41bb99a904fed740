// SPDX-License-Identifier: BSD-3-Clause
#include "Segmentation/ConnectedComponents.h"
#include "Segmentation/HeartPhantom.h"
#include "Segmentation/MendContacts.h"
#include "Segmentation/Segment.h"

#include <gtest/gtest.h>

using namespace lamina;

namespace
{

struct Phantom
{
  GreyImage grey;
  LabelImage labels;
  HeartPhantomReport report;
};

Phantom Make(const HeartPhantomOptions& options, int threads = 2)
{
  Phantom phantom;
  ThreadMonitor monitor(threads);
  const auto report = MakeHeartPhantom(phantom.grey, phantom.labels, options, monitor);
  EXPECT_TRUE(report) << report.GetError().message;
  if (report)
  {
    phantom.report = *report;
  }
  return phantom;
}

HeartPhantomOptions OfResolution(int resolution)
{
  HeartPhantomOptions options;
  options.resolution = resolution;
  return options;
}

/// The least number of voxels between a voxel that is not background and the image's border.
Id LeastMargin(const LabelImage& image)
{
  const auto& size = image.grid.size;
  Id margin = size[0];
  for (Id v = 0; v < image.grid.Count(); ++v)
  {
    if (image.labels[v] != 0)
    {
      const Id place[3] = { v % size[0], v / size[0] % size[1], v / (size[0] * size[1]) };
      for (int a = 0; a < 3; ++a)
      {
        margin = std::min({ margin, place[a], size[a] - 1 - place[a] });
      }
    }
  }
  return margin;
}

bool BloodTouchesBackground(const LabelImage& image)
{
  const auto& size = image.grid.size;
  for (Id k = 0; k + 1 < size[2]; ++k)
  {
    for (Id j = 0; j + 1 < size[1]; ++j)
    {
      for (Id i = 0; i + 1 < size[0]; ++i)
      {
        bool has[3] = { false, false, false };
        for (int c = 0; c < 8; ++c)
        {
          has[image.labels[image.grid.Index(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2))]] = true;
        }
        if (has[0] && has[2])
        {
          return true;
        }
      }
    }
  }
  return false;
}

} // namespace

TEST(HeartPhantom, TrueLabelsAreWellSeparatedAtEveryResolution)
{
  for (const int resolution : { 16, 24, 26, 32, 36, 48, 63, 64, 81, 100, 120 })
  {
    SCOPED_TRACE(resolution);
    const Phantom phantom = Make(OfResolution(resolution));
    const auto& size = phantom.labels.grid.size;
    EXPECT_EQ(std::max({ size[0], size[1], size[2] }), resolution);
    EXPECT_GE(LeastMargin(phantom.labels), 3);
    EXPECT_FALSE(BloodTouchesBackground(phantom.labels));
    EXPECT_EQ(CountContacts(phantom.labels), 0);
    const Id blood = resolution < 26 ? 1 : (resolution < 64 ? 2 : 4);
    EXPECT_EQ(phantom.report.materials[0].components, 1);
    EXPECT_EQ(phantom.report.materials[1].components, 1);
    EXPECT_EQ(phantom.report.materials[2].components, blood);
  }
}

TEST(HeartPhantom, SegmentationFindsTheTrueComponents)
{
  for (const int resolution : { 64, 96, 120, 160 })
  {
    for (const bool open : { false, true })
    {
      SCOPED_TRACE(testing::Message() << resolution << (open ? " open" : " closed"));
      HeartPhantomOptions options = OfResolution(resolution);
      options.open = open;
      const Phantom phantom = Make(options);
      ThreadMonitor monitor(2);
      LabelImage labels;
      std::vector<unsigned char> disputed;
      SegmentOptions segment;
      segment.openAtImageBorder = open;
      const auto report = Segment(phantom.grey, labels, disputed, segment, monitor);
      ASSERT_TRUE(report);
      ASSERT_EQ(report->after.size(), 3u);
      for (int id = 0; id < 3; ++id)
      {
        const auto& found = report->after[id];
        const auto& truth = phantom.report.materials[id];
        EXPECT_EQ(found.b0, truth.components) << "material " << id;
        if (resolution >= 96)
        {
          EXPECT_NEAR(double(found.voxels) / truth.voxels, 1.0, 0.08) << "material " << id;
        }
      }
    }
  }
}

TEST(HeartPhantom, OpenVesselsReachTheBorder)
{
  HeartPhantomOptions options = OfResolution(80);
  options.open = true;
  const Phantom phantom = Make(options);
  const auto& grid = phantom.labels.grid;
  Id blood = 0;
  for (Id v = grid.Index(0, 0, grid.size[2] - 1); v < grid.Count(); ++v)
  {
    blood += phantom.labels.labels[v] == 2;
  }
  EXPECT_GT(blood, 100);
  EXPECT_EQ(phantom.report.materials[2].components, 4);
}

TEST(HeartPhantom, GreyValuesAreThoseAskedFor)
{
  HeartPhantomOptions options = OfResolution(64);
  options.noise = 0;
  options.bias = 0;
  const Phantom clean = Make(options);
  const auto range = std::minmax_element(clean.grey.values.begin(), clean.grey.values.end());
  EXPECT_EQ(*range.first, 20);
  EXPECT_EQ(*range.second, 190);
  options.noise = 12;
  const Phantom noisy = Make(options);
  double sum = 0;
  double squares = 0;
  Id count = 0;
  for (std::size_t v = 0; v < noisy.grey.values.size(); ++v)
  {
    if (clean.grey.values[v] == 85)
    {
      const double noise = noisy.grey.values[v] - 85;
      sum += noise;
      squares += noise * noise;
      ++count;
    }
  }
  ASSERT_GT(count, 1000);
  EXPECT_NEAR(sum / count, 0, 0.5);
  EXPECT_NEAR(std::sqrt(squares / count), 12, 0.5);
}

TEST(HeartPhantom, SameForAnyThreadsAndDifferentForAnotherSeed)
{
  HeartPhantomOptions options = OfResolution(64);
  const Phantom one = Make(options, 1);
  const Phantom three = Make(options, 3);
  EXPECT_EQ(one.grey.values, three.grey.values);
  EXPECT_EQ(one.labels.labels, three.labels.labels);
  options.seed = 2;
  const Phantom other = Make(options);
  EXPECT_EQ(one.labels.labels, other.labels.labels);
  EXPECT_NE(one.grey.values, other.grey.values);
}

TEST(HeartPhantom, RefusesOptionsOutOfRange)
{
  const auto refuses = [](auto change)
  {
    HeartPhantomOptions options;
    change(options);
    GreyImage grey;
    LabelImage labels;
    ThreadMonitor monitor;
    const auto report = MakeHeartPhantom(grey, labels, options, monitor);
    return !report && report.GetError().kind == Failure::InvalidOption;
  };
  EXPECT_TRUE(refuses([](HeartPhantomOptions& o) { o.resolution = 15; }));
  EXPECT_TRUE(refuses([](HeartPhantomOptions& o) { o.resolution = 513; }));
  EXPECT_TRUE(refuses([](HeartPhantomOptions& o) { o.length = 0; }));
  EXPECT_TRUE(refuses([](HeartPhantomOptions& o) { o.noise = -1; }));
  EXPECT_TRUE(refuses([](HeartPhantomOptions& o) { o.blur = 9; }));
  EXPECT_TRUE(refuses([](HeartPhantomOptions& o) { o.bias = 2; }));
  EXPECT_TRUE(refuses([](HeartPhantomOptions& o) { o.blood = 300; }));
}

TEST(HeartPhantom, StopsOnRequest)
{
  ThreadMonitor monitor;
  monitor.Cancel();
  GreyImage grey;
  LabelImage labels;
  const auto report = MakeHeartPhantom(grey, labels, OfResolution(32), monitor);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.GetError().kind, Failure::Cancelled);
}
