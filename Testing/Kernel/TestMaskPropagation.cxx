// SPDX-License-Identifier: BSD-3-Clause
#include "Segmentation/HeartPhantom.h"
#include "Segmentation/MaskPropagation.h"
#include "Segmentation/Specks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

using namespace lamina;

namespace
{

/// An image, and the regions that a user would draw on all of its slices.
struct Case
{
  GreyImage grey;
  LabelImage truth;
};

Case Make(const std::array<Id, 3>& size, const std::function<int(double, double, double)>& label,
          double noise = 6)
{
  Case made;
  made.grey.grid.size = size;
  made.truth.grid.size = size;
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0, noise);
  for (Id k = 0; k < size[2]; ++k)
  {
    for (Id j = 0; j < size[1]; ++j)
    {
      for (Id i = 0; i < size[0]; ++i)
      {
        const int region = label(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
        made.truth.labels.push_back(region);
        made.grey.values.push_back(40 + 60 * region + normal(random));
      }
    }
  }
  return made;
}

/// A rod that leans by three quarters of a pixel a slice and swells.
Case Rod()
{
  return Make({ { 60, 40, 37 } },
              [](double x, double y, double z) {
                return std::hypot(x - 14 - 0.75 * z, y - 20 + 4 * std::sin(0.15 * z)) < 8 + 0.08 * z ? 1 : 0;
              });
}

/// The mask on every `step`-th slice across `axis` from `first` on.
LabelImage Drawn(const LabelImage& truth, Id step, Id first = 0, std::size_t axis = 2)
{
  LabelImage mask = truth;
  const auto& n = truth.grid.size;
  for (Id v = 0; v < truth.grid.Count(); ++v)
  {
    const std::array<Id, 3> index{ { v % n[0], v / n[0] % n[1], v / (n[0] * n[1]) } };
    if ((index[axis] + step - first) % step != 0)
    {
      mask.labels[static_cast<std::size_t>(v)] = 0;
    }
  }
  return mask;
}

struct Outcome
{
  LabelImage full;
  MaskPropagationReport report;
  std::string error;

  Id Voxels(Id k) const
  {
    const Id area = this->full.grid.size[0] * this->full.grid.size[1];
    const auto begin = this->full.labels.begin() + static_cast<std::ptrdiff_t>(k * area);
    return area - std::count(begin, begin + static_cast<std::ptrdiff_t>(area), 0);
  }
};

Outcome Propagated(const GreyImage& grey, const LabelImage& mask, const MaskPropagationOptions& options = {},
                   int threads = 2)
{
  Outcome outcome;
  ThreadMonitor monitor(threads);
  auto report = PropagateMask(grey, mask, outcome.full, options, monitor);
  if (report)
  {
    outcome.report = *report;
  }
  else
  {
    outcome.error = report.GetError().message;
  }
  return outcome;
}

double Dice(const LabelImage& a, const LabelImage& b)
{
  double common = 0;
  double both = 0;
  for (std::size_t v = 0; v < a.labels.size(); ++v)
  {
    common += a.labels[v] != 0 && a.labels[v] == b.labels[v] ? 1 : 0;
    both += (a.labels[v] != 0 ? 1 : 0) + (b.labels[v] != 0 ? 1 : 0);
  }
  return 2 * common / both;
}

MaskPropagationOptions By(int method)
{
  MaskPropagationOptions options;
  options.method = method;
  return options;
}

void ExpectFailure(const Outcome& outcome, const std::string& part)
{
  EXPECT_NE(outcome.error.find(part), std::string::npos) << part << ": " << outcome.error;
}

} // namespace

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

TEST(MaskPropagation, NotANumberIsBorne)
{
  Case rod = Rod();
  for (std::size_t v = 0; v < rod.grey.values.size(); ++v)
  {
    if (rod.truth.labels[v] == 0)
    {
      rod.grey.values[v] = v % 2 ? std::numeric_limits<double>::quiet_NaN() : 20;
    }
  }
  EXPECT_GT(Dice(Propagated(rod.grey, Drawn(rod.truth, 12)).full, rod.truth), 0.97);
}

