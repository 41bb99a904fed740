// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/Quality.h"
#include "Geometry/SmallPolyhedron.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace lamina;

namespace
{

using Face = std::array<int, 3>;
using Tets = std::vector<std::array<int, 4>>;

double VolumeOf(const SmallPolyhedron& polyhedron)
{
  double volume = 0;
  for (const Face& f : polyhedron.faces)
  {
    const auto at = [&](std::size_t k) { return polyhedron.points[static_cast<std::size_t>(f[k])]; };
    volume += Dot(at(0), Cross(at(1), at(2))) / 6;
  }
  return volume;
}

double VolumeOf(const SmallPolyhedron& polyhedron, const Tets& tets)
{
  double volume = 0;
  for (const auto& tet : tets)
  {
    const auto at = [&](std::size_t k) { return polyhedron.points[static_cast<std::size_t>(tet[k])]; };
    volume += TetVolume(at(0), at(1), at(2), at(3));
  }
  return volume;
}

double QualityOf(const SmallPolyhedron& polyhedron, const std::array<int, 4>& tet)
{
  const auto at = [&](std::size_t k) { return polyhedron.points[static_cast<std::size_t>(tet[k])]; };
  return TetQuality(at(0), at(1), at(2), at(3));
}

double LeastOf(const SmallPolyhedron& polyhedron, const Tets& tets)
{
  double least = 1;
  for (const auto& tet : tets)
  {
    least = std::min(least, QualityOf(polyhedron, tet));
  }
  return least;
}

/// The tets of best 3r/R.
Tets Fill(const SmallPolyhedron& polyhedron, double& floor, int steps = 100000)
{
  return FillPolyhedron(
    polyhedron, [&](const std::array<int, 4>& tet) { return QualityOf(polyhedron, tet); }, floor, steps);
}

bool HasEdge(const Tets& tets, int a, int b)
{
  return std::any_of(tets.begin(), tets.end(),
                     [&](const auto& tet) {
                       return std::count(tet.begin(), tet.end(), a) > 0 &&
                              std::count(tet.begin(), tet.end(), b) > 0;
                     });
}

/// Corners on the axes, at the given distances: 0 and 1 along x, 2 and 3 along y, 4 and 5 along z.
SmallPolyhedron Octahedron(double x, double y, double z)
{
  SmallPolyhedron o;
  o.points = { { x, 0, 0 }, { -x, 0, 0 }, { 0, y, 0 }, { 0, -y, 0 }, { 0, 0, z }, { 0, 0, -z } };
  o.faces = { { { 0, 2, 4 } }, { { 2, 1, 4 } }, { { 1, 3, 4 } }, { { 3, 0, 4 } },
              { { 2, 0, 5 } }, { { 1, 2, 5 } }, { { 3, 1, 5 } }, { { 0, 3, 5 } } };
  o.mayGo.assign(6, 0);
  return o;
}

/// Two triangles, the upper one turned by an angle; the sides bend inwards.
SmallPolyhedron Schoenhardt(double angle)
{
  SmallPolyhedron s;
  for (int k = 0; k < 6; ++k)
  {
    const double a = 2 * std::acos(-1.0) / 3 * (k % 3) + (k < 3 ? 0 : angle);
    s.points.push_back({ std::cos(a), std::sin(a), k < 3 ? 0.0 : 1.0 });
  }
  s.faces = { { { 0, 2, 1 } }, { { 3, 4, 5 } } };
  for (int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    s.faces.push_back({ { k, next, next + 3 } });
    s.faces.push_back({ { k, next + 3, k + 3 } });
  }
  s.mayGo.assign(6, 0);
  return s;
}

} // namespace

TEST(SmallPolyhedron, TheBestOfThreeDiagonalsOfAnOctahedron)
{
  // Four tets round one diagonal, whichever is best; the others by hand.
  const auto round = [](const SmallPolyhedron& o, int axis)
  {
    Tets tets;
    for (const Face& f : o.faces)
    {
      if (std::count(f.begin(), f.end(), 2 * axis) > 0)
      {
        tets.push_back({ { f[0], f[2], f[1], 2 * axis + 1 } });
      }
    }
    return tets;
  };
  for (const Vec3& size : { Vec3{ 1, 1.2, 1.5 }, Vec3{ 1, 0.4, 1.1 }, Vec3{ 2, 1.5, 0.6 } })
  {
    const SmallPolyhedron o = Octahedron(size.x, size.y, size.z);
    double expected = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      expected = std::max(expected, LeastOf(o, round(o, axis)));
    }
    double floor = 0;
    const Tets tets = Fill(o, floor);
    ASSERT_EQ(tets.size(), 4u);
    EXPECT_NEAR(LeastOf(o, tets), expected, 1e-3);
    EXPECT_EQ(LeastOf(o, tets), floor);
    EXPECT_NEAR(VolumeOf(o, tets), VolumeOf(o), 1e-14);
    double beaten = expected;
    EXPECT_TRUE(Fill(o, beaten).empty());
    EXPECT_EQ(beaten, expected);
  }
}

TEST(SmallPolyhedron, EdgesThatAreNotAllowedAreNotMade)
{
  SmallPolyhedron o = Octahedron(1, 1.2, 1.5);
  double floor = 0;
  ASSERT_TRUE(HasEdge(Fill(o, floor), 0, 1));
  o.allows = [](int a, int b) { return std::min(a, b) != 0 || std::max(a, b) != 1; };
  floor = 0;
  const Tets tets = Fill(o, floor);
  ASSERT_EQ(tets.size(), 4u);
  EXPECT_FALSE(HasEdge(tets, 0, 1));
}

TEST(SmallPolyhedron, SomeCannotBeFilled)
{
  double floor = 0;
  EXPECT_TRUE(Fill(Schoenhardt(0.5), floor).empty());
  const SmallPolyhedron other = Schoenhardt(-0.5); // its sides bend outwards
  const Tets tets = Fill(other, floor);
  ASSERT_FALSE(tets.empty());
  EXPECT_NEAR(VolumeOf(other, tets), VolumeOf(other), 1e-14);
}

TEST(SmallPolyhedron, PointsInsideStayUnlessTheyMayGo)
{
  SmallPolyhedron o = Octahedron(1, 1, 1);
  o.points.push_back({ 0.05, 0.04, 0.8 }); // near a corner, where it spoils much
  o.mayGo.push_back(0);
  double with = 0;
  const Tets kept = Fill(o, with);
  ASSERT_FALSE(kept.empty());
  EXPECT_TRUE(HasEdge(kept, 6, 4));
  EXPECT_NEAR(VolumeOf(o, kept), VolumeOf(o), 1e-14);
  o.mayGo.back() = 1;
  double without = 0;
  const Tets tets = Fill(o, without);
  EXPECT_EQ(tets.size(), 4u);
  EXPECT_GT(without, with);
}

TEST(SmallPolyhedron, TooFewStepsOrTooManyPointsFindNothing)
{
  double floor = 0;
  EXPECT_TRUE(Fill(Octahedron(1, 1, 1), floor, 1).empty());
  SmallPolyhedron o = Octahedron(1, 1, 1);
  o.points.resize(SmallPolyhedron::MostPoints + 1);
  o.mayGo.resize(o.points.size(), 1);
  EXPECT_TRUE(Fill(o, floor).empty());
}
