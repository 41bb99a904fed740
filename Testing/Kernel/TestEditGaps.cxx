// SPDX-License-Identifier: BSD-3-Clause
// Edits must not bring sheets near to each other, nor fold triangles onto their neighbours.
#include "Mesh/JunctionGraph.h"
#include "RefinementMeasures.h"
#include "Shapes.h"
#include "Surface/EditableSurface.h"
#include "Surface/RefinedVolumes.h"
#include "Surface/Refinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace lamina;

namespace
{

Id PointAt(const TriangleComplex& surface, const Vec3& place)
{
  const auto found = std::find_if(surface.points.begin(), surface.points.end(),
                                  [&](const Vec3& p) { return Norm(p - place) < 1e-9; });
  EXPECT_NE(found, surface.points.end());
  return static_cast<Id>(found - surface.points.begin());
}

/// The long edge of a bent quad of the lower box, and the box above it with a point that hangs down to `tip`
/// over the edge's middle. Swapping the edge for the upper diagonal brings the lower box 0.3 nearer.
struct BentQuad
{
  explicit BentQuad(double tip)
  {
    shapes::AddBox(surface, { 0, 0, -2 }, { 4, 4, 0 }, { { 4, 4, 2 } }, { 1, 0 });
    a = PointAt(surface, { 1, 1, 0 });
    b = PointAt(surface, { 2, 2, 0 });
    surface.points[static_cast<std::size_t>(a)] = { 0.8, 0.8, 0 };
    surface.points[static_cast<std::size_t>(b)] = { 2.2, 2.2, 0 };
    surface.points[static_cast<std::size_t>(PointAt(surface, { 2, 1, 0 }))].z = 0.3;
    surface.points[static_cast<std::size_t>(PointAt(surface, { 1, 2, 0 }))].z = 0.3;
    shapes::AddBox(surface, { -0.5, -0.5, 1 }, { 4.5, 4.5, 3 }, { { 5, 5, 2 } }, { 2, 0 });
    surface.points[static_cast<std::size_t>(PointAt(surface, { 1.5, 1.5, 1 }))].z = tip;
    surface.targetEdgeLength.assign(surface.points.size(), 1);
    ClassifyJunctions(surface);
  }
  bool Swaps(bool keepGaps) const
  {
    ThreadMonitor monitor;
    InputSurface input(this->surface, 1, 1, monitor);
    if (keepGaps)
    {
      input.KeepGaps();
    }
    EditableSurface edited(input, 0.7, 1.4);
    return edited.Swap(this->a, this->b);
  }

  TriangleComplex surface;
  Id a;
  Id b;
};

/// Two plates of the same waves, one above the other at a distance, between two materials and background.
TriangleComplex Waves(double distance, int upper)
{
  TriangleComplex surface;
  const std::array<int, 3> steps{ { 24, 24, 4 } };
  shapes::AddBox(surface, { 0, 0, -4 }, { 24, 24, 0 }, steps, { 1, 0 });
  shapes::AddBox(surface, { 0, 0, distance }, { 24, 24, 4 + distance }, steps, { upper, 0 });
  for (Vec3& p : surface.points)
  {
    p.z += 0.5 * std::sin(1.1 * p.x) * std::cos(0.9 * p.y);
  }
  return surface;
}

} // namespace

TEST(EditGaps, ASwapThatWouldBringSheetsNearIsRefused)
{
  EXPECT_TRUE(BentQuad(0.45).Swaps(false)); // nothing else is against it
  EXPECT_FALSE(BentQuad(0.45).Swaps(true)); // from 0.45 to 0.15
  EXPECT_TRUE(BentQuad(0.75).Swaps(true));  // from 0.75 to 0.45, more than a quarter edge
}

