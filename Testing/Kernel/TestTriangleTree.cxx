// SPDX-License-Identifier: BSD-3-Clause
#include "Search/TriangleTree.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace lamina;

namespace
{

struct Soup
{
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
};

/// Small random triangles in the unit box.
Soup MakeSoup(int count, double size)
{
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto random = [&]() { return Vec3{ unit(generator), unit(generator), unit(generator) }; };
  Soup soup;
  for (int i = 0; i < count; ++i)
  {
    const Vec3 centre = random();
    for (int k = 0; k < 3; ++k)
    {
      soup.points.push_back(centre + size * random());
    }
    soup.triangles.push_back({ { 3 * i, 3 * i + 1, 3 * i + 2 } });
  }
  return soup;
}

const Vec3& At(const Soup& soup, Id triangle, std::size_t corner)
{
  return soup.points[static_cast<std::size_t>(soup.triangles[static_cast<std::size_t>(triangle)][corner])];
}

double BruteDistance2(const Soup& soup, const Vec3& p)
{
  double best = std::numeric_limits<double>::infinity();
  for (Id i = 0; i < static_cast<Id>(soup.triangles.size()); ++i)
  {
    Vec3 q;
    std::array<double, 3> w;
    best = std::min(best, PointTriangleDistance2(p, At(soup, i, 0), At(soup, i, 1), At(soup, i, 2), q, w));
  }
  return best;
}

} // namespace

TEST(TriangleTree, ClosestPointAgreesWithBruteForce)
{
  Soup soup = MakeSoup(500, 0.1);
  TriangleTree tree(soup.points, soup.triangles);
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> wide(-0.5, 1.5);
  for (int round = 0; round < 2; ++round)
  {
    for (int i = 0; i < 300; ++i)
    {
      const Vec3 p{ wide(generator), wide(generator), wide(generator) };
      const auto closest = tree.ClosestPoint(p);
      const double expected = BruteDistance2(soup, p);
      EXPECT_EQ(closest.distance2, expected);
      ASSERT_GE(closest.triangle, 0);
      Vec3 weighted;
      for (std::size_t k = 0; k < 3; ++k)
      {
        weighted += closest.weights[k] * At(soup, closest.triangle, k);
      }
      EXPECT_LT(Norm(weighted - closest.point), 1e-14);
      EXPECT_NEAR(Norm2(p - closest.point), expected, 1e-14);
      EXPECT_EQ(tree.ClosestPoint(p, 0.5 * expected).triangle, -1);
    }
    for (Vec3& p : soup.points)
    {
      p = { p.y * p.y, 1 - p.x, p.z + 0.3 * p.x };
    }
    tree.Refit();
  }
}

TEST(TriangleTree, PointTriangleDistanceInEveryRegion)
{
  const Vec3 a{ 0, 0, 0 };
  const Vec3 b{ 2, 0, 0 };
  const Vec3 c{ 0, 2, 0 };
  Vec3 q;
  std::array<double, 3> w;
  EXPECT_DOUBLE_EQ(PointTriangleDistance2({ 0.5, 0.5, 3 }, a, b, c, q, w), 9);
  EXPECT_DOUBLE_EQ(PointTriangleDistance2({ -1, -1, 0 }, a, b, c, q, w), 2);
  EXPECT_DOUBLE_EQ(PointTriangleDistance2({ 1, -2, 0 }, a, b, c, q, w), 4);
  EXPECT_DOUBLE_EQ(PointTriangleDistance2({ 2, 2, 0 }, a, b, c, q, w), 2);
  EXPECT_DOUBLE_EQ(PointTriangleDistance2({ 5, 0, 4 }, a, b, c, q, w), 25);
  EXPECT_DOUBLE_EQ(w[1], 1);
  EXPECT_DOUBLE_EQ(PointTriangleDistance2({ 0, 3, 0 }, a, b, b, q, w), 9); // without area
}

TEST(TriangleTree, FirstHitAgreesWithBruteForce)
{
  const Soup soup = MakeSoup(500, 0.2);
  const TriangleTree tree(soup.points, soup.triangles);
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  int hits = 0;
  for (int i = 0; i < 500; ++i)
  {
    const Vec3 origin{ 0.5 + unit(generator), 0.5 + unit(generator), 0.5 + unit(generator) };
    Vec3 direction{ unit(generator), unit(generator), unit(generator) };
    if (i % 5 == 0)
    {
      direction[i % 3] = 0;
    }
    const double tMin = i % 2 == 0 ? 0 : 0.2;
    const auto accept = [](Id id) { return id % 3 != 0; };
    TriangleTree::Hit expected;
    expected.t = 1.5;
    for (Id id = 0; id < static_cast<Id>(soup.triangles.size()); ++id)
    {
      const double t = RayTriangle(origin, direction, At(soup, id, 0), At(soup, id, 1), At(soup, id, 2));
      if (accept(id) && t > tMin && t < expected.t)
      {
        expected = { id, t };
      }
    }
    const auto hit = tree.FirstHit(origin, direction, tMin, 1.5, accept);
    EXPECT_EQ(hit.triangle, expected.triangle);
    hits += hit.triangle >= 0;
  }
  EXPECT_GT(hits, 40);
}

