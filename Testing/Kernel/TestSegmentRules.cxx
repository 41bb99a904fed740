// SPDX-License-Identifier: BSD-3-Clause
// Each rule of the segmentation alone, on images made by hand.
#include "GreyImages.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace lamina;
using namespace lamina::greys;

namespace
{

/// Air (100), dentine (700) and enamel (1300) with partial volume at the borders.
constexpr double Air = 100;
constexpr double Dentine = 700;
constexpr double Enamel = 1300;

SegmentOptions ToothOptions()
{
  SegmentOptions options;
  options.thresholds = { 400, 1000 };
  options.forbidden.clear();
  return options;
}

/// A block of enamel in air; the voxels of its first layer are half air, half enamel, and look like dentine.
/// Below it a block of dentine.
GreyImage Tooth()
{
  GreyImage image = Cube(24, Air);
  Fill(image, { 4, 4, 4 }, { 19, 19, 9 }, Dentine);
  Fill(image, { 4, 4, 10 }, { 19, 19, 19 }, 0.5 * (Air + Enamel) + 60);
  Fill(image, { 5, 5, 10 }, { 18, 18, 18 }, Enamel);
  return image;
}

/// Nothing is too small to stay, and nothing is repaired.
SegmentOptions Bare()
{
  SegmentOptions options;
  options.minimumVoxels = 0;
  options.minimumShare = 0;
  options.repair = TopologyRepair::Off;
  return options;
}

} // namespace

TEST(SegmentSkins, AShellOfPartialVolumeGoesToItsNeighbours)
{
  SegmentOptions options = ToothOptions();
  const Outcome outcome = Segmented(Tooth(), options);
  ASSERT_EQ(outcome.error, "");
  EXPECT_EQ(outcome.At(12, 12, 19), 2); // 760 is nearer to 1300 than to 100
  EXPECT_EQ(outcome.At(4, 12, 15), 2);
  EXPECT_EQ(outcome.At(12, 12, 6), 1) << "dentine itself stays";
  EXPECT_EQ(outcome.Rule("skin dissolved", 2), 16 * 16 * 10 - 14 * 14 * 9);
  EXPECT_EQ(outcome.Voxels(1), 16 * 16 * 6);
  options.dissolveSkins = false;
  EXPECT_EQ(Segmented(Tooth(), options).At(12, 12, 19), 1);
}

TEST(SegmentSkins, TheNearerOfTheTwoIsByGreyValue)
{
  GreyImage image = Tooth();
  Fill(image, { 5, 5, 19 }, { 18, 18, 19 }, 600); // nearer to air
  const Outcome outcome = Segmented(image, ToothOptions());
  EXPECT_EQ(outcome.At(12, 12, 19), 0);
  EXPECT_EQ(outcome.At(4, 12, 15), 2);
}

TEST(SegmentSkins, AThinLayerOfTheMaterialItselfStays)
{
  // One and two voxels of true dentine on enamel: their values are those of the thick dentine.
  for (const Id thickness : { 1, 2 })
  {
    GreyImage image = Tooth();
    Fill(image, { 3, 3, 10 }, { 20, 20, 20 }, Air);
    Fill(image, { 4, 4, 10 }, { 19, 19, 20 }, Dentine);
    Fill(image, { 4 + thickness, 4 + thickness, 10 }, { 19 - thickness, 19 - thickness, 20 - thickness },
         Enamel);
    const Outcome outcome = Segmented(image, ToothOptions());
    EXPECT_EQ(outcome.At(12, 12, 20), 1) << thickness;
    EXPECT_EQ(outcome.At(4, 12, 15), 1) << thickness;
    EXPECT_LE(outcome.Rule("skin dissolved", 2), 0) << thickness;
    EXPECT_LE(outcome.Rule("skin dissolved", 0), 0) << thickness;
  }
}

