// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/Predicates.h"

#include <gtest/gtest.h>

#include <limits>

using namespace lamina;

TEST(Orientation, FollowsTheNormal)
{
  EXPECT_EQ(Orientation({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }), 1);
  EXPECT_EQ(Orientation({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 5, 7, -1 }), -1);
  EXPECT_EQ(Orientation({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 5, 7, 0 }), 0);
}

TEST(Orientation, IsExactWhereDoublesAreNot)
{
  // Points of a plane through values that have no short sum; then one moved by one unit in the last place.
  const Vec3 a{ 0.1, 0.1, 0.1 };
  const Vec3 b{ 12.0, 12.0, 24.0 };
  const Vec3 c{ 0.5, 0.5, 7.3 };
  Vec3 d{ 24.0, 24.0, 3.7 };
  EXPECT_EQ(Orientation(a, b, c, d), 0);
  d.x = std::nextafter(d.x, std::numeric_limits<double>::infinity());
  const int up = Orientation(a, b, c, d);
  EXPECT_NE(up, 0);
  d.x = std::nextafter(24.0, 0.0);
  EXPECT_EQ(Orientation(a, b, c, d), -up);
  // Far below the range of a product of three.
  EXPECT_EQ(Orientation({ 0, 0, 0 }, { 1e-150, 0, 0 }, { 0, 1e-150, 0 }, { 0, 0, 1e-150 }), 1);
}

TEST(Triangles, TouchOrNot)
{
  const Vec3 a{ 0, 0, 0 };
  const Vec3 b{ 4, 0, 0 };
  const Vec3 c{ 0, 4, 0 };
  EXPECT_TRUE(TrianglesTouch(a, b, c, { 1, 1, -1 }, { 1, 1, 1 }, { 1, 5, 1 }));
  EXPECT_TRUE(TrianglesTouch(a, b, c, { 1, 1, 0 }, { 1, 1, 1 }, { 1, 5, 1 }));       // a corner on the face
  EXPECT_FALSE(TrianglesTouch(a, b, c, { 1, 1, 1e-300 }, { 1, 1, 1 }, { 1, 5, 1 })); // just above
  EXPECT_TRUE(TrianglesTouch(a, b, c, { 1, 1, 0 }, { 9, 1, 0 }, { 9, 9, 0 }));       // coplanar
  EXPECT_FALSE(TrianglesTouch(a, b, c, { 3, 3, 0 }, { 9, 3, 0 }, { 9, 9, 0 }));
  EXPECT_TRUE(SegmentTouchesTriangle({ 1, 1, -1 }, { 1, 1, 1 }, a, b, c));
  EXPECT_FALSE(SegmentTouchesTriangle({ 3, 3, -1 }, { 3, 3, 1 }, a, b, c));
  EXPECT_TRUE(SegmentTouchesTriangle({ 1, 1, 0 }, { 1, 1, 0 }, a, b, c));
  EXPECT_FALSE(SegmentTouchesTriangle({ 3, 3, 0 }, { 3, 3, 0 }, a, b, c));
}

TEST(Triangles, SharedCornersAndEdgesAreAllowed)
{
  const std::vector<Vec3> points{ { 0, 0, 0 },  { 4, 0, 0 }, { 0, 4, 0 },  { 4, 4, 0 },  { 0, 0, 4 },
                                  { 1, 1, 0 },  { 1, 1, 4 }, { -1, 0, 0 }, { 0, -1, 0 }, { -1, -1, 3 },
                                  { 3, 3, -3 }, { 3, 3, 3 }, { 1, 2, 0 } };
  const Triangle base{ { 0, 1, 2 } };
  EXPECT_FALSE(TrianglesIntersect(points, base, { { 1, 3, 2 } }));  // flat neighbour
  EXPECT_FALSE(TrianglesIntersect(points, base, { { 0, 1, 4 } }));  // upright neighbour
  EXPECT_TRUE(TrianglesIntersect(points, base, { { 0, 1, 5 } }));   // folded onto it
  EXPECT_TRUE(TrianglesIntersect(points, base, { { 2, 5, 1 } }));   // folded, other edge, other sense
  EXPECT_TRUE(TrianglesIntersect(points, base, { { 2, 1, 0 } }));   // the same thrice
  EXPECT_FALSE(TrianglesIntersect(points, base, { { 0, 7, 8 } }));  // one corner, coplanar, apart
  EXPECT_FALSE(TrianglesIntersect(points, base, { { 0, 9, 4 } }));  // one corner
  EXPECT_TRUE(TrianglesIntersect(points, base, { { 0, 5, 6 } }));   // one corner, and an edge in the face
  EXPECT_TRUE(TrianglesIntersect(points, base, { { 0, 10, 11 } })); // one corner, cuts through
  EXPECT_TRUE(TrianglesIntersect(points, base, { { 0, 5, 12 } }));  // one corner, coplanar, inside
}

TEST(Triangles, DegenerateOnesCountAsTrouble)
{
  const std::vector<Vec3> points{ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 },
                                  { 9, 9, 9 }, { 8, 9, 9 }, { 9, 8, 9 } };
  EXPECT_TRUE(TrianglesIntersect(points, { { 0, 1, 2 } }, { { 0, 1, 3 } }));
  EXPECT_TRUE(TrianglesIntersect(points, { { 0, 1, 1 } }, { { 0, 1, 3 } }));
  EXPECT_TRUE(TrianglesIntersect(points, { { 0, 0, 0 } }, { { 0, 1, 3 } }));
  EXPECT_FALSE(TrianglesIntersect(points, { { 0, 1, 2 } }, { { 4, 5, 6 } }));
}
