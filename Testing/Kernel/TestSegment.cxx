// SPDX-License-Identifier: BSD-3-Clause
#include "GreyImages.h"
#include "Segmentation/ConnectedComponents.h"
#include "Segmentation/MendContacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

using namespace lamina;
using namespace lamina::greys;

TEST(Components, FacesAndCornersDiffer)
{
  const std::array<Id, 3> size{ 3, 3, 3 };
  std::vector<int> labels(27, 0);
  labels[0] = labels[13] = labels[26] = 1; // a diagonal through the cube
  ThreadMonitor monitor;
  EXPECT_EQ(FindComponents(labels, size, Connectivity::Faces, monitor).CountOf(1), 3);
  EXPECT_EQ(FindComponents(labels, size, Connectivity::Corners, monitor).CountOf(1), 1);
}

TEST(Components, AgreeWithFloodFillOnRandomImages)
{
  std::mt19937 random(7);
  const std::array<Id, 3> size{ 13, 11, 9 };
  for (int round = 0; round < 20; ++round)
  {
    std::vector<int> labels(13 * 11 * 9);
    for (int& label : labels)
    {
      label = static_cast<int>(random() % 3);
    }
    for (const auto connectivity : { Connectivity::Faces, Connectivity::Corners })
    {
      const int most = connectivity == Connectivity::Faces ? 1 : 3;
      std::vector<bool> seen(labels.size(), false);
      Id expected = 0;
      for (std::size_t start = 0; start < labels.size(); ++start)
      {
        if (seen[start])
        {
          continue;
        }
        ++expected;
        std::vector<Id> stack{ static_cast<Id>(start) };
        seen[start] = true;
        while (!stack.empty())
        {
          const Id v = stack.back();
          stack.pop_back();
          for (int n = 0; n < 27; ++n)
          {
            const Id d[3] = { n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1 };
            const Id p[3] = { v % 13 + d[0], v / 13 % 11 + d[1], v / 143 + d[2] };
            const Id w = p[0] + 13 * (p[1] + 11 * p[2]);
            const bool in = p[0] >= 0 && p[1] >= 0 && p[2] >= 0 && p[0] < 13 && p[1] < 11 && p[2] < 9;
            if (in && std::abs(d[0]) + std::abs(d[1]) + std::abs(d[2]) <= most && !seen[w] &&
                labels[w] == labels[start])
            {
              seen[w] = true;
              stack.push_back(w);
            }
          }
        }
      }
      ThreadMonitor monitor(2);
      const ComponentMap map = FindComponents(labels, size, connectivity, monitor);
      EXPECT_EQ(static_cast<Id>(map.components.size()), expected);
    }
  }
}

TEST(MendContacts, EdgesAndCornersAreFilled)
{
  LabelImage image;
  image.grid.size = { 4, 4, 4 };
  for (const Id other : { 1, 1 + 4, 1 + 4 + 16 })
  {
    image.labels.assign(64, 1);
    image.labels[21] = 2;
    image.labels[21 + other] = 2;
    const bool faces = other == 1;
    EXPECT_EQ(CountContacts(image) == 0, faces);
    EXPECT_EQ(MendContacts(image, 1) == 0, faces);
    EXPECT_EQ(CountContacts(image), 0);
  }
}

TEST(Segment, ThreeMaterialsComeOut)
{
  const Outcome outcome = Segmented(Heart());
  ASSERT_EQ(outcome.error, "");
  EXPECT_EQ(outcome.Voxels(2), 6 * 6 * 6);
  EXPECT_EQ(outcome.Voxels(1), 14 * 14 * 14 - 6 * 6 * 6);
  EXPECT_EQ(outcome.report.after.size(), 3u);
  EXPECT_EQ(outcome.report.disputed, 0);
}

TEST(Segment, TwoThresholdsLeaveNothingDisputed)
{
  SegmentOptions options;
  options.thresholds = { 50, 150 };
  GreyImage image = Heart();
  Fill(image, { 7, 7, 6 }, { 12, 12, 6 }, Between);
  const Outcome outcome = Segmented(image, options);
  EXPECT_EQ(outcome.Voxels(2), 6 * 6 * 6);
  EXPECT_EQ(outcome.report.disputed, 0);
}

TEST(Segment, OtherNumbersOfThresholdsMakeClassesInOrder)
{
  GreyImage image = Heart();
  SegmentOptions options;
  options.thresholds = { 50 };
  EXPECT_EQ(Segmented(image, options).Voxels(1), 14 * 14 * 14);
  options.thresholds = { 30, 50, 100, 180 };
  const Outcome outcome = Segmented(image, options);
  EXPECT_EQ(outcome.Voxels(2), 14 * 14 * 14 - 6 * 6 * 6);
  EXPECT_EQ(outcome.Voxels(4), 6 * 6 * 6);
}

