// SPDX-License-Identifier: BSD-3-Clause
// Thresholds that nobody gave: by the grey values that fill places of the image.
#include "GreyImages.h"
#include "PhantomScores.h"
#include "Segmentation/FlatModes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace lamina;
using namespace lamina::greys;

namespace
{

constexpr Id Side = 64;

/// The material of each voxel of a ball of blood, with a shell of tissue from `inner` of its radius on, that
/// is `share` of a cube.
std::vector<int> BallOf(double share, double inner)
{
  const double radius = std::cbrt(share * Side * Side * Side * 0.75 / std::acos(-1.0));
  std::vector<int> materials;
  for (Id v = 0; v < Side * Side * Side; ++v)
  {
    const double middle = 0.5 * (Side - 1);
    const double r = std::hypot(v % Side - middle, v / Side % Side - middle, v / (Side * Side) - middle);
    materials.push_back(r >= radius ? 0 : (r >= inner * radius ? 1 : 2));
  }
  return materials;
}

GreyImage GreyOf(const std::vector<int>& materials, double noise)
{
  GreyImage image = Cube(Side, Other);
  for (std::size_t v = 0; v < materials.size(); ++v)
  {
    image.values[v] = materials[v] == 0 ? Other : (materials[v] == 1 ? Muscle : Lumen);
  }
  AddNoise(image, noise);
  return image;
}

Outcome ByItself(const GreyImage& image, int threads = 2)
{
  SegmentOptions options;
  options.thresholds.clear();
  return Segmented(image, options, threads);
}

/// Thresholds near those of 20, 85 and 190.
void ExpectThree(const Outcome& found, double offset = 0, double scale = 1)
{
  ASSERT_EQ(found.error, "");
  ASSERT_EQ(found.report.thresholds.size(), 3u);
  EXPECT_NEAR((found.report.thresholds[0] - offset) / scale, 50.6, 3);
  EXPECT_NEAR((found.report.thresholds[1] - offset) / scale, 127, 4);
  EXPECT_NEAR((found.report.thresholds[2] - offset) / scale, 148, 4);
}

Id Wrong(const Outcome& found, const std::vector<int>& truth)
{
  Id wrong = 0;
  for (std::size_t v = 0; v < truth.size(); ++v)
  {
    wrong += found.labels.labels[v] != truth[v];
  }
  return wrong;
}

} // namespace

TEST(FlatModes, OfThirds)
{
  for (const double noise : { 0.0, 5.0, 12.0, 20.0 })
  {
    SCOPED_TRACE(noise);
    const Outcome found = ByItself(Thirds(noise));
    ExpectThree(found);
    ASSERT_EQ(found.report.modes.size(), 3u);
    EXPECT_NEAR(found.report.modes[1], 85, 3);
  }
  ExpectThree(ByItself(Thirds(8, 10, -3000)), -3000, 10);
}

TEST(FlatModes, OfSmallThingsInNoise)
{
  for (const double share : { 0.02, 0.04, 0.08 })
  {
    for (const double noise : { 8.0, 12.0, 20.0 })
    {
      SCOPED_TRACE(testing::Message() << share << " " << noise);
      const std::vector<int> truth = BallOf(share, 0.75);
      const GreyImage grey = GreyOf(truth, noise);
      const Outcome found = ByItself(grey);
      ExpectThree(found);
      const Id wrong = Wrong(found, truth);
      const Id ofFixed = Wrong(Segmented(grey, {}, 2), truth);
      EXPECT_LT(wrong, 0.002 * static_cast<double>(truth.size()));
      EXPECT_LE(wrong, 1.02 * static_cast<double>(ofFixed) + 20);
      RecordProperty("wrong", std::to_string(wrong) + " of fixed " + std::to_string(ofFixed));
    }
  }
}

TEST(FlatModes, OfTwoMaterialsMakeTwo)
{
  for (const double share : { 0.02, 0.08, 0.3 })
  {
    SCOPED_TRACE(share);
    const std::vector<int> truth = BallOf(share, 0);
    const Outcome found = ByItself(GreyOf(truth, 20));
    ASSERT_EQ(found.error, "");
    ASSERT_EQ(found.report.thresholds.size(), 1u);
    EXPECT_NEAR(found.report.thresholds[0], 50.6, 2);
    ASSERT_EQ(found.report.warnings.size(), 1u);
    EXPECT_TRUE(Contains(found.report.warnings[0], "one material")) << found.report.warnings[0];
    EXPECT_LT(Wrong(found, truth), 0.001 * static_cast<double>(truth.size()));
  }
}