TEST(EditGaps, WhatCountsAsNear)
{
  ThreadMonitor monitor(2);
  for (const int upper : { 1, 2 })
  {
    TriangleComplex surface = Waves(6, upper);
    surface.targetEdgeLength.assign(surface.points.size(), 1);
    InputSurface input(surface, 0.5, 1, monitor);
    EXPECT_EQ(input.LeastGap(1), 0); // nothing, unless it is asked for
    input.KeepGaps();
    // Targets count around a single material, up to four mean edges; else up to a voxel.
    const double most = (upper == 1 ? 4 : 1.1) * input.MeanEdge();
    for (const double target : { 0.5, 3.0, 9.0 })
    {
      EXPECT_DOUBLE_EQ(input.LeastGap(target), 0.26 * std::min(target, most));
    }
  }
}

TEST(EditGaps, CoarseEdgesAndAWideToleranceLeaveTheSheetsApart)
{
  for (const double distance : { 0.4, 1.0 })
  {
    for (const double target : { 0.8, 3.0 })
    {
      TriangleComplex surface = Waves(distance, 2);
      surface.targetEdgeLength.assign(surface.points.size(), target);
      const TriangleComplex before = surface;
      ThreadMonitor monitor(2);
      RefineSurfaceOptions options;
      options.tolerance = 0.6;
      ASSERT_TRUE(RefineSurface(surface, options, monitor));
      const double unit = std::min(1.0, target); // a voxel, or the target if that is less
      const auto was = measures::MeasureNearness(before, unit, monitor);
      const auto is = measures::MeasureNearness(surface, unit, monitor);
      EXPECT_TRUE(measures::StayApart(was, is)) << distance << ": " << was.gap << " -> " << is.gap;
      EXPECT_EQ(measures::CountNarrowed(before, surface, unit, monitor), 0);
      EXPECT_TRUE(measures::StayOpen(was, is)) << was.angle << " -> " << is.angle;
      EXPECT_NE(surface.triangles.size(), before.triangles.size());
    }
  }
}

TEST(EditGaps, NothingElseWouldKeepTheSheetsApart)
{
  TriangleComplex surface = Waves(0.4, 2);
  surface.targetEdgeLength.assign(surface.points.size(), 3);
  ClassifyJunctions(surface);
  ThreadMonitor monitor(2);
  const auto was = measures::MeasureNearness(surface, 1, monitor);
  RefineSurfaceOptions options;
  options.tolerance = 0.6;
  for (const bool keepGaps : { false, true })
  {
    InputSurface input(surface, options.tolerance, 1, monitor);
    if (keepGaps)
    {
      input.KeepGaps();
    }
    EditableSurface edited(input, options.mergeRatio, options.splitRatio);
    Refinement refinement(edited, options, monitor);
    refinement.Iterate();
    TriangleComplex refined;
    edited.Write(refined, monitor);
    const auto is = measures::MeasureNearness(refined, 1, monitor);
    EXPECT_EQ(measures::StayApart(was, is), keepGaps) << was.gap << " -> " << is.gap;
    EXPECT_EQ(measures::CountNarrowed(surface, refined, 1, monitor) == 0, keepGaps);
  }
}

TEST(EditGaps, SettingVolumesBackKeepsSheetsApartToo)
{
  TriangleComplex surface = Waves(0.6, 2);
  surface.targetEdgeLength.assign(surface.points.size(), 1);
  ClassifyJunctions(surface);
  const TriangleComplex before = surface;
  ThreadMonitor monitor(2);
  InputSurface input(surface, 0.5, 1, monitor);
  input.KeepGaps();
  std::vector<double> targets = ShellVolumes(surface, input.Sheets());
  for (double& target : targets)
  {
    target += 300; // a height of 0.2 on all sides
  }
  RestoreRefinedVolumes(surface, input.Sheets(), targets, input, monitor);
  const auto was = measures::MeasureNearness(before, 1, monitor);
  const auto is = measures::MeasureNearness(surface, 1, monitor);
  EXPECT_TRUE(measures::StayApart(was, is)) << was.gap << " -> " << is.gap;
  EXPECT_FALSE(surface.points == before.points);
}
