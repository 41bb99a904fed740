// SPDX-License-Identifier: BSD-3-Clause
#include "Images.h"
#include "Search/Clearance.h"
#include "Search/SheetGaps.h"
#include "Shapes.h"
#include "Surface/ExtractInterfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace lamina;

namespace
{

constexpr double facingSine = 0.7071;

/// All pairs, all connections.
SheetGaps BruteForce(const TriangleComplex& surface, double cutoff)
{
  SheetGaps gaps;
  gaps.any.assign(surface.points.size(), cutoff);
  gaps.facing.assign(surface.points.size(), cutoff);
  const auto places = [&](const Triangle& t)
  {
    return std::array<Vec3, 3>{ { surface.points[static_cast<std::size_t>(t[0])],
                                  surface.points[static_cast<std::size_t>(t[1])],
                                  surface.points[static_cast<std::size_t>(t[2])] } };
  };
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    for (std::size_t j = i + 1; j < surface.triangles.size(); ++j)
    {
      const Triangle& s = surface.triangles[i];
      const Triangle& t = surface.triangles[j];
      if (ShareCorner(s, t))
      {
        continue;
      }
      const Vec3 n = Normalized(AreaVector2(surface.points, s));
      const Vec3 m = Normalized(AreaVector2(surface.points, t));
      double any = cutoff;
      double facing = cutoff;
      AllOfConnections(places(s), places(t),
                       [&](const Vec3& from, const Vec3& to)
                       {
                         const double d = Norm(from - to);
                         any = std::min(any, d);
                         if (std::abs(Dot(n, from - to)) >= facingSine * d &&
                             std::abs(Dot(m, from - to)) >= facingSine * d)
                         {
                           facing = std::min(facing, d);
                         }
                         return true;
                       });
      for (const Triangle* both : { &s, &t })
      {
        for (const Id p : *both)
        {
          double& a = gaps.any[static_cast<std::size_t>(p)];
          double& f = gaps.facing[static_cast<std::size_t>(p)];
          a = std::min(a, any);
          f = std::min(f, facing);
        }
      }
    }
  }
  return gaps;
}

void ExpectSame(const TriangleComplex& surface, double cutoff)
{
  const SheetGaps wanted = BruteForce(surface, cutoff);
  const Lists star = TrianglesOfPoints(static_cast<Id>(surface.points.size()), surface.triangles);
  const EdgeTable table = MakeEdgeTable(surface.triangles);
  ThreadMonitor one(1);
  ThreadMonitor three(3);
  const SheetGaps gaps = MeasureGaps(surface.points, surface.triangles, table, star, cutoff, one);
  const SheetGaps again = MeasureGaps(surface.points, surface.triangles, table, star, cutoff, three);
  EXPECT_EQ(gaps.any, again.any);
  EXPECT_EQ(gaps.facing, again.facing);
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    EXPECT_NEAR(gaps.any[p], wanted.any[p], 1e-9) << "point " << p;
    EXPECT_NEAR(gaps.facing[p], wanted.facing[p], 1e-9) << "point " << p;
  }
}

} // namespace

TEST(SheetGaps, AgreeWithAllPairsOnStaircasesOfNoise)
{
  ThreadMonitor monitor(2);
  for (unsigned seed : { 1U, 2U })
  {
    TriangleComplex surface;
    ASSERT_TRUE(ExtractInterfaces(images::Noise(5, 3, seed), surface, {}, monitor));
    for (double cutoff : { 0.3, 1.3 })
    {
      ExpectSame(surface, cutoff);
    }
  }
}

TEST(SheetGaps, AgreeWithAllPairsOnSheetsThatMovedALittle)
{
  ThreadMonitor monitor(2);
  TriangleComplex surface;
  ASSERT_TRUE(ExtractInterfaces(images::Shell(9, 2.2, 3.6), surface, {}, monitor));
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> little(-0.12, 0.12);
  for (Vec3& p : surface.points)
  {
    p += { little(generator), little(generator), little(generator) };
  }
  for (double cutoff : { 0.5, 1.3, 2.0 })
  {
    ExpectSame(surface, cutoff);
  }
}

TEST(SheetGaps, TwoSpheresFaceEachOtherAcrossTheirGap)
{
  TriangleComplex surface;
  shapes::AddSphere(surface, { 0, 0, 0 }, 1, 3, { 1, 0 });
  shapes::AddSphere(surface, { 2.1, 0, 0 }, 1, 3, { 1, 0 });
  ThreadMonitor monitor(2);
  const Lists star = TrianglesOfPoints(static_cast<Id>(surface.points.size()), surface.triangles);
  const SheetGaps gaps =
    MeasureGaps(surface.points, surface.triangles, MakeEdgeTable(surface.triangles), star, 0.5, monitor);
  EXPECT_NEAR(*std::min_element(gaps.facing.begin(), gaps.facing.end()), 0.1, 0.01);
  ExpectSame(surface, 0.5);
}