TEST(FlatModes, OfMoreThanThreeTakeTheUpperTwoForTissueAndBlood)
{
  GreyImage image = Thirds(0);
  Fill(image, { 0, 0, 0 }, { 4, 29, 29 }, -300);
  AddNoise(image, 6);
  const Outcome found = ByItself(image);
  EXPECT_EQ(found.report.modes.size(), 4u);
  ExpectThree(found);
}

TEST(FlatModes, OfOneKindOfPlaceFallBackAndWarn)
{
  GreyImage image = Cube(24, 100);
  AddNoise(image, 5);
  ThreadMonitor monitor(2);
  const std::vector<double> modes = FlatModes(image, 70, 130, monitor);
  EXPECT_LT(modes.size(), 2u);
  EXPECT_TRUE(ModeThresholds(modes).empty());
  SegmentOptions options;
  options.thresholds.clear();
  options.smoothingSweeps = 0;
  options.minimumVoxels = 0;
  options.minimumShare = 0;
  const Outcome found = Segmented(image, options);
  ASSERT_EQ(found.error, "");
  EXPECT_EQ(found.report.thresholds.size(), 2u);
  ASSERT_FALSE(found.report.warnings.empty());
  EXPECT_TRUE(Contains(found.report.warnings[0], "but one peak")) << found.report.warnings[0];
}

TEST(FlatModes, AreNotLedAstrayByAFewFarValuesAndNaN)
{
  GreyImage image = Thirds(8);
  for (std::size_t v = 0; v < 20; ++v)
  {
    image.values[1300 * v] = v % 2 == 0 ? 20000 : -20000;
    image.values[1300 * v + 7] = std::numeric_limits<double>::quiet_NaN();
  }
  ExpectThree(ByItself(image));
}

TEST(FlatModes, AreTheSameForAnyNumberOfThreadsAndAsIfGiven)
{
  const GreyImage image = Thirds(12);
  const Outcome one = ByItself(image, 1);
  const Outcome three = ByItself(image, 3);
  EXPECT_EQ(one.report.thresholds, three.report.thresholds);
  EXPECT_EQ(one.labels.labels, three.labels.labels);
  SegmentOptions given;
  given.thresholds = one.report.thresholds;
  EXPECT_EQ(Segmented(image, given).labels.labels, one.labels.labels);
}

TEST(FlatModes, AreSuggestedWhereThoseGivenDoNotFit)
{
  const Outcome found = Segmented(Thirds(5, 10, -3000));
  EXPECT_TRUE(Contains(found.error, "its histogram suggests -24")) << found.error;
}

TEST(FlatModes, OfPhantomsDoNoWorseThanThePapersThresholds)
{
  for (const int resolution : { 26, 40, 60 })
  {
    for (const double noise : { 8.0, 12.0, 20.0 })
    {
      SCOPED_TRACE(testing::Message() << resolution << " " << noise);
      HeartPhantomOptions options;
      options.resolution = resolution;
      options.noise = noise;
      scores::Phantom phantom;
      ThreadMonitor monitor(2);
      ASSERT_TRUE(MakeHeartPhantom(phantom.grey, phantom.truth, options, monitor));
      const Outcome found = ByItself(phantom.grey);
      const Outcome fixed = Segmented(phantom.grey, {}, 2);
      const Id wrong = Wrong(found, phantom.truth.labels);
      const Id ofFixed = Wrong(fixed, phantom.truth.labels);
      const auto topology = [](const Outcome& outcome)
      {
        std::string text;
        for (int m = 0; m < 3; ++m)
        {
          const BettiNumbers b = outcome.Of(m);
          text += std::to_string(b.b0) + "/" + std::to_string(b.b1) + "/" + std::to_string(b.b2) + " ";
        }
        return text;
      };
      EXPECT_EQ(topology(found), topology(fixed));
      EXPECT_LE(wrong, ofFixed);
    }
  }
}