TEST(SegmentSkins, NoneBetweenMaterialsThatMayNotTouch)
{
  SegmentOptions options = ToothOptions();
  options.forbidden = { { { 2, 0 } } };
  const Outcome outcome = Segmented(Tooth(), options);
  EXPECT_EQ(outcome.At(12, 12, 19), 1);
  EXPECT_EQ(outcome.Rule("skin dissolved", 2), -1);
  ASSERT_FALSE(outcome.report.warnings.empty());
  EXPECT_NE(outcome.report.warnings[0].find("look like partial volume between materials 0 and 2"),
            std::string::npos)
    << outcome.report.warnings[0];
}

TEST(SegmentSkins, NoWarningOfAFewBetweenMaterialsThatMayNotTouch)
{
  GreyImage image = Cube(24, Air);
  Fill(image, { 3, 3, 3 }, { 20, 20, 20 }, Dentine);
  Fill(image, { 6, 6, 6 }, { 17, 17, 19 }, Enamel);
  Fill(image, { 6, 6, 20 }, { 17, 17, 20 }, 0.5 * (Air + Enamel) + 60); // one side of six is thin
  SegmentOptions options = ToothOptions();
  options.forbidden = { { { 0, 2 } } };
  EXPECT_TRUE(Segmented(image, options).report.warnings.empty());
}

TEST(SegmentSkins, DisputedDecisionsAreNoSkins)
{
  // A layer of disputed voxels between tissue and blood, and contacts that are all allowed.
  GreyImage image = Cube(20, Other);
  Fill(image, { 4, 4, 4 }, { 15, 15, 15 }, 112);
  Fill(image, { 5, 5, 5 }, { 14, 14, 14 }, Lumen);
  SegmentOptions options;
  options.forbidden.clear();
  options.coronaryMajority = 27;
  const Outcome outcome = Segmented(image, options);
  EXPECT_EQ(outcome.At(4, 10, 10), 1);
  EXPECT_EQ(outcome.Rule("skin dissolved", 0), -1);
}

TEST(SegmentDisputed, LeftToAPersonIsTheNearestMean)
{
  GreyImage image = Heart();
  Fill(image, { 7, 7, 6 }, { 12, 12, 6 }, 145);
  Fill(image, { 7, 7, 13 }, { 12, 12, 13 }, 112);
  Fill(image, { 9, 9, 13 }, { 9, 9, 13 }, 140); // among tissue-like voxels, nearer to blood
  SegmentOptions options;
  options.coronaryMajority = 27;
  options.disputed = DisputedChoice::Person;
  const Outcome outcome = Segmented(image, options);
  EXPECT_EQ(outcome.At(9, 9, 6), 2);
  EXPECT_EQ(outcome.At(8, 8, 13), 1);
  EXPECT_EQ(outcome.At(9, 9, 13), 2);
  EXPECT_EQ(outcome.report.disputed, 72);
  EXPECT_EQ(outcome.Rule("disputed, left to a person", 2), 37);
  EXPECT_TRUE(outcome.flags[outcome.labels.grid.Index(9, 9, 13)] & FlagDisputed);
}

TEST(SegmentDisputed, TheWalkListensToNeighboursWhereGreyValuesAreUndecided)
{
  // Two patches of the value in the middle, one with blood on five sides, one with tissue. Corners of the
  // image keep the groups from being enclosed.
  const double middle = 0.5 * (Muscle + Lumen);
  GreyImage image = Cube(20, Muscle);
  Fill(image, { 0, 0, 0 }, { 9, 19, 19 }, Lumen);
  Fill(image, { 0, 0, 0 }, { 0, 19, 19 }, Other);
  Fill(image, { 9, 10, 10 }, { 9, 10, 10 }, middle);
  Fill(image, { 10, 4, 4 }, { 10, 4, 4 }, middle);
  SegmentOptions options = Bare();
  options.coronaryMajority = 27;
  options.openAtImageBorder = true;
  const Outcome outcome = Segmented(image, options);
  EXPECT_EQ(outcome.At(9, 10, 10), 2);
  EXPECT_EQ(outcome.At(10, 4, 4), 1);
  EXPECT_EQ(outcome.report.disputed, 2);
}

