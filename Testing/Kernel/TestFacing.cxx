// SPDX-License-Identifier: BSD-3-Clause
// What counts as a gap between triangles: two sheets and a slot do, what meets at a curve does not.
#include "Mesh/JunctionGraph.h"
#include "Search/SheetGaps.h"
#include "Shapes.h"
#include "Surface/FacingPairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace lamina;

namespace
{

constexpr double degree = 3.14159265358979323846 / 180;
constexpr double step = 0.1;

/// A band of squares along y over a line of places (x, z); its normal is the line's direction times y.
/// `joins`: the first row of points is that which the surface starts with.
void AddBand(TriangleComplex& surface, const std::vector<Vec3>& line, MaterialPair pair, bool joins = false)
{
  constexpr Id wide = 4;
  const Id skipped = joins ? 1 : 0;
  const Id first = static_cast<Id>(surface.points.size()) - skipped * (wide + 1);
  for (std::size_t i = joins ? 1 : 0; i < line.size(); ++i)
  {
    for (Id j = 0; j <= wide; ++j)
    {
      surface.points.push_back({ line[i].x, step * static_cast<double>(j), line[i].z });
    }
  }
  const auto node = [&](Id i, Id j) { return (i < skipped ? 0 : first + i * (wide + 1)) + j; };
  for (Id i = 0; i + 1 < static_cast<Id>(line.size()); ++i)
  {
    for (Id j = 0; j < wide; ++j)
    {
      surface.triangles.push_back({ { node(i, j), node(i + 1, j), node(i + 1, j + 1) } });
      surface.triangles.push_back({ { node(i, j), node(i + 1, j + 1), node(i, j + 1) } });
      surface.materials.insert(surface.materials.end(), 2, pair);
    }
  }
}

/// Points every step from a over each corner of a polyline.
std::vector<Vec3> Line(const std::vector<Vec3>& corners)
{
  std::vector<Vec3> line{ corners.front() };
  for (std::size_t c = 1; c < corners.size(); ++c)
  {
    const Vec3 way = corners[c] - corners[c - 1];
    const int steps = std::max(1, static_cast<int>(std::lround(Norm(way) / step)));
    for (int i = 1; i <= steps; ++i)
    {
      line.push_back(corners[c - 1] + (static_cast<double>(i) / steps) * way);
    }
  }
  return line;
}

struct Gaps
{
  std::vector<double> facing; ///< by the directions alone
  std::vector<double> gap;
  double Least() const { return *std::min_element(this->gap.begin(), this->gap.end()); }
  double LeastFacing() const { return *std::min_element(this->facing.begin(), this->facing.end()); }
};

constexpr double cutoff = 0.4;

Gaps Measure(const TriangleComplex& surface)
{
  ThreadMonitor monitor(2);
  const EdgeTable table = MakeEdgeTable(surface.triangles);
  const Lists star = TrianglesOfPoints(static_cast<Id>(surface.points.size()), surface.triangles);
  return { MeasureGaps(surface.points, surface.triangles, table, star, cutoff, monitor).facing,
           MeasureTrueGaps(surface, table, star, std::vector<double>(surface.points.size(), cutoff),
                           monitor) };
}

/// Two sheets that meet at a curve and hold material 1 between them.
TriangleComplex Wedge(double degrees)
{
  TriangleComplex surface;
  const double a = degrees * degree;
  AddBand(surface, Line({ {}, { 1, 0, 0 } }), { 2, 1 });
  AddBand(surface, Line({ {}, { std::cos(a), 0, std::sin(a) } }), { 1, 3 }, true);
  return surface;
}

/// Material 2 in a slot of so much width and depth in material 1.
TriangleComplex Slot(double width, double depth)
{
  TriangleComplex surface;
  AddBand(surface, Line({ { 0, 0, depth }, {}, { width, 0, 0 }, { width, 0, depth } }), { 1, 2 });
  return surface;
}

/// A block of material 1 whose top has a notch: how deep it is so far from the middle.
template<typename Depth>
TriangleComplex Notched(Depth&& depth)
{
  TriangleComplex surface;
  shapes::AddBox(surface, { -2, 0, -4 }, { 2, 2, 0 }, { { 40, 20, 2 } }, { 1, 0 });
  for (Vec3& p : surface.points)
  {
    p.z -= p.z == 0 ? depth(std::abs(p.x)) : 0;
  }
  surface.targetEdgeLength.assign(surface.points.size(), 1);
  ClassifyJunctions(surface);
  return surface;
}

/// How many triangles come too near to others when the surface is squeezed along x.
std::size_t NarrowWhenSqueezed(TriangleComplex surface, double by)
{
  ThreadMonitor monitor(2);
  InputSurface input(surface, 0.5, 1, monitor);
  input.KeepGaps();
  for (Vec3& p : surface.points)
  {
    p.x *= by;
  }
  const Lists star = TrianglesOfPoints(static_cast<Id>(surface.points.size()), surface.triangles);
  return FindNarrow(surface, star, input.Sheets(), input, monitor).size();
}

} // namespace

