// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"
#include "Volume/GradedPoints.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace lamina;

namespace
{

/// Points handed to the core of a flat box of edges 0.5, `gap` high, with layers of `height` behind its
/// faces.
std::vector<Vec3> InBox(double gap, double height)
{
  TriangleComplex surface;
  shapes::AddBox(surface, { 0, 0, 0 }, { 5, 5, gap }, { { 10, 10, 1 } }, { 1, 0 });
  surface.layerHeight.assign(surface.points.size(), height);
  ThreadMonitor monitor(2);
  return GradedPoints(surface, monitor);
}

} // namespace

TEST(GradedPoints, StandFourLayersAboveThinPrisms)
{
  Id inner = 0;
  for (const Vec3& p : InBox(5, 0.05))
  {
    const double wall = std::min(p.z, 5 - p.z);
    const double side = std::min({ p.x, p.y, 5 - p.x, 5 - p.y });
    inner += side > 0.4 ? 1 : 0;
    EXPECT_TRUE(side < 0.4 || std::abs(wall - 0.2) < 1e-12) << p.x << " " << p.y << " " << p.z;
  }
  EXPECT_GT(inner, 50);
  // Not flatter than a quarter of the edges, whose mean is 0.57.
  for (const Vec3& p : InBox(5, 1e-4))
  {
    const double side = std::min({ p.x, p.y, 5 - p.x, 5 - p.y });
    EXPECT_TRUE(side < 0.4 || std::min(p.z, 5 - p.z) > 0.12) << p.x << " " << p.y << " " << p.z;
  }
  EXPECT_TRUE(InBox(5, 0.3).empty()) << "high prisms need none";
  EXPECT_TRUE(InBox(5, 0).empty()) << "no layers, no points";
}

TEST(GradedPoints, StandInTheMiddleOfGaps)
{
  const std::vector<Vec3> points = InBox(0.36, 0.05); // where they would reach past the middle
  EXPECT_GT(points.size(), 30u);
  for (const Vec3& p : points)
  {
    const double side = std::min({ p.x, p.y, 5 - p.x, 5 - p.y });
    EXPECT_TRUE(side < 0.4 || std::abs(p.z - 0.18) < 1e-12) << p.x << " " << p.y << " " << p.z;
  }
  for (const Vec3& p : InBox(0.1, 0.05))
  {
    EXPECT_LT(std::min({ p.x, p.y, 5 - p.x, 5 - p.y }), 0.4)
      << "flat tetrahedra would be worse than long ones";
  }
}
