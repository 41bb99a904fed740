// SPDX-License-Identifier: BSD-3-Clause
#include "Images.h"
#include "Mesh/VolumeCorrection.h"
#include "Shapes.h"
#include "Surface/ExtractInterfaces.h"

#include <gtest/gtest.h>

#include <random>

using namespace lamina;

namespace
{

constexpr double Pi = 3.14159265358979323846;

/// Moves the points of sheets (all, without a classification) by up to `by` along every axis.
void Perturb(TriangleComplex& surface, double by, unsigned seed = 1)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-by, by);
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    if (surface.junctionKind.empty() || surface.junctionKind[p] == JunctionSheet)
    {
      surface.points[p] += { shift(random), shift(random), shift(random) };
    }
  }
}

void ExpectRestored(TriangleComplex& surface, double by)
{
  const SheetGraph graph = MakeSheetGraph(surface);
  const auto targets = ShellVolumes(surface, graph);
  Perturb(surface, by);
  const auto moved = ShellVolumes(surface, graph);
  EXPECT_NE(moved, targets);
  EXPECT_LT(RestoreVolumes(surface, graph, targets), 1e-12);
  const auto back = ShellVolumes(surface, graph);
  for (std::size_t s = 0; s < targets.size(); ++s)
  {
    EXPECT_NEAR(back[s], targets[s], 1e-12 * std::abs(targets[s])) << s;
  }
}

TriangleComplex ShellSurface()
{
  TriangleComplex surface;
  shapes::AddSphere(surface, {}, 2, 3, { 2, 0 });
  shapes::AddSphere(surface, {}, 1, 3, { 1, 2 });
  return surface;
}

TriangleComplex SectorsSurface()
{
  ThreadMonitor monitor;
  TriangleComplex surface;
  EXPECT_TRUE(ExtractInterfaces(images::Sectors(16, 6.3, false), surface, {}, monitor));
  return surface;
}

} // namespace

TEST(VolumeCorrection, VolumesAreTheDivergenceTheorems)
{
  TriangleComplex box;
  shapes::AddBox(box, { 1000, 1000, 1000 }, { 1001, 1002, 1003 }, { { 2, 3, 4 } }, { 1, 0 });
  EXPECT_NEAR(MaterialVolumes(box, { 1 })[0], 6, 1e-12);
  const auto volumes = MaterialVolumes(ShellSurface(), { 1, 2, 3 });
  EXPECT_NEAR(volumes[0], 4 * Pi / 3, 0.1);
  EXPECT_NEAR(volumes[1], 7 * volumes[0], 1e-12 * volumes[1]);
  EXPECT_EQ(volumes[2], 0);
}

TEST(VolumeCorrection, ShellsAndSheets)
{
  TriangleComplex surface = ShellSurface();
  SheetGraph graph = MakeSheetGraph(surface);
  EXPECT_EQ(graph.shellsOfSheet.size(), 2u);
  EXPECT_EQ(graph.ShellCount(), 3); // the inside of 1, both sides of 2
  const auto volumes = ShellVolumes(surface, graph);
  double of2 = 0;
  for (std::size_t s = 0; s < volumes.size(); ++s)
  {
    of2 += graph.materialOfShell[s] == 2 ? volumes[s] : 0;
  }
  EXPECT_NEAR(of2, MaterialVolumes(surface, { 2 })[0], 1e-12);

  surface = SectorsSurface();
  graph = MakeSheetGraph(surface);
  EXPECT_EQ(graph.ShellCount(), 3);
  // Between the materials three, round the outside three, and three in each of the two border planes.
  EXPECT_EQ(graph.shellsOfSheet.size(), 12u);
}

TEST(VolumeCorrection, SphereComesBack)
{
  TriangleComplex surface;
  shapes::AddSphere(surface, { 50, -20, 7 }, 3, 4, { 1, 0 });
  ExpectRestored(surface, 0.05);
}

TEST(VolumeCorrection, ShellComesBack)
{
  TriangleComplex surface = ShellSurface();
  ExpectRestored(surface, 0.03);
}