TEST(Facing, TwoSheetsBoundAGap)
{
  for (const int upper : { 1, 2 })
  {
    TriangleComplex surface;
    shapes::AddBox(surface, { 0, 0, -1 }, { 2, 2, 0 }, { { 9, 9, 3 } }, { 1, 0 });
    shapes::AddBox(surface, { -0.1, 0, 0.3 }, { 2, 2.1, 1 }, { { 7, 8, 3 } }, { upper, 0 });
    const Gaps gaps = Measure(surface);
    EXPECT_NEAR(gaps.Least(), 0.3, 1e-12);
    EXPECT_NEAR(gaps.LeastFacing(), 0.3, 1e-12);
    for (std::size_t p = 0; p < surface.points.size(); ++p)
    {
      const Vec3& x = surface.points[p];
      if ((x.z == 0 || x.z == 0.3) && std::min(x.x, x.y) > 0.3 && std::max(x.x, x.y) < 1.7)
      {
        EXPECT_NEAR(gaps.gap[p], 0.3, 1e-12);
      }
    }
  }
}

TEST(Facing, SheetsThatMeetAtACurveDoNot)
{
  for (const double degrees : { 25.0, 40.0, 60.0 })
  {
    const Gaps gaps = Measure(Wedge(degrees));
    EXPECT_LT(gaps.LeastFacing(), 0.2) << degrees;
    EXPECT_EQ(gaps.Least(), cutoff) << degrees;
  }
  EXPECT_LT(Measure(Wedge(12)).Least(), 0.05); // too sharp for a corner
}

TEST(Facing, AThinSlotDoesButAtItsBottom)
{
  constexpr double width = 0.1;
  const TriangleComplex surface = Slot(width, 2);
  const Gaps gaps = Measure(surface);
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    const double above = surface.points[p].z;
    if (above > 0.35) // three widths, and a triangle that reaches a step down
    {
      EXPECT_NEAR(gaps.gap[p], width, 1e-12) << above;
    }
    else if (above < 0.05)
    {
      EXPECT_GT(gaps.gap[p], 1.5 * width) << above;
    }
  }
  EXPECT_EQ(Measure(Slot(width, 0.2)).Least(), cutoff); // a groove
  EXPECT_NEAR(Measure(Slot(width, 0.4)).Least(), width, 1e-12);
}

TEST(Facing, GapsAreThoseToTheSheetBetween)
{
  TriangleComplex surface;
  AddBand(surface, Line({ {}, { 1, 0, 0 } }), { 1, 2 });
  const auto lower = surface.points.size();
  AddBand(surface, Line({ { 0, 0, 0.35 }, { 1, 0, 0.35 } }), { 3, 4 });
  EXPECT_NEAR(Measure(surface).LeastFacing(), 0.35, 1e-12);
  EXPECT_EQ(Measure(surface).Least(), cutoff); // 2 on one side and 3 on the other: something is in between
  AddBand(surface, Line({ { 0, 0, 0.2 }, { 1, 0, 0.2 } }), { 2, 3 });
  const Gaps gaps = Measure(surface);
  EXPECT_NEAR(gaps.gap[0], 0.2, 1e-12);
  EXPECT_NEAR(gaps.gap[lower], 0.15, 1e-12);
  EXPECT_NEAR(gaps.gap[2 * lower], 0.15, 1e-12);
}