TEST(Segment, EnclosedDisputedVoxelsTakeWhatSurroundsThem)
{
  GreyImage image = Heart();
  Fill(image, { 4, 4, 4 }, { 5, 5, 5 }, Between);    // in tissue
  Fill(image, { 9, 9, 9 }, { 10, 10, 10 }, Between); // in blood
  const Outcome outcome = Segmented(image);
  EXPECT_EQ(outcome.At(4, 4, 4), 1);
  EXPECT_EQ(outcome.At(10, 10, 10), 2);
  EXPECT_EQ(outcome.Rule("disputed, enclosed by one material", 1), 8);
  EXPECT_EQ(outcome.Rule("disputed, enclosed by one material", 2), 8);
  EXPECT_EQ(outcome.report.disputed, 0);
}

TEST(Segment, DisputedVoxelsAmongTissueAreAThinVessel)
{
  GreyImage image = Heart();
  // A line that starts in the blood: not enclosed, and each voxel has far more than 14 tissue neighbours.
  Fill(image, { 9, 9, 13 }, { 9, 9, 14 }, Between);
  const Outcome outcome = Segmented(image);
  EXPECT_EQ(outcome.At(9, 9, 14), 2);
  EXPECT_GE(outcome.Rule("disputed, thin vessel in tissue", 2), 1);
  SegmentOptions off;
  off.coronaryMajority = 27;
  EXPECT_EQ(Segmented(image, off).At(9, 9, 14), 1);
}

TEST(Segment, TheRestGoesToTheLikelierAndIsFlagged)
{
  GreyImage image = Heart();
  Fill(image, { 7, 7, 6 }, { 12, 12, 6 }, 145);   // near blood
  Fill(image, { 7, 7, 13 }, { 12, 12, 13 }, 112); // near tissue
  SegmentOptions options;
  options.coronaryMajority = 27;
  const Outcome outcome = Segmented(image, options);
  EXPECT_EQ(outcome.At(9, 9, 6), 2);
  EXPECT_EQ(outcome.At(9, 9, 13), 1);
  EXPECT_EQ(outcome.report.disputed, 72);
  EXPECT_EQ(outcome.flags[outcome.labels.grid.Index(9, 9, 13)], 1);
  EXPECT_EQ(outcome.flags[0], 0);
}

TEST(Segment, BackgroundThatTouchesBloodBecomesTissue)
{
  GreyImage image = Cube(20, Other);
  Fill(image, { 5, 5, 5 }, { 12, 12, 12 }, Lumen);
  Fill(image, { 1, 1, 1 }, { 2, 18, 18 }, Muscle);
  const Outcome outcome = Segmented(image);
  EXPECT_EQ(outcome.Rule("background that touches blood", 1), 10 * 10 * 10 - 8 * 8 * 8);
  EXPECT_EQ(outcome.At(4, 4, 4), 1);
  EXPECT_EQ(outcome.At(3, 4, 4), 0);
}

TEST(Segment, BloodAtTheBorderIsClosedUnlessOpen)
{
  GreyImage image = Heart();
  Fill(image, { 8, 8, 7 }, { 11, 11, 19 }, Lumen);
  Fill(image, { 5, 5, 17 }, { 14, 14, 19 }, Muscle);
  Fill(image, { 8, 8, 17 }, { 11, 11, 19 }, Lumen);
  const Outcome closed = Segmented(image);
  EXPECT_EQ(closed.At(9, 9, 19), 1);
  EXPECT_EQ(closed.At(9, 9, 18), 2);
  EXPECT_EQ(closed.Rule("blood at the image's border, closed", 1), 16);
  SegmentOptions options;
  options.openAtImageBorder = true;
  EXPECT_EQ(Segmented(image, options).At(9, 9, 19), 2);
}

TEST(Segment, TheMaskRulesAndItsEdgeIsClosedUnlessOpen)
{
  const GreyImage image = Heart();
  RegionMask mask;
  mask.grid = image.grid;
  mask.inside.assign(image.values.size(), 1);
  for (Id v = 0; v < image.grid.Count(); ++v)
  {
    if (v / 400 >= 10)
    {
      mask.inside[v] = 0;
    }
  }
  SegmentOptions options;
  options.mask = &mask;
  const Outcome closed = Segmented(image, options);
  EXPECT_EQ(closed.At(9, 9, 10), 0);
  EXPECT_EQ(closed.At(9, 9, 9), 1);
  EXPECT_EQ(closed.At(9, 9, 8), 2);
  EXPECT_EQ(closed.Rule("blood at the mask's edge, closed", 1), 36);
  options.openAtMaskBorder = true;
  const Outcome open = Segmented(image, options);
  EXPECT_EQ(open.At(9, 9, 10), 0);
  EXPECT_EQ(open.At(9, 9, 9), 2);
}

