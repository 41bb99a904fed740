// SPDX-License-Identifier: BSD-3-Clause
#include "ShakenGrids.h"
#include "Volume/ChangeClock.h"

using namespace lamina;
using namespace shaken;

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

TEST(ChangeClock, KnowsWhatHasChangedSince)
{
  ChangeClock clock;
  const std::size_t start = clock.Now();
  EXPECT_FALSE(clock.HasChangedSince(7, start)) << "never marked";
  clock.Mark({ { 3, 1, 4, 7 } });
  const std::size_t first = clock.Now();
  EXPECT_TRUE(clock.HasChangedSince(7, start));
  EXPECT_FALSE(clock.HasChangedSince(7, first));
  EXPECT_FALSE(clock.HasChangedSince(2, start));
  clock.Mark({ { 2, 3, 900, 5 } });
  EXPECT_TRUE(clock.HasChangedSince(3, first));
  EXPECT_TRUE(clock.HasChangedSince(900, first));
  EXPECT_FALSE(clock.HasChangedSince(7, first));
}