TEST(SegmentDisputed, LongVoxelEdgesBindLess)
{
  // A voxel of the middle value between blood above and below and tissue around it in its plane: with voxels
  // four times as high the plane has the say, with flat ones the column.
  const double middle = 0.5 * (Muscle + Lumen);
  for (const double height : { 4.0, 0.25 })
  {
    GreyImage image = Cube(21, Muscle);
    image.grid.spacing = { 1, 1, height };
    Fill(image, { 10, 10, 4 }, { 10, 10, 9 }, Lumen);
    Fill(image, { 10, 10, 11 }, { 10, 10, 16 }, Lumen);
    Fill(image, { 0, 0, 0 }, { 20, 20, 0 }, Other);
    // The column's ends are bodies of blood, so that blood has a mean of its own.
    Fill(image, { 8, 8, 4 }, { 12, 12, 8 }, Lumen);
    Fill(image, { 8, 8, 12 }, { 12, 12, 16 }, Lumen);
    Fill(image, { 10, 10, 10 }, { 10, 10, 10 }, middle);
    SegmentOptions options = Bare();
    options.coronaryMajority = 27;
    EXPECT_EQ(Segmented(image, options).At(10, 10, 10), height > 1 ? 1 : 2) << height;
  }
}

TEST(SegmentIslands, TheLargestFewStay)
{
  GreyImage image = Cube(40, Other);
  Fill(image, { 3, 3, 3 }, { 36, 36, 36 }, Muscle);
  Fill(image, { 6, 6, 6 }, { 13, 13, 13 }, Lumen);
  Fill(image, { 6, 6, 20 }, { 12, 12, 26 }, Lumen);
  Fill(image, { 20, 6, 6 }, { 25, 11, 11 }, Lumen);
  SegmentOptions options;
  EXPECT_EQ(Segmented(image, options).Of(2).b0, 3);
  options.kept = KeptComponents::LargestFew;
  for (const Id count : { 1, 2, 3, 4 })
  {
    options.keptCount = count;
    const Outcome outcome = Segmented(image, options);
    EXPECT_EQ(outcome.Of(2).b0, std::min<Id>(count, 3));
    EXPECT_EQ(outcome.At(8, 8, 8), 2);
    EXPECT_EQ(outcome.At(8, 8, 22), count >= 2 ? 2 : 1);
    EXPECT_EQ(outcome.At(22, 8, 8), count >= 3 ? 2 : 1);
  }
  options.keptCount = 0;
  EXPECT_TRUE(Contains(Segmented(image, options).error, "must be at least 1"));
}

TEST(SegmentIslands, GoWhereMostFacesAreAndBringNoForbiddenContact)
{
  // A plate of class 1 between classes 0 and 2 that may not touch: too small to stay, yet it has to.
  GreyImage image = Cube(12, 10);
  Fill(image, { 0, 0, 6 }, { 11, 11, 11 }, 50);
  Fill(image, { 0, 0, 6 }, { 11, 11, 6 }, 30);
  SegmentOptions options;
  options.thresholds = { 20, 40, 60, 80 };
  Fill(image, { 1, 1, 9 }, { 10, 10, 9 }, 90);
  options.minimumVoxels = 200;
  options.minimumShare = 0;
  options.repair = TopologyRepair::Off;
  options.dissolveSkins = false;
  EXPECT_NE(Segmented(image, options).At(6, 6, 6), 1);
  options.forbidden = { { { 2, 0 } } };
  EXPECT_EQ(Segmented(image, options).At(6, 6, 6), 1);
}