TEST(TriangleTree, RaysDoNotSlipThroughEdges)
{
  // A fan in the plane z = 0; rays straight at its shared edges and its hub, along axes too.
  std::vector<Vec3> points{ { 0.1, 0.3, 0 } };
  std::vector<Triangle> triangles;
  for (int i = 0; i < 7; ++i)
  {
    points.push_back({ std::cos(i * 0.897597901), std::sin(i * 0.897597901), 0 });
    triangles.push_back({ { 0, 1 + i, 1 + (i + 1) % 7 } });
  }
  const TriangleTree tree(points, triangles);
  for (int i = 0; i < 7; ++i)
  {
    for (double s : { 0.0, 1.0 / 3, 0.7 })
    {
      const Vec3 target = (1 - s) * points[0] + s * points[static_cast<std::size_t>(1 + i)];
      const auto any = [](Id) { return true; };
      EXPECT_GE(tree.FirstHit(target + Vec3{ 0, 0, 2 }, { 0, 0, -1 }, 0, 9, any).triangle, 0);
      EXPECT_GE(tree.FirstHit(target + Vec3{ 0.3, 0.2, 2 }, { -0.3, -0.2, -2 }, 0, 9, any).triangle, 0);
    }
  }
}

TEST(TriangleTree, OverlapsAgreeWithBruteForce)
{
  const Soup soup = MakeSoup(400, 0.1);
  std::vector<Id> subset;
  for (Id i = 0; i < 400; i += 3)
  {
    subset.push_back(i);
  }
  const TriangleTree tree(soup.points, soup.triangles, subset);
  Box query;
  query.Add(Vec3{ 0.2, 0.3, 0.4 });
  query.Add(Vec3{ 0.6, 0.6, 0.9 });
  std::set<Id> found;
  tree.ForOverlaps(query, [&](Id id) { return found.insert(id).second; });
  std::set<Id> expected;
  for (Id id : subset)
  {
    Box own;
    for (std::size_t k = 0; k < 3; ++k)
    {
      own.Add(At(soup, id, k));
    }
    if (own.Overlaps(query))
    {
      expected.insert(id);
    }
  }
  EXPECT_EQ(found, expected);
  int visits = 0;
  tree.ForOverlaps(query, [&](Id) { return ++visits < 3; });
  EXPECT_EQ(visits, 3);
}

TEST(TriangleTree, EmptyAndCoincidentInput)
{
  const std::vector<Vec3> points{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  const TriangleTree none(points, {});
  EXPECT_EQ(none.ClosestPoint({ 0, 0, 0 }).triangle, -1);
  EXPECT_EQ(none.FirstHit({ 0, 0, 1 }, { 0, 0, -1 }, 0, 9, [](Id) { return true; }).triangle, -1);
  const std::vector<Triangle> same(1000, Triangle{ { 0, 1, 2 } });
  const TriangleTree heap(points, same);
  EXPECT_EQ(heap.ClosestPoint({ 0.2, 0.2, 1 }).triangle, 0); // ties go to the lower id
  EXPECT_EQ(heap.FirstHit({ 0.2, 0.2, 1 }, { 0, 0, -1 }, 0, 9, [](Id) { return true; }).triangle, 0);
}

TEST(TriangleTree, FindNearVisitsAllThatIsNear)
{
  const Soup soup = MakeSoup(400, 0.1);
  const TriangleTree tree(soup.points, soup.triangles);
  const Vec3 p{ 0.5, 0.4, 0.6 };
  constexpr double limit2 = 0.04;
  std::set<Id> visited;
  EXPECT_FALSE(tree.FindNear(p, limit2,
                             [&](const TriangleTree::Closest& place)
                             {
                               EXPECT_LE(place.distance2, limit2);
                               visited.insert(place.triangle);
                               return false;
                             }));
  std::set<Id> near;
  for (Id i = 0; i < static_cast<Id>(soup.triangles.size()); ++i)
  {
    if (tree.ClosestOnTriangle(i, p).distance2 <= limit2)
    {
      near.insert(i);
    }
  }
  EXPECT_EQ(visited, near);
  EXPECT_GT(near.size(), 5u);
  int calls = 0;
  EXPECT_TRUE(tree.FindNear(p, limit2, [&](const TriangleTree::Closest&) { return ++calls == 2; }));
  EXPECT_EQ(calls, 2);
}
