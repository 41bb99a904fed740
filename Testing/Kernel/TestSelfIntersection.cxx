// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/Predicates.h"
#include "Search/SelfIntersection.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <random>

using namespace lamina;

TEST(SelfIntersection, AgreesWithAllPairs)
{
  std::mt19937 generator(9);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Vec3> points;
  for (int i = 0; i < 200; ++i)
  {
    points.push_back({ unit(generator), unit(generator), unit(generator) });
  }
  std::vector<Triangle> triangles;
  for (Id i = 0; i < 300; ++i)
  {
    triangles.push_back({ { i * 7 % 200, (i * 11 + 1) % 200, (i * 13 + 5) % 200 } });
  }
  std::vector<std::array<Id, 2>> expected;
  for (Id i = 0; i < 300; ++i)
  {
    for (Id j = i + 1; j < 300; ++j)
    {
      if (TrianglesIntersect(points, triangles[static_cast<std::size_t>(i)],
                             triangles[static_cast<std::size_t>(j)]))
      {
        expected.push_back({ { i, j } });
      }
    }
  }
  EXPECT_GT(expected.size(), 100u);
  for (int threads : { 1, 3 })
  {
    ThreadMonitor monitor(threads);
    EXPECT_EQ(FindIntersections(points, triangles, monitor), expected);
  }
}

TEST(SelfIntersection, SpheresApartAndTogether)
{
  ThreadMonitor monitor(2);
  TriangleComplex surface;
  shapes::AddSphere(surface, { 0, 0, 0 }, 1, 4, { 1, 0 });
  shapes::AddSphere(surface, { 2.5, 0, 0 }, 1, 4, { 1, 0 });
  EXPECT_TRUE(FindIntersections(surface.points, surface.triangles, monitor).empty());
  shapes::AddSphere(surface, { 1.25, 0, 0 }, 1, 4, { 1, 0 });
  EXPECT_FALSE(FindIntersections(surface.points, surface.triangles, monitor).empty());
}
