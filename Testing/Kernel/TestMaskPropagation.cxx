// SPDX-License-Identifier: BSD-3-Clause
#include "Rods.h"

#include "Segmentation/HeartPhantom.h"

#include <limits>

using namespace lamina;
using namespace lamina::rods;

TEST(MaskPropagation, FollowsWhatMoves)
{
  const Case rod = Rod();
  const LabelImage mask = Drawn(rod.truth, 12);
  const double shape = Dice(Propagated(rod.grey, mask, By(1)).full, rod.truth);
  const double registration = Dice(Propagated(rod.grey, mask, By(2)).full, rod.truth);
  const Outcome automatic = Propagated(rod.grey, mask);
  EXPECT_LT(shape, 0.93);
  EXPECT_GT(registration, 0.95);
  EXPECT_GT(Dice(automatic.full, rod.truth), 0.985);
  EXPECT_GE(automatic.report.method, 2);
  EXPECT_GT(automatic.report.foretold[1], automatic.report.foretold[0]);
  EXPECT_GE(automatic.report.foretold[2], automatic.report.foretold[1] - 0.02);
  EXPECT_LT(automatic.report.residual, automatic.report.unregisteredResidual);
}

TEST(MaskPropagation, DrawnSlicesStay)
{
  const Case rod = Rod();
  // A border that no grey value shows, and a lone pixel.
  LabelImage mask = Drawn(rod.truth, 9);
  const auto& grid = mask.grid;
  for (Id x = 0; x < 9; ++x)
  {
    mask.labels[static_cast<std::size_t>(grid.Index(40 + x, 3, 9))] = 1;
  }
  mask.labels[static_cast<std::size_t>(grid.Index(2, 2, 18))] = 1;
  const Outcome outcome = Propagated(rod.grey, mask);
  EXPECT_EQ(outcome.report.drawn, (std::vector<Id>{ 0, 9, 18, 27, 36 }));
  const Id area = grid.size[0] * grid.size[1];
  for (const Id k : outcome.report.drawn)
  {
    for (Id v = k * area; v < (k + 1) * area; ++v)
    {
      ASSERT_EQ(outcome.full.labels[static_cast<std::size_t>(v)], mask.labels[static_cast<std::size_t>(v)]);
    }
  }
  EXPECT_EQ(outcome.report.slices.size(), 32U);
  EXPECT_EQ(outcome.report.slices[3].slice, 4);
  EXPECT_EQ(outcome.report.slices[3].from, 0);
  EXPECT_EQ(outcome.report.slices[3].to, 9);
  EXPECT_EQ(outcome.report.slices[3].voxels, outcome.Voxels(4));
}

TEST(MaskPropagation, AGreyImageThatSaysNothingDoesNotHarm)
{
  // An ellipsoid that no grey value shows, in texture that changes from slice to slice.
  Case hidden = Make({ { 60, 60, 49 } },
                     [](double x, double y, double z)
                     {
                       const double a = (x - 30) / 20;
                       const double b = (y - 30) / 15;
                       const double c = (z - 24) / 22;
                       return a * a + b * b + c * c < 1 ? 1 : 0;
                     });
  std::mt19937 random(5);
  for (double& value : hidden.grey.values)
  {
    value = static_cast<double>(random() % 1000);
  }
  const LabelImage mask = Drawn(hidden.truth, 6);
  const double shape = Dice(Propagated(hidden.grey, mask, By(1)).full, hidden.truth);
  const Outcome automatic = Propagated(hidden.grey, mask);
  EXPECT_GT(shape, 0.94);
  EXPECT_EQ(automatic.report.method, 1);
  EXPECT_DOUBLE_EQ(Dice(automatic.full, hidden.truth), shape);
}

TEST(MaskPropagation, AConstantImageInterpolatesShapes)
{
  Case rod = Rod();
  rod.grey.values.assign(rod.grey.values.size(), 7);
  const LabelImage mask = Drawn(rod.truth, 6);
  const Outcome outcome = Propagated(rod.grey, mask);
  ASSERT_EQ(outcome.report.warnings.size(), 1U);
  EXPECT_NE(outcome.report.warnings[0].find("constant"), std::string::npos);
  EXPECT_EQ(outcome.report.method, 1);
  EXPECT_GT(Dice(outcome.full, rod.truth), 0.93);
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  rod.grey.values.assign(rod.grey.values.size(), nothing);
  EXPECT_EQ(Propagated(rod.grey, mask).full.labels, outcome.full.labels);
}