TEST(MaskPropagation, FindsTheAxis)
{
  const Case body = Make({ { 33, 37, 41 } },
                         [](double x, double y, double z)
                         {
                           const double a = (x - 16) / 12;
                           const double b = (y - 18) / 14;
                           const double c = (z - 20) / 16;
                           return a * a + b * b + c * c < 1 ? 1 : 0;
                         });
  for (int axis = 0; axis < 3; ++axis)
  {
    const LabelImage mask = Drawn(body.truth, 6, 2, static_cast<std::size_t>(axis));
    const Outcome outcome = Propagated(body.grey, mask);
    EXPECT_EQ(outcome.report.axis, axis);
    EXPECT_GT(Dice(outcome.full, body.truth), 0.97) << axis;
    MaskPropagationOptions named;
    named.axis = axis;
    EXPECT_EQ(Propagated(body.grey, mask, named).full.labels, outcome.full.labels);
    // A single slice.
    const LabelImage one = Drawn(body.truth, 100, body.truth.grid.size[static_cast<std::size_t>(axis)] / 2,
                                 static_cast<std::size_t>(axis));
    EXPECT_EQ(Propagated(body.grey, one).report.axis, axis);
  }
  // All slices drawn: the mask itself.
  const Outcome all = Propagated(body.grey, body.truth);
  EXPECT_EQ(all.full.labels, body.truth.labels);
  EXPECT_TRUE(all.report.slices.empty());
  EXPECT_TRUE(all.report.warnings.empty());
}

