// SPDX-License-Identifier: BSD-3-Clause
// Volumes of a refined surface set back within the tolerance, and the places that lie beyond it.
#include "Search/SelfIntersection.h"
#include "Shapes.h"
#include "Surface/FarPlaces.h"
#include "Surface/RefinedVolumes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace lamina;

namespace
{

constexpr double tolerance = 0.05;

/// Two balls of one material: the points of the first 642 of radius 10, the rest of radius 1.
TriangleComplex TwoBalls()
{
  TriangleComplex surface;
  shapes::AddSphere(surface, {}, 10, 3, { 1, 0 });
  shapes::AddSphere(surface, { 20, 0, 0 }, 1, 3, { 1, 0 });
  surface.targetEdgeLength.assign(surface.points.size(), 1);
  ClassifyJunctions(surface);
  return surface;
}

double Farthest(const TriangleComplex& a, const TriangleComplex& b, double fromX)
{
  double most = 0;
  for (std::size_t p = 0; p < a.points.size(); ++p)
  {
    most = std::max(most, b.points[p].x > fromX ? Norm(a.points[p] - b.points[p]) : 0);
  }
  return most;
}

} // namespace

TEST(RefinedVolumes, AllShellsGetTheirsWhereTheyCan)
{
  const TriangleComplex start = TwoBalls();
  ThreadMonitor monitor(2);
  const InputSurface input(start, tolerance, 1, monitor);
  std::vector<double> targets = ShellVolumes(start, input.Sheets());
  ASSERT_EQ(targets.size(), 2u);
  targets[0] *= 1.001; // a height of 0.003
  targets[1] *= 0.95;  // of 0.017, more than edits leave for it
  TriangleComplex surface = start;
  RestoreRefinedVolumes(surface, input.Sheets(), targets, input, monitor);
  const std::vector<double> volumes = ShellVolumes(surface, input.Sheets());
  EXPECT_NEAR(volumes[0], targets[0], 1e-12 * targets[0]);
  EXPECT_NEAR(volumes[1], targets[1], 1e-12 * targets[1]);
  EXPECT_LE(Farthest(surface, start, -100), tolerance);
}

TEST(RefinedVolumes, WhatASmallPieceCannotHaveTheLargestTakes)
{
  const TriangleComplex start = TwoBalls();
  ThreadMonitor monitor(2);
  const InputSurface input(start, tolerance, 1, monitor);
  std::vector<double> targets = ShellVolumes(start, input.Sheets());
  targets[1] *= 1.4; // a height of 0.12: out of reach
  TriangleComplex surface = start;
  RestoreRefinedVolumes(surface, input.Sheets(), targets, input, monitor);
  const std::vector<double> volumes = ShellVolumes(surface, input.Sheets());
  EXPECT_LT(volumes[1], 1.2 * targets[1] / 1.4);
  EXPECT_GT(volumes[1], 1.05 * targets[1] / 1.4); // as far as it may
  const double sum = std::accumulate(targets.begin(), targets.end(), 0.0);
  EXPECT_NEAR(MaterialVolumes(surface, { 1 })[0], sum, 1e-12 * sum);
  EXPECT_LE(Farthest(surface, start, 15), tolerance);
  FarPlaces far(surface, input.Sheets(), input);
  EXPECT_TRUE(far.Find(monitor).empty());
  EXPECT_TRUE(FindIntersections(surface.points, surface.triangles, monitor).empty());
}

TEST(RefinedVolumes, NothingIsMovedIntoAnother)
{
  // The gap between the balls is narrower than what the tolerance would allow both of them.
  TriangleComplex start;
  shapes::AddSphere(start, {}, 1, 3, { 1, 0 });
  shapes::AddSphere(start, { 2.02, 0, 0 }, 1, 3, { 2, 0 });
  start.targetEdgeLength.assign(start.points.size(), 1);
  ClassifyJunctions(start);
  ThreadMonitor monitor(2);
  const InputSurface input(start, 0.2, 1, monitor);
  std::vector<double> targets = ShellVolumes(start, input.Sheets());
  for (double& target : targets)
  {
    target *= 1.08; // a height of 0.026, so that the balls would meet
  }
  TriangleComplex surface = start;
  RestoreRefinedVolumes(surface, input.Sheets(), targets, input, monitor);
  EXPECT_TRUE(FindIntersections(surface.points, surface.triangles, monitor).empty());
  const std::vector<double> volumes = ShellVolumes(surface, input.Sheets());
  for (std::size_t s = 0; s < targets.size(); ++s)
  {
    EXPECT_NEAR(volumes[s], targets[s], 1e-9 * targets[s]) << s; // the far sides make up for it
  }
}

TEST(FarPlaces, FindsWhatLeavesTheToleranceEitherWay)
{
  const TriangleComplex start = TwoBalls();
  ThreadMonitor monitor(2);
  const InputSurface input(start, tolerance, 1, monitor);
  TriangleComplex surface = start;
  FarPlaces far(surface, input.Sheets(), input);
  EXPECT_TRUE(far.Find(monitor).empty());
  const Vec3 place = surface.points[5];
  surface.points[5] = (1 + 0.9 * tolerance / 10) * place; // within
  EXPECT_TRUE(far.Find(monitor).empty());
  surface.points[5] = (1 + 1.1 * tolerance / 10) * place; // beyond
  std::vector<Id> star;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const Triangle& c = surface.triangles[t];
    if (std::find(c.begin(), c.end(), 5) != c.end())
    {
      star.push_back(static_cast<Id>(t));
    }
  }
  EXPECT_EQ(far.Find(monitor), star);
}