TEST(Segment, BackgroundAtAnOpenEndSettles)
{
  // Specks of background in blood at the mask's edge: tissue would be made of them and thrown out again for
  // ever.
  GreyImage image = Cube(20, Lumen);
  Fill(image, { 0, 0, 0 }, { 19, 19, 2 }, Other);
  RegionMask mask;
  mask.grid = image.grid;
  mask.inside.assign(image.values.size(), 1);
  std::fill(mask.inside.begin() + 400 * 12, mask.inside.end(), 0);
  Fill(image, { 9, 9, 11 }, { 9, 9, 11 }, Other);
  Fill(image, { 5, 5, 11 }, { 6, 5, 11 }, Muscle);
  SegmentOptions options;
  options.mask = &mask;
  options.openAtMaskBorder = true;
  options.openAtImageBorder = true;
  const Outcome outcome = Segmented(image, options);
  EXPECT_EQ(outcome.error, "");
  EXPECT_LT(outcome.report.passes, 5);
  EXPECT_EQ(outcome.At(9, 9, 11), 2);
  EXPECT_EQ(outcome.At(5, 5, 11), 2);
  EXPECT_EQ(outcome.At(9, 9, 2), 1);
  EXPECT_EQ(outcome.Of(1).b0, 1);
}

TEST(Segment, BloodStaysAtTheOpenEdgeOfARaggedMask)
{
  // The edge of the mask touches itself over edges and corners, where only background can be frozen, and
  // blood may not touch it: a repair there must not eat its way through the blood.
  GreyImage image = Cube(24, Lumen);
  Fill(image, { 0, 0, 0 }, { 23, 23, 2 }, Other);
  Fill(image, { 0, 0, 3 }, { 23, 23, 5 }, Muscle);
  RegionMask mask;
  mask.grid = image.grid;
  mask.inside.assign(image.values.size(), 1);
  std::mt19937 random(3);
  for (Id v = 0; v < image.grid.Count(); ++v)
  {
    const Id k = v / (24 * 24);
    mask.inside[v] = k < 15 || (k < 18 && random() % 2 == 0) ? 1 : 0;
  }
  SegmentOptions options;
  options.mask = &mask;
  options.openAtMaskBorder = true;
  options.openAtImageBorder = true;
  const Outcome outcome = Segmented(image, options);
  ASSERT_EQ(outcome.error, "");
  EXPECT_EQ(outcome.report.topology.remaining, 0);
  EXPECT_EQ(outcome.At(12, 12, 12), 2);
  EXPECT_GE(outcome.Voxels(2), 24 * 24 * 9 - 100) << "what is no part of the ragged edge stays";
  EXPECT_EQ(outcome.Of(2).b0, 1);
  for (Id v = 0; v < image.grid.Count(); ++v)
  {
    EXPECT_TRUE(mask.inside[v] != 0 || outcome.labels.labels[v] == 0);
  }
}

TEST(Segment, IslandsGoToTheirNeighboursAndCavitiesAreFilled)
{
  GreyImage image = Heart();
  Fill(image, { 1, 1, 1 }, { 1, 1, 2 }, Muscle);      // tissue in background
  Fill(image, { 5, 5, 5 }, { 5, 5, 5 }, Lumen);       // blood in tissue
  Fill(image, { 9, 9, 9 }, { 9, 9, 9 }, Muscle);      // tissue in blood
  Fill(image, { 14, 14, 14 }, { 15, 15, 15 }, Other); // background in tissue
  const Outcome outcome = Segmented(image);
  EXPECT_EQ(outcome.At(1, 1, 1), 0);
  EXPECT_EQ(outcome.At(5, 5, 5), 1);
  EXPECT_EQ(outcome.At(9, 9, 9), 2);
  EXPECT_EQ(outcome.At(14, 14, 14), 1);
  EXPECT_EQ(outcome.Rule("enclosed background filled", 1), 8);
  for (const BettiNumbers& material : outcome.report.after)
  {
    EXPECT_EQ(material.b0, 1);
  }
}

