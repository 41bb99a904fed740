// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/Predicates.h"
#include "Geometry/Quality.h"
#include "Mesh/TetFaces.h"
#include "Volume/ImproveTets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

using namespace lamina;

namespace
{

/// An n^3 grid of cubes of five tets each, alternating, its inner points shaken; lower half group 1, upper
/// group 2.
TetSet ShakenGrid(int n, double shake)
{
  TetSet set;
  std::mt19937 generator(6);
  std::uniform_real_distribution<double> noise(-shake, shake);
  const auto id = [n](int i, int j, int k) { return static_cast<Id>(i + (n + 1) * (j + (n + 1) * k)); };
  for (int k = 0; k <= n; ++k)
  {
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i <= n; ++i)
      {
        const bool isInner = i > 0 && j > 0 && k > 0 && i < n && j < n && k < n && 2 * k != n;
        const Vec3 move{ noise(generator), noise(generator), noise(generator) };
        set.points.push_back(Vec3{ 1.0 * i, 1.0 * j, 1.0 * k } + (isInner ? 1.0 : 0.0) * move);
        set.fixed.push_back(isInner ? 0 : 1);
        set.layerIndex.push_back(k);
      }
    }
  }
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        // A corner of the cube by three bits, mirrored in every second cube so that diagonals agree.
        const int m = (i + j + k) % 2;
        const auto c = [&](int x, int y, int z) { return id(i + (x ^ m), j + y, k + z); };
        const std::array<std::array<Id, 4>, 5> tets{
          { { { c(0, 0, 0), c(1, 0, 0), c(0, 1, 0), c(0, 0, 1) } },
            { { c(1, 1, 0), c(0, 1, 0), c(1, 0, 0), c(1, 1, 1) } },
            { { c(1, 0, 1), c(0, 0, 1), c(1, 1, 1), c(1, 0, 0) } },
            { { c(0, 1, 1), c(1, 1, 1), c(0, 0, 1), c(0, 1, 0) } },
            { { c(1, 0, 0), c(0, 1, 0), c(0, 0, 1), c(1, 1, 1) } } }
        };
        for (auto tet : tets)
        {
          const auto& p = set.points;
          const auto at = [&](std::size_t v) { return p[static_cast<std::size_t>(tet[v])]; };
          if (m == 1)
          {
            std::swap(tet[2], tet[3]);
          }
          if (Orientation(at(0), at(1), at(2), at(3)) > 0)
          {
            set.groups.push_back(2 * k < n ? 1 : 2);
            set.tets.push_back(tet);
          }
        }
      }
    }
  }
  return set;
}

std::array<double, 2> Volumes(const TetSet& set, double& least)
{
  std::array<double, 2> volumes{ { 0, 0 } };
  least = 1;
  for (std::size_t t = 0; t < set.tets.size(); ++t)
  {
    const auto at = [&](std::size_t v) { return set.points[static_cast<std::size_t>(set.tets[t][v])]; };
    volumes[static_cast<std::size_t>(set.groups[t] - 1)] += TetVolume(at(0), at(1), at(2), at(3));
    least = std::min(least, TetQuality(at(0), at(1), at(2), at(3)));
  }
  return volumes;
}

/// Faces without a neighbour or between groups.
std::set<Triangle> Walls(const TetSet& set)
{
  ThreadMonitor monitor;
  const auto neighbours = FindTetNeighbours(set.tets, static_cast<Id>(set.points.size()), monitor);
  std::set<Triangle> walls;
  for (std::size_t t = 0; t < set.tets.size(); ++t)
  {
    for (std::size_t k = 0; k < 4; ++k)
    {
      const Id other = neighbours[t][k];
      EXPECT_NE(other, -2);
      if (other < 0 || set.groups[static_cast<std::size_t>(other)] != set.groups[t])
      {
        Triangle face = TetFace(set.tets[t], k);
        std::sort(face.begin(), face.end());
        walls.insert(face);
      }
    }
  }
  return walls;
}

} // namespace

TEST(ImproveTets, RaisesTheWorstAndKeepsTheRest)
{
  const TetSet start = ShakenGrid(8, 0.3);
  double before = 0;
  const auto volumes = Volumes(start, before);
  ASSERT_EQ(start.tets.size(), 5u * 512); // none was inverted by the shaking
  ASSERT_LT(before, 0.15);
  for (bool layered : { false, true })
  {
    TetSet set = start;
    if (!layered)
    {
      set.layerIndex.clear();
    }
    ThreadMonitor monitor(layered ? 3 : 1);
    const auto report = ImproveTets(set, {}, monitor);
    double after = 0;
    const auto now = Volumes(set, after);
    EXPECT_NEAR(now[0], volumes[0], 1e-11 * volumes[0]);
    EXPECT_NEAR(now[1], volumes[1], 1e-11 * volumes[1]);
    EXPECT_DOUBLE_EQ(report.leastQuality, after);
    EXPECT_GT(after, 0.15);
    EXPECT_GT(report.pointsMoved + report.facesFlipped + report.edgesRemoved, 0);
    EXPECT_EQ(Walls(set), Walls(start));
    for (std::size_t p = 0; p < set.points.size(); ++p)
    {
      EXPECT_TRUE(set.fixed[p] == 0 || set.points[p] == start.points[p]);
    }
    for (const auto& tet : set.tets)
    {
      const auto at = [&](std::size_t v) { return set.points[static_cast<std::size_t>(tet[v])]; };
      EXPECT_EQ(Orientation(at(0), at(1), at(2), at(3)), 1);
      for (std::size_t k = 1; layered && k < 4; ++k)
      {
        EXPECT_LE(std::abs(set.layerIndex[static_cast<std::size_t>(tet[0])] -
                           set.layerIndex[static_cast<std::size_t>(tet[k])]),
                  1);
      }
    }
  }
}

