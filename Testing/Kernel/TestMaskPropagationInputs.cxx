// SPDX-License-Identifier: BSD-3-Clause
#include "Rods.h"

#include <limits>

using namespace lamina;
using namespace lamina::rods;

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