TEST(SegmentRepair, CriticalContactsGoAreFlaggedOrStay)
{
  GreyImage image = Heart();
  // Two boxes of blood that meet in an edge only.
  Fill(image, { 7, 7, 7 }, { 12, 12, 12 }, Muscle);
  Fill(image, { 6, 6, 6 }, { 9, 9, 12 }, Lumen);
  Fill(image, { 10, 10, 6 }, { 13, 13, 12 }, Lumen);
  SegmentOptions options;
  const Outcome repaired = Segmented(image, options);
  EXPECT_EQ(repaired.report.topology.criticalEdges, 7);
  EXPECT_GT(repaired.report.topology.changed, 0);
  EXPECT_EQ(repaired.report.topology.remaining, 0);
  Id flagged = std::count_if(repaired.flags.begin(), repaired.flags.end(),
                             [](unsigned char f) { return (f & FlagRepaired) != 0; });
  EXPECT_EQ(flagged, repaired.report.topology.changed);
  options.repair = TopologyRepair::FlagOnly;
  const Outcome only = Segmented(image, options);
  EXPECT_EQ(only.At(9, 9, 9), 2);
  EXPECT_EQ(only.At(10, 9, 9), 1);
  EXPECT_TRUE(only.flags[only.labels.grid.Index(9, 9, 9)] & FlagFault);
  EXPECT_EQ(only.flags[only.labels.grid.Index(5, 5, 5)], 0);
  options.repair = TopologyRepair::Off;
  const Outcome off = Segmented(image, options);
  EXPECT_EQ(off.labels.labels, only.labels.labels);
  EXPECT_EQ(std::count(off.flags.begin(), off.flags.end(), 0), off.labels.grid.Count());
}

TEST(SegmentRepair, ForbiddenPairsOfAnyClassesAreParted)
{
  GreyImage image = Cube(20, 10);
  Fill(image, { 5, 5, 5 }, { 14, 14, 14 }, 90);  // class 4
  Fill(image, { 5, 5, 15 }, { 14, 14, 17 }, 70); // class 3
  SegmentOptions options;
  options.thresholds = { 20, 40, 60, 80 };
  Fill(image, { 0, 0, 0 }, { 4, 4, 4 }, 30);
  Fill(image, { 0, 0, 15 }, { 4, 4, 19 }, 50);
  options.dissolveSkins = false;
  options.forbidden = { { { 4, 0 } } };
  const Outcome outcome = Segmented(image, options);
  ASSERT_EQ(outcome.error, "");
  EXPECT_GT(outcome.report.topology.forbiddenContacts, 0);
  EXPECT_EQ(outcome.report.topology.remaining, 0);
  const auto& grid = outcome.labels.grid;
  for (Id v = 0; v < grid.Count(); ++v)
  {
    const Id i = v % 20;
    const Id j = v / 20 % 20;
    const Id k = v / 400;
    if (outcome.labels.labels[v] == 4)
    {
      for (int n = 0; n < 27; ++n)
      {
        ASSERT_NE(outcome.At(i + n % 3 - 1, j + n / 3 % 3 - 1, k + n / 9 - 1), 0);
      }
    }
  }
}

TEST(SegmentContacts, AllowedBloodNeedsNoWall)
{
  GreyImage image = Cube(20, Other);
  Fill(image, { 5, 5, 5 }, { 12, 12, 12 }, Lumen);
  Fill(image, { 1, 1, 1 }, { 2, 18, 18 }, Muscle);
  SegmentOptions options;
  options.forbidden.clear();
  const Outcome outcome = Segmented(image, options);
  EXPECT_EQ(outcome.Voxels(2), 8 * 8 * 8);
  EXPECT_EQ(outcome.At(4, 8, 8), 0);
}

