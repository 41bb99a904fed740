// SPDX-License-Identifier: BSD-3-Clause
// Feature sizes of shapes whose truth is known, and what follows from them.
#include "Shapes.h"
#include "Sizing/FeatureSize.h"
#include "Sizing/GradientLimit.h"
#include "Sizing/Thickness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace lamina;

namespace
{

constexpr double Pi = 3.14159265358979323846;

/// The raw thickness of a material against the truth: the largest relative error at the chosen points.
template<typename Choose>
double WorstThickness(const TriangleComplex& surface, int material, double truth, Choose&& choose)
{
  ThreadMonitor monitor(2);
  const Lists star = TrianglesOfPoints(static_cast<Id>(surface.points.size()), surface.triangles);
  const auto ids = PointsOfMaterial(surface, material);
  const auto values = MeasureThickness(surface, star, material, ids, 100 * truth, 15, monitor);
  double worst = 0;
  int count = 0;
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    if (choose(surface.points[static_cast<std::size_t>(ids[i])]))
    {
      worst = std::max(worst, std::abs(values[i] / truth - 1));
      ++count;
    }
  }
  EXPECT_GT(count, 10);
  return worst;
}

const auto Everywhere = [](const Vec3&) { return true; };

FeatureSizeOptions Wide(double minimum, double maximum, double gradient = 100)
{
  FeatureSizeOptions options;
  options.minimum = minimum;
  options.maximum = maximum;
  options.gradient = gradient;
  options.nodesPerCircumference = 0;
  return options;
}

FeatureSizeReport Size(TriangleComplex& surface, const FeatureSizeOptions& options, int threads = 2)
{
  ThreadMonitor monitor(threads);
  const auto report = ComputeFeatureSize(surface, options, monitor);
  EXPECT_TRUE(report) << (report ? "" : report.GetError().message);
  return report ? *report : FeatureSizeReport{};
}

double Least(const std::vector<double>& values)
{
  return *std::min_element(values.begin(), values.end());
}
double Largest(const std::vector<double>& values)
{
  return *std::max_element(values.begin(), values.end());
}

/// A flat plate of 1 with its faces at z = 0 and `thickness`.
TriangleComplex Plate(double thickness, int steps = 20)
{
  TriangleComplex surface;
  shapes::AddBox(surface, { 0, 0, 0 }, { 10, 10, thickness }, { { steps, steps, 1 } }, { 1, 0 });
  return surface;
}

bool InPlate(const Vec3& p)
{
  return std::abs(p.x - 5) < 3 && std::abs(p.y - 5) < 3;
}

/// About 5,000 points of two nested wavy spheres.
TriangleComplex Wavy()
{
  TriangleComplex surface;
  shapes::AddSphere(surface, { 0, 0, 0 }, 1, 5, { 1, 2 });
  shapes::AddSphere(surface, { 0.05, 0, 0 }, 1.3, 4, { 2, 0 });
  shapes::AddSphere(surface, { 4, 0, 0 }, 0.8, 3, { 3, 0 });
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    Vec3& x = surface.points[p];
    x = x * (1 + 0.04 * std::sin(7 * x.x + 1) * std::cos(5 * x.y) + 0.02 * std::sin(9 * x.z));
  }
  return surface;
}

} // namespace

TEST(FeatureSizeShapes, RawSizesAreWithinOnePercent)
{
  TriangleComplex sphere;
  shapes::AddSphere(sphere, { 1, 2, 3 }, 2, 4, { 1, 0 });
  shapes::JitterSphere(sphere, { 1, 2, 3 }, 2, 0.02);
  EXPECT_LT(WorstThickness(sphere, 1, 4, Everywhere), 0.01);

  TriangleComplex cylinder;
  shapes::AddClosedTube(cylinder, { 0, 0, 0 }, 1, 8, 0.1, 0.25, { 1, 0 });
  EXPECT_LT(WorstThickness(cylinder, 1, 2, [](const Vec3& p) { return p.z > 2 && p.z < 6; }), 0.01);

  TriangleComplex torus;
  shapes::AddTorus(torus, 3, 1, 0.1, 0.25, { 1, 0 });
  EXPECT_LT(WorstThickness(torus, 1, 2, Everywhere), 0.01);

  EXPECT_LT(WorstThickness(Plate(0.5), 1, 0.5, InPlate), 0.01);

  TriangleComplex shell;
  shapes::AddSphere(shell, { 0, 0, 0 }, 1, 5, { 1, 2 });
  shapes::AddSphere(shell, { 0, 0, 0 }, 1.3, 5, { 2, 0 });
  EXPECT_LT(WorstThickness(shell, 2, 0.3, Everywhere), 0.01);
  EXPECT_LT(WorstThickness(shell, 1, 2, Everywhere), 0.01);
}