TEST(Segment, LargeComponentsStayUnlessTheLargestAloneIsAsked)
{
  GreyImage image = Cube(30, Other);
  Fill(image, { 3, 3, 3 }, { 26, 26, 26 }, Muscle);
  Fill(image, { 6, 6, 6 }, { 13, 23, 23 }, Lumen);
  Fill(image, { 17, 6, 6 }, { 20, 9, 9 }, Lumen); // 64 voxels
  EXPECT_EQ(Segmented(image).Of(2).b0, 2);
  SegmentOptions options;
  options.kept = KeptComponents::Largest;
  EXPECT_EQ(Segmented(image, options).Of(2).b0, 1);
  options.kept = KeptComponents::All;
  options.minimumVoxels = 65;
  EXPECT_EQ(Segmented(image, options).Of(2).b0, 1);
  options.minimumVoxels = 0;
  options.minimumShare = 0.5;
  EXPECT_EQ(Segmented(image, options).Of(2).b0, 1);
}

TEST(Segment, NotANumberIsBackground)
{
  GreyImage image = Heart();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Fill(image, { 0, 0, 0 }, { 19, 19, 2 }, nan);
  const Outcome outcome = Segmented(image);
  EXPECT_EQ(outcome.error, "");
  EXPECT_EQ(outcome.At(5, 5, 1), 0);
  EXPECT_EQ(outcome.Voxels(2), 6 * 6 * 6);
}

TEST(Segment, SameForAnyThreads)
{
  std::mt19937 random(3);
  GreyImage image = Cube(40, 0);
  for (double& value : image.values)
  {
    value = random() % 256;
  }
  SegmentOptions options;
  options.minimumVoxels = 5;
  const Outcome one = Segmented(image, options, 1);
  const Outcome three = Segmented(image, options, 3);
  EXPECT_EQ(one.error, "");
  EXPECT_EQ(one.labels.labels, three.labels.labels);
  EXPECT_EQ(one.flags, three.flags);
}

TEST(Segment, BloodNeverTouchesBackgroundEvenInNoise)
{
  for (unsigned seed = 1; seed < 6; ++seed)
  {
    std::mt19937 random(seed);
    GreyImage image = Cube(24, 0);
    for (double& value : image.values)
    {
      value = random() % 256;
    }
    SegmentOptions options;
    options.minimumVoxels = 2;
    const Outcome outcome = Segmented(image, options);
    ASSERT_EQ(outcome.error, "");
    for (Id v = 0; v < image.grid.Count(); ++v)
    {
      const Id p[3] = { v % 24, v / 24 % 24, v / 576 };
      for (int n = 0; n < 27 && outcome.labels.labels[v] == 2; ++n)
      {
        const Id q[3] = { p[0] + n % 3 - 1, p[1] + n / 3 % 3 - 1, p[2] + n / 9 - 1 };
        ASSERT_GE(*std::min_element(q, q + 3), 0);
        ASSERT_LT(*std::max_element(q, q + 3), 24);
        ASSERT_NE(outcome.At(q[0], q[1], q[2]), 0);
      }
    }
  }
}

TEST(Segment, SaysWhatIsWrong)
{
  SegmentOptions options;
  EXPECT_TRUE(Contains(Segmented(GreyImage{}).error, "empty"));
  EXPECT_TRUE(Contains(Segmented(Cube(5, 7)).error, "constant: every voxel is 7"));
  EXPECT_TRUE(
    Contains(Segmented(Cube(5, std::numeric_limits<double>::quiet_NaN())).error, "no finite value"));
  GreyImage flat = Cube(4, 0);
  flat.grid.size = { 8, 8, 1 };
  EXPECT_TRUE(Contains(Segmented(flat).error, "not three-dimensional: 8 x 8 x 1"));
  options.thresholds = { 50, 150, 110 };
  EXPECT_TRUE(Contains(Segmented(Heart(), options).error, "out of order: 150 is not below 110"));
  options.thresholds = { 50, 110, 500 };
  EXPECT_TRUE(Contains(Segmented(Heart(), options).error, "500 is outside the image's range 20 to 190"));
  options = {};
  RegionMask mask;
  mask.grid.size = { 3, 3, 3 };
  mask.inside.assign(27, 1);
  options.mask = &mask;
  EXPECT_TRUE(
    Contains(Segmented(Heart(), options).error, "the mask has 3 x 3 x 3 voxels and the image 20 x 20 x 20"));
  mask.grid.size = { 20, 20, 20 };
  mask.inside.assign(8000, 0);
  EXPECT_TRUE(Contains(Segmented(Heart(), options).error, "1 nowhere"));
  options = {};
  options.minimumVoxels = 100000;
  EXPECT_TRUE(Contains(Segmented(Heart(), options).error, "nothing but background"));
  options.minimumVoxels = -1;
  EXPECT_TRUE(Contains(Segmented(Heart(), options).error, "least component"));
}