TEST(SegmentReport, TellsWhichRuleTookTheLastOfAMaterial)
{
  GreyImage image = Cube(20, Other);
  Fill(image, { 4, 4, 4 }, { 15, 15, 15 }, Muscle);
  Fill(image, { 9, 9, 9 }, { 10, 10, 10 }, Lumen);
  const Outcome outcome = Segmented(image);
  ASSERT_EQ(outcome.error, "");
  ASSERT_EQ(outcome.report.warnings.size(), 1u);
  EXPECT_TRUE(
    Contains(outcome.report.warnings[0],
             "material 2 vanished: its last 8 voxels went by the rule \"island given to its neighbour\""));
}

TEST(SegmentReport, TellsOfClassesThatWereNeverThere)
{
  SegmentOptions options;
  options.thresholds = { 50, 60, 150, 170 };
  const Outcome outcome = Segmented(Heart(), options);
  ASSERT_EQ(outcome.error, "");
  ASSERT_EQ(outcome.report.warnings.size(), 2u);
  EXPECT_TRUE(Contains(outcome.report.warnings[0], "material 1 has no voxel between its thresholds"));
  EXPECT_TRUE(Contains(outcome.report.warnings[1], "material 3 has no voxel"));
}

TEST(SegmentClasses, ThereMayBeVeryMany)
{
  GreyImage image = Cube(20, 0);
  for (std::size_t v = 0; v < image.values.size(); ++v)
  {
    image.values[v] = static_cast<double>(v / 8);
  }
  SegmentOptions options = Bare();
  options.dissolveSkins = false;
  options.thresholds.clear();
  for (int t = 1; t < 1000; ++t)
  {
    options.thresholds.push_back(t);
  }
  const Outcome outcome = Segmented(image, options);
  ASSERT_EQ(outcome.error, "");
  EXPECT_EQ(outcome.report.after.size(), 1000u);
  for (std::size_t v = 0; v < image.values.size(); ++v)
  {
    ASSERT_EQ(outcome.labels.labels[v], static_cast<int>(v / 8));
  }
  options.thresholds.clear();
  for (int t = 1; t <= 65536; ++t)
  {
    options.thresholds.push_back(t * 0.01);
  }
  EXPECT_TRUE(
    Contains(Segmented(image, options).error, "65536 thresholds would make materials beyond 65535"));
}

TEST(SegmentReport, BettiNumbersBeforeAndAfter)
{
  GreyImage image = Heart();
  Fill(image, { 1, 1, 1 }, { 1, 1, 1 }, Muscle);
  const Outcome outcome = Segmented(image);
  ASSERT_EQ(outcome.report.before.size(), 3u);
  EXPECT_EQ(outcome.report.before[1].b0, 2);
  EXPECT_EQ(outcome.report.before[1].voxels, 14 * 14 * 14 - 6 * 6 * 6 + 1);
  EXPECT_EQ(outcome.Of(1).b0, 1);
  EXPECT_EQ(outcome.Of(1).b1, 0);
  EXPECT_EQ(outcome.Of(1).b2, 1);
  EXPECT_EQ(outcome.Of(0).b2, 1);
}

TEST(SegmentMonitor, StopsOnRequest)
{
  LabelImage labels;
  std::vector<unsigned char> flags;
  ThreadMonitor monitor(2);
  monitor.Cancel();
  const auto report = Segment(Heart(), labels, flags, {}, monitor);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.GetError().kind, Failure::Cancelled);
}

TEST(SegmentView, ValuesAreReadWhereTheyLie)
{
  const GreyImage image = Heart();
  const Outcome expected = Segmented(image);
  std::vector<short> values(image.values.begin(), image.values.end());
  LabelImage labels;
  std::vector<unsigned char> flags;
  ThreadMonitor monitor(2);
  const GreyView view(image.grid, values.data(), static_cast<Id>(values.size()));
  ASSERT_TRUE(Segment(view, labels, flags, {}, monitor));
  EXPECT_EQ(labels.labels, expected.labels.labels);
  EXPECT_EQ(view.At(image.grid.Index(8, 8, 8)), Lumen);
}