TEST(VolumeCorrection, SectorsComeBackAndJunctionsStay)
{
  TriangleComplex surface = SectorsSurface();
  const TriangleComplex before = surface;
  ExpectRestored(surface, 0.2);
  int stayed = 0;
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    if (surface.junctionKind[p] != JunctionSheet)
    {
      ++stayed;
      EXPECT_EQ(surface.points[p], before.points[p]);
    }
  }
  EXPECT_GT(stayed, 100);
}

TEST(VolumeCorrection, PointsWithoutReachStay)
{
  TriangleComplex surface = ShellSurface();
  const SheetGraph graph = MakeSheetGraph(surface);
  const auto targets = ShellVolumes(surface, graph);
  Perturb(surface, 0.03);
  std::vector<double> reach(surface.points.size());
  for (std::size_t p = 0; p < reach.size(); ++p)
  {
    reach[p] = surface.points[p].x > 0 ? 0 : 1;
  }
  const TriangleComplex before = surface;
  EXPECT_LT(RestoreVolumes(surface, graph, targets, reach), 1e-12);
  for (std::size_t p = 0; p < reach.size(); ++p)
  {
    EXPECT_EQ(surface.points[p] == before.points[p], reach[p] == 0) << p;
  }
}

TEST(VolumeCorrection, WhatCannotMoveIsTold)
{
  TriangleComplex surface;
  shapes::AddSphere(surface, {}, 1, 2, { 1, 0 });
  const SheetGraph graph = MakeSheetGraph(surface);
  auto targets = ShellVolumes(surface, graph);
  targets[0] *= 1.25;
  const auto before = surface.points;
  const std::vector<double> none(surface.points.size(), 0);
  EXPECT_NEAR(RestoreVolumes(surface, graph, targets, none), 0.2, 1e-12);
  EXPECT_EQ(surface.points, before);
  EXPECT_LT(RestoreVolumes(surface, graph, targets), 1e-12);
  EXPECT_NEAR(MaterialVolumes(surface, { 1 })[0], targets[0], 1e-12);
}

TEST(VolumeCorrection, WhatSomeCannotDoOthersDo)
{
  // Half of the outer sphere may move by a hundredth of what the uniform height would be.
  TriangleComplex surface = ShellSurface();
  const SheetGraph graph = MakeSheetGraph(surface);
  auto targets = ShellVolumes(surface, graph);
  for (double& target : targets)
  {
    target *= 1.01;
  }
  const TriangleComplex before = surface;
  std::vector<double> reach(surface.points.size(), 1);
  for (std::size_t p = 0; p < reach.size(); ++p)
  {
    reach[p] = surface.points[p].x > 0 ? 1e-4 : 0.05;
  }
  EXPECT_LT(RestoreVolumes(surface, graph, targets, reach), 1e-12);
  const auto farthest = [&](bool held)
  {
    double most = 0;
    for (std::size_t p = 0; p < reach.size(); ++p)
    {
      const double moved = Norm(surface.points[p] - before.points[p]);
      EXPECT_LE(moved, reach[p] * (1 + 1e-9)) << p;
      most = std::max(most, (before.points[p].x > 0) == held ? moved : 0);
    }
    return most;
  };
  EXPECT_NEAR(farthest(true), 1e-4, 1e-9);
  EXPECT_GT(farthest(false), 0.006); // twice the height that all together would have needed
}

TEST(VolumeCorrection, BeyondAllReachEveryPointGoesAsFarAsItMay)
{
  TriangleComplex surface;
  shapes::AddSphere(surface, {}, 1, 3, { 1, 0 });
  const SheetGraph graph = MakeSheetGraph(surface);
  auto targets = ShellVolumes(surface, graph);
  targets[0] *= 1.25;
  const auto before = surface.points;
  const std::vector<double> reach(before.size(), 0.01);
  EXPECT_NEAR(RestoreVolumes(surface, graph, targets, reach), 1 - 1.01 * 1.01 * 1.01 / 1.25, 1e-4);
  for (std::size_t p = 0; p < before.size(); ++p)
  {
    EXPECT_NEAR(Norm(surface.points[p] - before[p]), 0.01, 1e-12) << p;
  }
}
