// SPDX-License-Identifier: BSD-3-Clause
// The front that is asked again and again against tests of everything.
#include "Search/Clearance.h"
#include "Search/SelfIntersection.h"
#include "Shapes.h"
#include "Volume/FrontCheck.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace lamina;

namespace
{

std::size_t U(Id i)
{
  return static_cast<std::size_t>(i);
}

/// The same questions to everything, in the way that FrontCheck asks them of what changed.
std::set<Id> AllIntersecting(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                             Monitor& monitor)
{
  std::set<Id> found;
  for (const auto& pair : FindIntersections(points, triangles, monitor))
  {
    for (Id t : pair)
    {
      found.insert(triangles[U(t)].begin(), triangles[U(t)].end());
    }
  }
  return found;
}

} // namespace

TEST(FrontCheck, FindsWhatATestOfAllFinds)
{
  ThreadMonitor monitor(2);
  TriangleComplex surface;
  shapes::AddCylinder(surface, { 0, 0, 0 }, 1, 3, 24, 18, { 1, 0 });
  const Wall wall = MakeWall(surface, 1);
  FrontCheck check(wall);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coin(0, 1);
  // Points begin in disorder, far past each other, and go home step by step, some of them at a time.
  std::vector<Vec3> front = wall.points;
  for (Vec3& p : front)
  {
    p = p + Vec3{ coin(random) - 0.5, coin(random) - 0.5, coin(random) - 0.5 } * 0.8;
  }
  Id questions = 0;
  std::size_t first = 0;
  for (; questions < 80; ++questions)
  {
    check.Move(front, monitor);
    const std::vector<double> edges = MeanEdgesAtPoints(front, wall.triangles);
    std::vector<double> gaps(front.size());
    for (std::size_t v = 0; v < front.size(); ++v)
    {
      gaps[v] = 0.2 * edges[v];
      EXPECT_NEAR(check.EdgeAt(static_cast<Id>(v)), edges[v], 1e-12);
    }
    for (Id v : check.Touched())
    {
      check.SetGap(v, 0.2 * check.EdgeAt(v));
    }
    const std::set<Id> all = AllIntersecting(front, wall.triangles, monitor);
    const std::vector<Id> found = check.Intersecting(monitor);
    EXPECT_EQ(std::set<Id>(found.begin(), found.end()), all) << "question " << questions;
    const std::vector<double> clearance = PointClearances(front, wall.triangles, gaps, monitor);
    std::set<Id> near;
    for (const auto& [v, distance] : check.TooNear(monitor))
    {
      EXPECT_NEAR(distance, clearance[U(v)], 1e-12);
      near.insert(v);
    }
    std::set<Id> allNear;
    for (std::size_t v = 0; v < front.size(); ++v)
    {
      if (clearance[v] < gaps[v])
      {
        allNear.insert(static_cast<Id>(v));
      }
    }
    EXPECT_EQ(near, allNear) << "question " << questions;
    first = questions == 0 ? all.size() : first;
    // What was found must move, as the check demands; of the rest one point now and then.
    std::set<Id> moving = all;
    moving.insert(allNear.begin(), allNear.end());
    for (Id v = 0; v < static_cast<Id>(front.size()); ++v)
    {
      if (moving.count(v) > 0 || coin(random) < 0.02)
      {
        front[U(v)] = 0.7 * front[U(v)] + 0.3 * wall.points[U(v)];
      }
    }
  }
  EXPECT_GT(first, front.size() / 4); // there was something to find
}