TEST(FeatureSizeShapes, TheGapBetweenTwoTubesIsTheSizeOutside)
{
  // Radius 1, a gap of 0.1 where y = 0; there the material between is seen from both.
  TriangleComplex surface;
  shapes::AddClosedTube(surface, { 0, 0, 0 }, 1, 4, 0.04, 0, { 1, 2 });
  shapes::AddClosedTube(surface, { 2.1, 0, 0 }, 1, 4, 0.04, 0, { 1, 2 });
  shapes::AddBox(surface, { -6, -6, -4 }, { 8, 6, 8 }, { { 9, 9, 9 } }, { 2, 0 });
  const auto facing = [](const Vec3& p)
  { return p.z > 1 && p.z < 3 && std::abs(p.y) < 0.01 && p.x > 0.9 && p.x < 1.2; };
  EXPECT_LT(WorstThickness(surface, 2, 0.1, facing), 0.01);
  EXPECT_LT(WorstThickness(surface, 1, 2, facing), 0.01);
}

TEST(FeatureSizeShapes, CurvatureGivesCirclesTheirNodes)
{
  TriangleComplex surface;
  shapes::AddTorus(surface, 3, 1, 0.1, 0.2, { 1, 0 });
  FeatureSizeOptions options = Wide(1e-3, 9);
  options.layers = 2; // plain: edges of 2 * 2 / 2 = 2, three around the tube
  EXPECT_EQ(Size(surface, options).curved, 0);
  EXPECT_NEAR(Least(surface.targetEdgeLength), 2, 0.02);
  options.nodesPerCircumference = 16;
  const auto report = Size(surface, options);
  EXPECT_EQ(report.curved, static_cast<Id>(surface.points.size()));
  EXPECT_NEAR(report.strongestCurvature, 1, 0.02);
  for (double edge : { Least(surface.targetEdgeLength), Largest(surface.targetEdgeLength) })
  {
    EXPECT_NEAR(edge, 2 * Pi / 16.5, 0.02 * 2 * Pi / 16.5);
  }
  EXPECT_NEAR(Least(surface.featureSize), 2 * Pi / 16.5, 0.01) << "edge over ratio, which is 1";
  EXPECT_NEAR(Least(surface.thickness), 2, 0.02) << "layers keep the thickness";
  // Where thickness already gives more nodes, nothing changes; nor below the minimum.
  options.layers = 12; // 2 * 2 / 12: 19 around
  EXPECT_EQ(Size(surface, options).curved, 0);
  options.layers = 2;
  options.minimum = 1.5;
  Size(surface, options);
  EXPECT_NEAR(Least(surface.featureSize), 1.5, 1e-12);
}

TEST(FeatureSizeShapes, MaterialsAskForThemselvesAndTheStricterSideGoverns)
{
  TriangleComplex surface;
  shapes::AddSphere(surface, { 0, 0, 0 }, 1, 4, { 1, 2 });
  shapes::AddSphere(surface, { 0, 0, 0 }, 1.5, 4, { 2, 0 });
  const std::size_t inner = surface.points.size() / 2;
  const auto edges = [&](const FeatureSizeOptions& options)
  {
    Size(surface, options);
    const auto& h = surface.targetEdgeLength;
    return std::array<double, 2>{ { h[0], h[inner] } };
  };
  FeatureSizeOptions options = Wide(1e-3, 9);
  auto h = edges(options); // the shell of 2, 0.5 thick, governs both sides
  EXPECT_NEAR(h[0], 0.5 / 3, 0.01 * h[0]);
  EXPECT_NEAR(h[1], 0.5 / 3, 0.01 * h[1]);
  options.materials = { { 2, 1, 0, 0, 0 } }; // one layer of anisotropy 2: 1.0; the ball of 1: 2 / 3
  h = edges(options);
  EXPECT_NEAR(h[0], 2.0 / 3, 0.01 * h[0]);
  EXPECT_NEAR(h[1], 1, 0.01 * h[1]);
  options.materials = { { 2, 0, 4, 0, 0.25 }, { 1, 3, 0.5, 4, 0 } };
  h = edges(options); // 2 is cut to 0.25: 0.25 * 4 / 6; 1 is raised to 4: 4 * 0.5 / 3
  EXPECT_NEAR(h[0], 1.0 / 6, 1e-12);
  EXPECT_NEAR(h[1], 1.0 / 6, 1e-12);
  EXPECT_NEAR(surface.thickness[0], 2, 0.02) << "the minimum is for edges, not for layers";
  options.materials = { { 2, 0, 4, 5, 6 }, { 1, 3, 0.5, 3, 0 } };
  h = edges(options); // 2 is raised to 5: 20 / 6, but no more than 8 layers of 0.5 / 6; 1 gives 0.5
  EXPECT_NEAR(h[0], 0.5, 1e-12);
  EXPECT_NEAR(h[1], 8 * 0.5 / 6, 0.01);
}