TEST(ImproveTets, PlantedSliversGo)
{
  // The middle of a good grid is drawn to where it makes needles (near another point), wedges (near an edge),
  // caps (near a face) and slivers (between two edges).
  TetSet good = ShakenGrid(4, 0);
  std::fill(good.groups.begin(), good.groups.end(), 1);
  const Vec3 middle{ 2, 2, 2 };
  const auto at = std::find(good.points.begin(), good.points.end(), middle) - good.points.begin();
  const std::vector<Vec3> targets{
    { 3, 2, 2 }, { 2.5, 2.5, 2 }, { 7.0 / 3, 7.0 / 3, 7.0 / 3 }, { 2.5, 2, 2.5 }
  };
  for (const Vec3& target : targets)
  {
    for (const bool isStuck : { false, true })
    {
      TetSet set = good;
      std::fill(set.fixed.begin(), set.fixed.end(), isStuck ? 1 : 0);
      set.layerIndex.clear();
      set.points[static_cast<std::size_t>(at)] = middle + 0.97 * (target - middle);
      double before = 0;
      const auto volumes = Volumes(set, before);
      ASSERT_GT(before, 0);
      ASSERT_LT(before, 0.1);
      const auto walls = Walls(set);
      ThreadMonitor monitor;
      const auto report = ImproveTets(set, {}, monitor);
      double after = 0;
      EXPECT_NEAR(Volumes(set, after)[0], volumes[0], 1e-11 * volumes[0]);
      EXPECT_EQ(Walls(set), walls);
      // What the points that must stay make cannot be good, but better.
      EXPECT_GT(after, isStuck ? before : 0.25) << target.x << " " << target.y;
      EXPECT_GT(report.edgesRemoved + report.facesFlipped + report.pointsMoved + report.pointsAdded +
                  report.pointsRemoved,
                0);
    }
  }
}

TEST(ImproveTets, PointsArePutInWhereNothingElseHelps)
{
  // Shaken so much that points which must stay leave reconnection without a way.
  TetSet set = ShakenGrid(8, 0.45);
  std::fill(set.fixed.begin(), set.fixed.end(), 1);
  TetSet without = set;
  double before = 0;
  const auto volumes = Volumes(set, before);
  const auto walls = Walls(set);
  ThreadMonitor monitor;
  ImproveTetsOptions options;
  options.pointsBelow = 0;
  const auto less = ImproveTets(without, options, monitor);
  EXPECT_EQ(less.pointsAdded, 0);
  EXPECT_GT(less.left, 0);
  const auto more = ImproveTets(set, {}, monitor);
  EXPECT_GT(more.pointsAdded, 0);
  EXPECT_EQ(set.points.size(), without.points.size() + static_cast<std::size_t>(more.pointsAdded));
  EXPECT_EQ(set.layerIndex.back(), -1);
  EXPECT_GE(more.leastQuality, less.leastQuality);
  double after = 0;
  EXPECT_NEAR(Volumes(set, after)[0], volumes[0], 1e-11 * volumes[0]);
  EXPECT_GT(after, before);
  EXPECT_EQ(Walls(set), walls);
  const auto poor = [](const TetSet& tets)
  {
    return std::count_if(tets.tets.begin(), tets.tets.end(),
                         [&](const auto& tet)
                         {
                           const auto at = [&](std::size_t v)
                           { return tets.points[static_cast<std::size_t>(tet[v])]; };
                           return TetQuality(at(0), at(1), at(2), at(3)) < 0.2;
                         });
  };
  EXPECT_LT(poor(set), poor(without));
}

TEST(ImproveTets, InterfacesStayEvenIfTheirPointsAreNotFixed)
{
  TetSet set = ShakenGrid(6, 0.3);
  const TetSet start = set;
  set.fixed.clear();
  ThreadMonitor monitor;
  ImproveTets(set, {}, monitor);
  EXPECT_EQ(Walls(set), Walls(start));
  for (std::size_t p = 0; p < set.points.size(); ++p)
  {
    EXPECT_TRUE(start.fixed[p] == 0 || set.points[p] == start.points[p]);
  }
}

TEST(ImproveTets, CancelLeavesASoundMesh)
{
  TetSet set = ShakenGrid(4, 0.3);
  ThreadMonitor monitor;
  monitor.Cancel();
  ImproveTets(set, {}, monitor);
  EXPECT_EQ(set.tets.size(), 5u * 64);
  TetSet none;
  ThreadMonitor other;
  EXPECT_EQ(ImproveTets(none, {}, other).left, 0);
}