TEST(MaskPropagation, Ends)
{
  // A ball: slices 8 to 32 have voxels.
  const Case ball =
    Make({ { 40, 40, 41 } }, [](double x, double y, double z)
         { return std::sqrt((x - 20) * (x - 20) + (y - 20) * (y - 20) + (z - 20) * (z - 20)) < 12.4; });
  const LabelImage mask = Drawn(ball.truth, 8, 4); // 12, 20, 28
  const Outcome automatic = Propagated(ball.grey, mask);
  EXPECT_GT(Dice(automatic.full, ball.truth), 0.98);
  EXPECT_EQ(automatic.Voxels(4), 0) << "would have been drawn";
  EXPECT_EQ(automatic.Voxels(36), 0);
  EXPECT_GT(automatic.Voxels(10), 0);
  MaskPropagationOptions options;
  options.maximumSlices = 0;
  const Outcome none = Propagated(ball.grey, mask, options);
  EXPECT_EQ(none.Voxels(11), 0);
  EXPECT_EQ(none.Voxels(29), 0);
  EXPECT_GT(none.Voxels(13), 0);
  options.maximumSlices = 2;
  const Outcome two = Propagated(ball.grey, mask, options);
  EXPECT_GT(two.Voxels(10), 0);
  EXPECT_EQ(two.Voxels(9), 0);
  options.maximumSlices = -1;
  options.drawnSlices = { 28, 4, 12, 20, 36, 36 };
  const Outcome listed = Propagated(ball.grey, mask, options);
  EXPECT_EQ(listed.report.drawn, (std::vector<Id>{ 4, 12, 20, 28, 36 }));
  EXPECT_GT(Dice(listed.full, ball.truth), 0.98);
  EXPECT_EQ(listed.Voxels(2), 0);
  // One slice is carried to all.
  const Outcome single = Propagated(ball.grey, Drawn(ball.truth, 100, 20));
  EXPECT_EQ(single.report.slices.size(), 40U);
  EXPECT_TRUE(std::isnan(single.report.foretold[2]));
  EXPECT_GT(single.Voxels(24), 0);
  // Two slices foretell each other.
  LabelImage pair = mask;
  std::fill(pair.labels.begin() + 20 * 1600, pair.labels.begin() + 21 * 1600, 0);
  EXPECT_FALSE(std::isnan(Propagated(ball.grey, pair).report.foretold[2]));
}

TEST(MaskPropagation, TheSameForAnyNumberOfThreads)
{
  const Case rod = Rod();
  const LabelImage mask = Drawn(rod.truth, 12, 3);
  const Outcome one = Propagated(rod.grey, mask, {}, 1);
  for (const int threads : { 2, 3, 5 })
  {
    const Outcome many = Propagated(rod.grey, mask, {}, threads);
    EXPECT_EQ(many.full.labels, one.full.labels) << threads;
    EXPECT_EQ(many.report.residual, one.report.residual) << threads;
    EXPECT_EQ(many.report.foretold, one.report.foretold) << threads;
  }
}

TEST(MaskPropagation, StopsOnRequest)
{
  const Case rod = Rod();
  ThreadMonitor monitor(2);
  monitor.Cancel();
  LabelImage full;
  const auto result = PropagateMask(rod.grey, Drawn(rod.truth, 6), full, {}, monitor);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.GetError().kind, Failure::Cancelled);
}

TEST(MaskPropagation, TheHeartOfThePhantom)
{
  GreyImage grey;
  LabelImage truth;
  ThreadMonitor monitor(2);
  HeartPhantomOptions options;
  options.resolution = 96;
  ASSERT_TRUE(MakeHeartPhantom(grey, truth, options, monitor));
  for (int& label : truth.labels)
  {
    label = label > 0 ? 1 : 0;
  }
  const LabelImage mask = Drawn(truth, 12, 6);
  const double shape = Dice(Propagated(grey, mask, By(1)).full, truth);
  const double automatic = Dice(Propagated(grey, mask).full, truth);
  EXPECT_GT(automatic, 0.97);
  EXPECT_GT(automatic, shape + 0.02);
}