TEST(FeatureSizeShapes, ThinWallsHoldEdgesShort)
{
  TriangleComplex surface = Plate(0.1);
  FeatureSizeOptions options = Wide(3, 6);
  auto report = Size(surface, options);
  EXPECT_NEAR(Least(surface.targetEdgeLength), 8 * 0.1 / 6, 1e-12) << "8 thicknesses of a layer";
  EXPECT_NEAR(Least(surface.featureSize), 3, 1e-12);
  EXPECT_GT(report.thinWalls, 100);
  options.edgePerLayer = 1000;
  report = Size(surface, options);
  EXPECT_NEAR(Least(surface.targetEdgeLength), 1, 1e-12);
  EXPECT_EQ(report.thinWalls, 0);
}

TEST(FeatureSizeShapes, BorderPlanesAreNoWallsAndSendNoRays)
{
  // A plate cut off by border planes around: only its two faces are walls.
  TriangleComplex surface = Plate(0.5);
  surface.patchNames = { "wall", "border_1", "opening_1" };
  for (const Triangle& t : surface.triangles)
  {
    const Vec3 n = Normalized(AreaVector2(surface.points, t));
    surface.patches.push_back(std::abs(n.x) > 0.5 ? 1 : (std::abs(n.y) > 0.5 ? 2 : 0));
  }
  EXPECT_LT(WorstThickness(surface, 1, 0.5, Everywhere), 1e-9) << "the rims are points of the faces";
  // A node amid a border plane has no ray of its own: the slope from the walls gives its size.
  TriangleComplex box;
  shapes::AddBox(box, { 0, 0, 0 }, { 4, 1, 4 }, { { 8, 2, 8 } }, { 1, 0 });
  box.patchNames = { "wall", "border_1" };
  for (const Triangle& t : box.triangles)
  {
    const Vec3 n = Normalized(AreaVector2(box.points, t));
    box.patches.push_back(std::abs(n.y) > 0.5 ? 0 : 1);
  }
  Size(box, Wide(1e-3, 9, 0.5));
  int amid = 0;
  for (std::size_t p = 0; p < box.points.size(); ++p)
  {
    const bool isAmid = std::abs(box.points[p].y - 0.5) < 0.1;
    amid += isAmid;
    EXPECT_NEAR(box.thickness[p], isAmid ? 1.25 : 1, 1e-9);
  }
  EXPECT_EQ(amid, 32);
}

TEST(FeatureSizeShapes, LimitedFieldAgreesWithAllPairs)
{
  TriangleComplex surface = Wavy();
  ASSERT_GT(surface.points.size(), 5000u);
  const double gradient = 0.3;
  Size(surface, Wide(1e-3, 9, gradient));
  const std::size_t count = surface.points.size();
  std::vector<Id> ids(count);
  std::iota(ids.begin(), ids.end(), Id{ 0 });
  ThreadMonitor monitor(2);
  // A rough field on them, limited, is the least over all points; and once more changes nothing.
  std::vector<double> rough(count);
  for (std::size_t p = 0; p < count; ++p)
  {
    rough[p] = 0.2 + std::abs(std::sin(1234.5 * static_cast<double>(p))) + (p % 997 == 0 ? -0.15 : 0.0);
  }
  std::vector<double> limited = rough;
  LimitGradient(surface.points, ids, gradient, limited, monitor);
  double worst = 0;
  double steepest = 0;
  for (std::size_t p = 0; p < count; ++p)
  {
    double least = rough[p];
    for (std::size_t q = 0; q < count; ++q)
    {
      const double way = gradient * Norm(surface.points[p] - surface.points[q]);
      least = std::min(least, rough[q] + way);
      steepest = std::max(steepest, surface.featureSize[p] - surface.featureSize[q] - way);
    }
    worst = std::max(worst, std::abs(limited[p] - least));
  }
  EXPECT_LT(worst, 1e-12);
  EXPECT_LT(steepest, 1e-12) << "the slope of FeatureSize, along the surface and across space";
  const std::vector<double> once = limited;
  LimitGradient(surface.points, ids, gradient, limited, monitor);
  EXPECT_EQ(limited, once);
  std::vector<Id> backwards(ids.rbegin(), ids.rend());
  std::vector<double> other(rough.rbegin(), rough.rend());
  ThreadMonitor three(3);
  LimitGradient(surface.points, backwards, gradient, other, three);
  EXPECT_TRUE(std::equal(once.rbegin(), once.rend(), other.begin()));
}

TEST(FeatureSizeShapes, ScaleAndPlaceDoNotMatter)
{
  TriangleComplex surface = Wavy();
  FeatureSizeOptions options; // the automatic limits scale too
  Size(surface, options);
  for (double scale : { 1000.0, 1e-3 })
  {
    TriangleComplex other = Wavy();
    for (Vec3& p : other.points)
    {
      p = scale * (p + Vec3{ 3000, -1000, 500 });
    }
    Size(other, options, 1);
    double worst = 0;
    for (std::size_t p = 0; p < surface.points.size(); ++p)
    {
      worst = std::max({ worst, std::abs(other.featureSize[p] / scale / surface.featureSize[p] - 1),
                         std::abs(other.targetEdgeLength[p] / scale / surface.targetEdgeLength[p] - 1) });
    }
    EXPECT_LT(worst, 1e-8) << scale;
  }
}
