// SPDX-License-Identifier: BSD-3-Clause
// Tets that no single operation betters, and the patches that they are worked on in.
#include "ShakenGrids.h"
#include "Volume/ImproveStuck.h"
#include "Volume/TetCavity.h"
#include "Volume/TetPatch.h"

using namespace lamina;
using namespace shaken;

namespace
{

double LeastShape(const TetSet& set)
{
  double least = 1;
  for (const auto& c : set.tets)
  {
    const auto at = [&](std::size_t k) { return set.points[static_cast<std::size_t>(c[k])]; };
    least = std::min(least, ShapeOfTet(at(0), at(1), at(2), at(3)));
  }
  return least;
}

/// A shaken grid in which the middle of every side is fixed where it was shaken to: its inner points are the
/// ones that may move.
TetSet HalfFixed()
{
  TetSet set = ShakenGrid(6, 0.36);
  set.layerIndex.clear();
  for (std::size_t p = 0; p < set.fixed.size(); p += 2)
  {
    set.fixed[p] = 1;
  }
  return set;
}

} // namespace

TEST(TetPatches, WhatIsTakenAndPutBackIsTheSame)
{
  TetSet set = ShakenGrid(6, 0.2);
  set.layerIndex.clear();
  double least = 0;
  const auto volumes = Volumes(set, least);
  const auto walls = Walls(set);
  TetPatches patches(set);
  TetSet patch;
  std::array<Id, 4> own;
  const std::array<Id, 4> before = set.tets[500];
  ASSERT_TRUE(patches.Take(500, 2, patch, own));
  EXPECT_GT(patch.tets.size(), 100u);
  EXPECT_LT(patch.tets.size(), set.tets.size() / 2);
  for (std::size_t k = 0; k < 4; ++k)
  {
    EXPECT_EQ(patch.points[static_cast<std::size_t>(own[k])],
              set.points[static_cast<std::size_t>(before[k])]);
  }
  // A point that a tet outside has is fixed.
  EXPECT_GT(std::count(patch.fixed.begin(), patch.fixed.end(), 1), 10);
  ASSERT_TRUE(SplitPart(patch, { own.begin(), own.end() }));
  patches.PutBack(patch);
  TetSet other;
  EXPECT_FALSE(patches.Take(500, 2, other, own)) << "it has been replaced";
  DropReplaced(set);
  EXPECT_EQ(set.tets.size(), 5u * 216 + 3);
  const auto now = Volumes(set, least);
  EXPECT_NEAR(now[0], volumes[0], 1e-9);
  EXPECT_NEAR(now[1], volumes[1], 1e-9);
  EXPECT_EQ(Walls(set), walls);
}

TEST(TetPatches, OnlyWhatIsInsideIsSplit)
{
  const TetSet start = ShakenGrid(2, 0.1);
  // The middle point of the grid lies between the groups: edges from it up to the top's middle are inside the
  // upper group, edges in the plane between them are not.
  const auto id = [](Id i, Id j, Id k) { return i + 3 * (j + 3 * k); };
  TetSet set = start;
  EXPECT_FALSE(SplitPart(set, { id(1, 1, 1), id(1, 0, 1) }));
  EXPECT_FALSE(SplitPart(set, { id(0, 0, 0), id(1, 0, 0) })); // on the boundary
  EXPECT_FALSE(SplitPart(set, { id(0, 0, 0), id(2, 2, 2) })); // no edge
  EXPECT_EQ(set.tets, start.tets);
  EXPECT_EQ(set.points, start.points);
  ASSERT_TRUE(SplitPart(set, { id(1, 1, 1), id(1, 1, 2) }));
  EXPECT_EQ(set.points.size(), start.points.size() + 1);
  double least = 0;
  const auto volumes = Volumes(set, least);
  EXPECT_GT(least, 0);
  double before = 0;
  const auto expected = Volumes(start, before);
  EXPECT_NEAR(volumes[0], expected[0], 1e-12);
  EXPECT_NEAR(volumes[1], expected[1], 1e-12);
  EXPECT_EQ(Walls(set), Walls(start));
}

TEST(ImproveStuck, GoesOnWhereSingleOperationsStop)
{
  ThreadMonitor monitor;
  TetSet start = HalfFixed();
  ImproveTetsOptions plain;
  plain.pointsBelow = 0; // so that there is something that stays poor
  ImproveTets(start, plain, monitor);
  const double before = LeastShape(start);
  double least = 0;
  const auto volumes = Volumes(start, least);
  ImproveStuckOptions options;
  options.gate = before + 0.05;
  TetSet set = start;
  const ImproveStuckReport report = ImproveStuck(set, options, monitor);
  EXPECT_GT(report.tried, 0);
  EXPECT_GT(report.bettered, 0);
  EXPECT_GE(LeastShape(set), options.gate);
  const auto now = Volumes(set, least);
  EXPECT_NEAR(now[0], volumes[0], 1e-9);
  EXPECT_NEAR(now[1], volumes[1], 1e-9);
  EXPECT_EQ(Walls(set), Walls(start));
  ASSERT_GE(set.points.size(), start.points.size());
  ASSERT_EQ(set.fixed.size(), set.points.size());
  for (std::size_t p = 0; p < start.points.size(); ++p)
  {
    EXPECT_TRUE(start.fixed[p] == 0 || set.points[p] == start.points[p]);
  }
  TetSet again = start;
  ThreadMonitor threads(3);
  ImproveStuck(again, options, threads);
  EXPECT_EQ(again.tets, set.tets);
  EXPECT_EQ(again.points, set.points);
}

TEST(ImproveStuck, PointsStayInTheirLayersOrBelongToNone)
{
  // Free points of layers so far from each other and from the rest that no edge may be made to them.
  ThreadMonitor monitor;
  TetSet start = HalfFixed();
  start.layerIndex.assign(start.points.size(), 0);
  for (std::size_t p = 0; p < start.points.size(); ++p)
  {
    start.layerIndex[p] = start.fixed[p] == 0 ? 2 * static_cast<int>(p) : 0;
  }
  ImproveTetsOptions plain;
  plain.layersBelow = 0;
  ImproveTets(start, plain, monitor);
  const double before = LeastShape(start);
  double least = 0;
  const auto volumes = Volumes(start, least);
  ImproveStuckOptions options;
  options.gate = before + 0.05;
  TetSet set = start;
  EXPECT_GT(ImproveStuck(set, options, monitor).bettered, 0);
  EXPECT_GT(LeastShape(set), before);
  const auto now = Volumes(set, least);
  EXPECT_NEAR(now[0], volumes[0], 1e-9);
  EXPECT_NEAR(now[1], volumes[1], 1e-9);
  EXPECT_EQ(Walls(set), Walls(start));
  ASSERT_EQ(set.layerIndex.size(), set.points.size());
  for (std::size_t p = 0; p < set.points.size(); ++p)
  {
    const bool isNew = p >= start.points.size();
    const bool isIn = !isNew && set.layerIndex[p] == start.layerIndex[p];
    EXPECT_TRUE(isIn || (set.layerIndex[p] == -1 && set.fixed[p] == 0)) << p;
  }
}

TEST(ImproveStuck, CancelLeavesASoundMesh)
{
  ThreadMonitor monitor;
  TetSet set = HalfFixed();
  double least = 0;
  const auto volumes = Volumes(set, least);
  monitor.Cancel();
  ImproveStuckOptions options;
  options.gate = 0.3;
  EXPECT_EQ(ImproveStuck(set, options, monitor).bettered, 0);
  const auto now = Volumes(set, least);
  EXPECT_NEAR(now[0], volumes[0], 1e-9);
}
