// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/FlatTriangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

using namespace lamina;

namespace
{

constexpr double Pi = 3.141592653589793;

/// Places on a circle, and the edges along them: counter-clockwise, or turned for a hole.
void AddCircle(std::vector<Vec2>& places, PlaneEdges& edges, const Vec2& centre, double radius, int n,
               bool turned)
{
  const Id first = static_cast<Id>(places.size());
  for (int k = 0; k < n; ++k)
  {
    const double phi = 2 * Pi * k / n;
    places.push_back({ centre.x + radius * std::cos(phi), centre.y + radius * std::sin(phi) });
    const Id a = first + k;
    const Id b = first + (k + 1) % n;
    edges.push_back(turned ? std::array<Id, 2>{ { b, a } } : std::array<Id, 2>{ { a, b } });
  }
}

double PolygonArea(double radius, int n)
{
  return 0.5 * n * radius * radius * std::sin(2 * Pi / n);
}

struct Filled
{
  double area = 0;
  double least = 1; ///< quality: 1 of an equilateral triangle
  std::map<std::array<Id, 2>, int> edges;
};

/// Every triangle counter-clockwise; each edge once in a direction.
Filled Judge(const std::vector<Vec2>& places, const std::vector<Triangle>& triangles)
{
  Filled filled;
  for (const Triangle& t : triangles)
  {
    double sides = 0;
    const double area = AreaOf(places, { t[0], t[1], t[2] });
    EXPECT_GT(area, 0);
    filled.area += area;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Vec2& a = places[static_cast<std::size_t>(t[k])];
      const Vec2& b = places[static_cast<std::size_t>(t[(k + 1) % 3])];
      sides += (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
      const int times = ++filled.edges[{ { t[k], t[(k + 1) % 3] } }];
      EXPECT_EQ(times, 1);
    }
    filled.least = std::min(filled.least, 4 * std::sqrt(3.0) * area / sides);
  }
  return filled;
}

} // namespace

TEST(FlatTriangulation, ADiscWithTwoHoles)
{
  std::vector<Vec2> places;
  PlaneEdges edges;
  AddCircle(places, edges, { 0, 0 }, 10, 60, false);
  AddCircle(places, edges, { -4, 1 }, 2.5, 20, true);
  AddCircle(places, edges, { 4, -1 }, 3, 24, true);
  const double exact = PolygonArea(10, 60) - PolygonArea(2.5, 20) - PolygonArea(3, 24);
  const auto regions = FindFlatRegions(places, edges);
  ASSERT_EQ(regions.size(), 1u);
  ASSERT_EQ(regions[0].holes.size(), 2u);
  for (const double spacing : { 0.0, 1.0 })
  {
    std::vector<Vec2> all = places;
    const auto triangles = FillFlatRegion(all, regions[0], spacing);
    const Filled filled = Judge(all, triangles);
    EXPECT_NEAR(filled.area, exact, 1e-9 * exact);
    EXPECT_EQ(triangles.size(), 104u + 2 * (all.size() - 104) + 2)
      << "Euler's number of a disc with two holes";
    for (const auto& edge : edges)
    {
      EXPECT_EQ(filled.edges.count(edge), 1u) << "the rims are kept";
    }
    EXPECT_EQ(all.size() > 104, spacing > 0);
    if (spacing > 0)
    {
      EXPECT_GT(filled.least, 0.5);
    }
  }
}

TEST(FlatTriangulation, RingsInRings)
{
  // A ring, and a disc inside its hole.
  std::vector<Vec2> places;
  PlaneEdges edges;
  AddCircle(places, edges, { 1, 2 }, 9, 40, false);
  AddCircle(places, edges, { 1, 2 }, 6, 30, true);
  AddCircle(places, edges, { 1, 2 }, 3, 20, false);
  const auto regions = FindFlatRegions(places, edges);
  ASSERT_EQ(regions.size(), 2u);
  double area = 0;
  for (const FlatRegion& region : regions)
  {
    area += Judge(places, FillFlatRegion(places, region, 0.8)).area;
  }
  EXPECT_NEAR(area, PolygonArea(9, 40) - PolygonArea(6, 30) + PolygonArea(3, 20), 1e-9);
}

TEST(FlatTriangulation, CombsAndStraightSides)
{
  // Places in the middle of straight sides, and a comb whose teeth no single ear can see over.
  std::vector<Vec2> places{ { 0, 0 }, { 5, 0 }, { 20, 0 }, { 20, 1 }, { 20, 2 } };
  for (int tooth = 9; tooth >= 0; --tooth)
  {
    places.push_back({ 2.0 * tooth + 1.5, 2 });
    places.push_back({ 2.0 * tooth + 1.5, 12 });
    places.push_back({ 2.0 * tooth + 0.5, 12 });
    places.push_back({ 2.0 * tooth + 0.5, 2 });
  }
  places.push_back({ 0, 2 });
  PlaneEdges edges;
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    edges.push_back({ { static_cast<Id>(k), static_cast<Id>((k + 1) % places.size()) } });
  }
  const auto regions = FindFlatRegions(places, edges);
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_NEAR(Judge(places, FillFlatRegion(places, regions[0], 0.5)).area, 40 + 10 * 10, 1e-9);
}

TEST(FlatTriangulation, RegionsThatTouchInAPlaceStayApart)
{
  const std::vector<Vec2> places{ { 0, 0 }, { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } };
  const auto regions = FindFlatRegions(
    places, { { { 0, 1 } }, { { 1, 2 } }, { { 2, 0 } }, { { 0, 3 } }, { { 3, 4 } }, { { 4, 0 } } });
  ASSERT_EQ(regions.size(), 2u);
  EXPECT_EQ(regions[0].rim.size(), 3u);
}

TEST(FlatTriangulation, WhatDoesNotClose)
{
  const std::vector<Vec2> places{ { 0, 0 }, { 1, 0 }, { 0, 1 } };
  EXPECT_TRUE(FindFlatRegions(places, { { { 0, 1 } }, { { 1, 2 } } }).empty());
  EXPECT_TRUE(FindFlatRegions(places, { { { 0, 1 } }, { { 1, 0 } } }).empty());
  std::vector<Vec2> crossed{ { 0, 0 }, { 2, 2 }, { 2, 0 }, { 0, 1 } };
  EXPECT_TRUE(FillFlatRegion(crossed, { { 0, 1, 2, 3 }, {} }, 0).empty()) << "a ring that crosses itself";
}

TEST(FlatTriangulation, RaggedRings)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> radius(3, 10);
  for (int run = 0; run < 50; ++run)
  {
    std::vector<Vec2> places;
    PlaneEdges edges;
    const int n = 5 + run * 3;
    for (int k = 0; k < n; ++k)
    {
      const double r = radius(random);
      places.push_back({ r * std::cos(2 * Pi * k / n), r * std::sin(2 * Pi * k / n) });
      edges.push_back({ { k, (k + 1) % n } });
    }
    AddCircle(places, edges, { 0, 0 }, 1, 9, true);
    std::vector<Id> rim(static_cast<std::size_t>(n));
    for (int k = 0; k < n; ++k)
    {
      rim[static_cast<std::size_t>(k)] = k;
    }
    const double exact = AreaOf(places, rim) - PolygonArea(1, 9);
    const auto regions = FindFlatRegions(places, edges);
    ASSERT_EQ(regions.size(), 1u);
    const auto triangles = FillFlatRegion(places, regions[0], 0.7);
    EXPECT_NEAR(Judge(places, triangles).area, exact, 1e-9 * exact);
  }
}