TEST(Facing, PointsHaveTheirOwnReach)
{
  const TriangleComplex surface = Slot(0.1, 2);
  const EdgeTable table = MakeEdgeTable(surface.triangles);
  const Lists star = TrianglesOfPoints(static_cast<Id>(surface.points.size()), surface.triangles);
  std::vector<double> reaches;
  for (const Vec3& p : surface.points)
  {
    reaches.push_back(p.z > 1 ? 0.15 : 0.05);
  }
  ThreadMonitor monitor(2);
  const std::vector<double> gaps = MeasureTrueGaps(surface, table, star, reaches, monitor);
  for (std::size_t p = 0; p < gaps.size(); ++p)
  {
    EXPECT_NEAR(gaps[p], surface.points[p].z > 1 ? 0.1 : 0.05, 1e-12);
  }
}

TEST(Facing, EditsAskForTheSame)
{
  TriangleComplex surface;
  shapes::AddBox(surface, { 0, 0, -2 }, { 4, 4, 0 }, { { 4, 4, 2 } }, { 1, 0 });
  shapes::AddBox(surface, { 0, 0, 1 }, { 4, 4, 3 }, { { 4, 4, 2 } }, { 2, 0 });
  surface.targetEdgeLength.assign(surface.points.size(), 1);
  ClassifyJunctions(surface);
  ThreadMonitor monitor;
  const InputSurface input(surface, 0.5, 1, monitor);
  const int lowerSheet = input.TriangleSheet(0);
  const int upperSheet = input.TriangleSheet(static_cast<Id>(surface.triangles.size()) - 1);
  const Facet lower{ { { { 1, 1, 0.4 }, { 2, 1, 0.4 }, { 1, 2, 0.4 } } }, { 0, 0, 1 }, lowerSheet, { 1, 0 } };
  Facet upper{ { { { 1, 1, 0.6 }, { 1, 2, 0.6 }, { 2, 1, 0.6 } } }, { 0, 0, -1 }, upperSheet, { 2, 0 } };
  double asked = 0;
  const auto never = [&](const Vec3&, const Vec3&, double most)
  {
    asked = most;
    return false;
  };
  const auto always = [](const Vec3&, const Vec3&, double) { return true; };
  EXPECT_FALSE(StayApart(lower, upper, 0.25, 0.5, input, never));
  EXPECT_NEAR(asked, 4 * 0.2, 1e-12); // more than the six that are promised
  EXPECT_TRUE(StayApart(lower, upper, 0.19, 0.5, input, never));
  EXPECT_TRUE(StayApart(lower, upper, 0.25, 0.15, input, never)); // they lay 1 apart
  EXPECT_TRUE(StayApart(lower, upper, 0.25, 0.5, input, always));
  upper.pair = { 2, 3 };
  EXPECT_TRUE(StayApart(lower, upper, 0.25, 0.5, input, never));
}

TEST(Facing, CorrectionsMayCloseANotchButNotASlot)
{
  const auto notch = [](double x) { return std::max(0.0, 0.5 * (1 - x)); };
  const auto slot = [](double x) { return x < 0.25 ? 1.5 : 0; };
  EXPECT_EQ(NarrowWhenSqueezed(Notched(notch), 0.4), 0U); // from 127 degrees to 77
  EXPECT_EQ(NarrowWhenSqueezed(Notched(slot), 0.9), 0U);
  EXPECT_GT(NarrowWhenSqueezed(Notched(slot), 0.4), 40U); // from 0.5 wide to 0.2
}
