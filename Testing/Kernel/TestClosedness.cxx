// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Closedness.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace lamina;

TEST(Closedness, ClosedShapesPass)
{
  ThreadMonitor monitor(2);
  TriangleComplex surface;
  EXPECT_FALSE(CheckClosed(surface, true, monitor));
  shapes::AddSphere(surface, { 0, 0, 0 }, 1, 2, { 1, 2 });
  shapes::AddSphere(surface, { 0, 0, 0 }, 2, 2, { 2, 0 });
  shapes::AddBox(surface, { 5, 0, 0 }, { 6, 1, 1 }, { { 2, 3, 4 } }, { 3, 0 });
  shapes::AddCylinder(surface, { 9, 0, 0 }, 1, 4, 12, 5, { 1, 0 });
  // The inner sphere's normal points out of 1 into 2, so 2 lies between the spheres: closed, and its inner
  // side turned.
  EXPECT_FALSE(CheckClosed(surface, true, monitor));
}

TEST(Closedness, HolesAreFoundWhereTheyAre)
{
  TriangleComplex surface;
  shapes::AddSphere(surface, { 0, 0, 0 }, 1, 2, { 1, 2 });
  shapes::AddSphere(surface, { 0, 0, 0 }, 2, 2, { 2, 0 });
  const Triangle lost = surface.triangles[5];
  surface.triangles.erase(surface.triangles.begin() + 5);
  surface.materials.erase(surface.materials.begin() + 5);
  for (int threads : { 1, 2 })
  {
    ThreadMonitor monitor(threads);
    const auto edges = FindOpenEdges(surface, monitor);
    ASSERT_EQ(edges.size(), 6u); // three edges, for each of the two materials
    EXPECT_EQ(edges.front().material, 1);
    EXPECT_EQ(edges.back().material, 2);
    EXPECT_TRUE(edges.front().IsOpen());
    EXPECT_NE(std::find(lost.begin(), lost.end(), edges.front().a), lost.end());
    const auto error = CheckClosed(surface, false, monitor);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->kind, Failure::InvalidInput);
    EXPECT_EQ(error->places.size(), 6u);
  }
}

TEST(Closedness, TurnedTrianglesAndTouchingPieces)
{
  ThreadMonitor monitor;
  TriangleComplex turned;
  shapes::AddSphere(turned, { 0, 0, 0 }, 1, 1, { 1, 0 });
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  EXPECT_EQ(FindOpenEdges(turned, monitor).size(), 3u);

  // Two tets that share an edge: four triangles meet in it, and each encloses its volume all the same.
  TriangleComplex touching;
  touching.points = { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 1, 1, 0 }, { -1, 0, 0 }, { -1, -1, 0 } };
  const auto addTet = [&](Id a, Id b, Id c, Id d)
  {
    touching.triangles.insert(touching.triangles.end(),
                              { { { a, c, b } }, { { a, b, d } }, { { b, c, d } }, { { c, a, d } } });
    touching.materials.insert(touching.materials.end(), 4, { 1, 0 });
  };
  addTet(0, 1, 2, 3);
  addTet(0, 1, 4, 5);
  EXPECT_FALSE(CheckClosed(touching, false, monitor));
  const auto error = CheckClosed(touching, true, monitor);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->places.size(), 1u);
}

TEST(Closedness, UnsoundArraysAreNamed)
{
  TriangleComplex good;
  shapes::AddSphere(good, { 0, 0, 0 }, 1, 1, { 1, 0 });
  EXPECT_FALSE(CheckArrays(good));
  TriangleComplex bad = good;
  bad.points[3].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(CheckArrays(bad)->message.find("point 3"), std::string::npos);
  bad = good;
  bad.triangles[4][1] = 1000;
  EXPECT_NE(CheckArrays(bad)->message.find("triangle 4"), std::string::npos);
  bad = good;
  bad.triangles[4][1] = bad.triangles[4][0];
  EXPECT_NE(CheckArrays(bad)->message.find("twice"), std::string::npos);
  bad = good;
  bad.materials[2] = { 0, 1 };
  EXPECT_NE(CheckArrays(bad)->message.find("(0, 1)"), std::string::npos);
  bad = good;
  bad.materials.pop_back();
  EXPECT_TRUE(CheckArrays(bad));
}