TEST(MaskPropagation, EachValueIsARegion)
{
  const Case halves = Make({ { 50, 40, 31 } },
                           [](double x, double y, double z)
                           {
                             const double middle = 20 + 0.3 * z;
                             return std::hypot(x - middle, y - 20) < 13 ? (x < middle ? 1 : 2) : 0;
                           });
  const LabelImage mask = Drawn(halves.truth, 10);
  for (const int method : { 1, 2, 3, 0 })
  {
    const Outcome both = Propagated(halves.grey, mask, By(method));
    EXPECT_EQ(both.report.ids, (std::vector<int>{ 1, 2 }));
    EXPECT_GT(Dice(both.full, halves.truth), method == 1 ? 0.9 : 0.96) << method;
    // No crack between the regions.
    for (Id k = 0; k < 31; ++k)
    {
      for (Id x = 17; x < 33; ++x)
      {
        ASSERT_NE(both.full.labels[static_cast<std::size_t>(both.full.grid.Index(x, 20, k))], 0)
          << x << " " << k;
      }
    }
  }
  MaskPropagationOptions second;
  second.maskValue = 2;
  const Outcome two = Propagated(halves.grey, mask, second);
  EXPECT_EQ(two.report.ids, std::vector<int>{ 2 });
  EXPECT_EQ(std::count(two.full.labels.begin(), two.full.labels.end(), 1), 0);
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

TEST(MaskPropagation, NumbersOfSlices)
{
  const Case rod = Rod();
  MaskPropagationOptions options;
  options.firstSlice = { { 0, 0, -5 } };
  options.drawnSlices = { -5, 1, 7 };
  const Outcome outcome = Propagated(rod.grey, Drawn(rod.truth, 6), options);
  EXPECT_EQ(outcome.report.drawn, (std::vector<Id>{ -5, 1, 7 }));
  EXPECT_EQ(outcome.report.slices.front().slice, -4);
  EXPECT_EQ(outcome.report.slices.front().from, -5);
  EXPECT_EQ(outcome.report.slices.front().to, 1);
  options.drawnSlices = { 32 };
  ExpectFailure(Propagated(rod.grey, Drawn(rod.truth, 6), options), "across axis k its slices are -5 to 31");
}

TEST(MaskPropagation, WarnsWhereSlicesForetellNothing)
{
  // Discs that jump to and fro between drawn slices.
  const Case jumps = Make(
    { { 80, 40, 25 } },
    [](double x, double y, double z)
    {
      const double centre = static_cast<int>(z) / 6 % 2 ? 20 : 60;
      return std::hypot(x - centre, y - 20) < 9 ? 1 : 0;
    },
    0);
  const Outcome outcome = Propagated(jumps.grey, Drawn(jumps.truth, 6), By(1));
  ASSERT_EQ(outcome.report.warnings.size(), 1U);
  EXPECT_NE(outcome.report.warnings[0].find("draw more slices"), std::string::npos);
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

TEST(MaskPropagation, WrongInputs)
{
  const Case rod = Rod();
  const LabelImage mask = Drawn(rod.truth, 6);
  LabelImage nothing = mask;
  nothing.labels.assign(nothing.labels.size(), 0);
  ExpectFailure(Propagated(rod.grey, nothing), "no slice is drawn");
  LabelImage other = mask;
  other.grid.size = { 40, 60, 37 };
  ExpectFailure(Propagated(rod.grey, other), "the mask has 40 x 60 x 37 voxels, the image 60 x 40 x 37");
  LabelImage many = mask;
  for (int v = 0; v < 80; ++v)
  {
    many.labels[static_cast<std::size_t>(v)] = v + 1;
  }
  ExpectFailure(Propagated(rod.grey, many), "more than 64 different values");
  MaskPropagationOptions options;
  options.maskValue = 80;
  EXPECT_EQ(Propagated(rod.grey, many, options).report.ids, std::vector<int>{ 80 });
  options.maskValue = 9;
  ExpectFailure(Propagated(rod.grey, mask, options), "the mask is 9 nowhere");
  options = {};
  options.drawnSlices = { 1, 2 };
  ExpectFailure(Propagated(rod.grey, mask, options), "the mask is 0 on all slices that are listed");
  const auto wrong = [&](const std::function<void(MaskPropagationOptions&)>& set, const std::string& part)
  {
    MaskPropagationOptions bad;
    set(bad);
    ExpectFailure(Propagated(rod.grey, mask, bad), part);
  };
  wrong([](auto& o) { o.axis = 4; }, "slice axis 4");
  wrong([](auto& o) { o.method = -1; }, "method -1");
  wrong([](auto& o) { o.maskValue = -2; }, "mask value -2");
  wrong([](auto& o) { o.maximumSlices = -2; }, "maximum slices -2");
  wrong([](auto& o) { o.levels = 0; }, "levels 0");
  wrong([](auto& o) { o.smoothness = 0.1; }, "smoothness");
  wrong([](auto& o) { o.searchRange = 0; }, "search range");
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

TEST(Specks, GoToTheLabelAroundThem)
{
  // Region 3 with a hole, an island of region 7 at its edge, and an island of region 3 in a corner.
  const std::vector<int> drawing{
    3, 0, 0, 0, 0, 0, 0, 0, //
    0, 0, 3, 3, 3, 3, 0, 0, //
    0, 0, 3, 0, 3, 3, 7, 0, //
    0, 0, 3, 3, 3, 3, 7, 0, //
    0, 0, 0, 0, 0, 0, 0, 0, //
  };
  const std::vector<int> ids{ 3, 7 };
  EXPECT_EQ(SmallestParts(drawing, 8, ids), (std::vector<Id>{ 1, 1, 2 }));
  EXPECT_GT(SmallestParts(std::vector<int>(40, 3), 8, ids)[0], 1000000);
  std::vector<int> cleaned = drawing;
  RemoveSpecks(cleaned, 8, ids, { 2, 2, 2 });
  std::vector<int> expected = drawing;
  expected[0] = 0;
  expected[19] = 3;
  EXPECT_EQ(cleaned, expected);
  RemoveSpecks(cleaned, 8, ids, { 2, 2, 3 });
  expected[22] = expected[30] = 0;
  EXPECT_EQ(cleaned, expected) << "four edges with the background, two with region 3";
  cleaned = drawing;
  RemoveSpecks(cleaned, 8, ids, { 1, 1, 1 });
  EXPECT_EQ(cleaned, drawing);
}
