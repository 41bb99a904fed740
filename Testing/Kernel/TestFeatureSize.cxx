// SPDX-License-Identifier: BSD-3-Clause
#include "MomentMonitor.h"
#include "Shapes.h"
#include "Sizing/FeatureSize.h"
#include "Sizing/GradientLimit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

using namespace lamina;

namespace
{

FeatureSizeOptions Wide(double maximum, double gradient = 100)
{
  FeatureSizeOptions options;
  options.minimum = 1e-3;
  options.maximum = maximum;
  options.gradient = gradient;
  options.nodesPerCircumference = 0;
  return options;
}

/// Least and largest thickness in a column over the points that `choose` picks.
template<typename Choose>
std::array<double, 2> Range(const TriangleComplex& surface, std::size_t column, Choose&& choose)
{
  std::array<double, 2> range{ { 1e300, -1e300 } };
  const std::size_t columns = surface.sizedMaterials.size();
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    const double value = surface.thickness[p * columns + column];
    if (!std::isnan(value) && choose(surface.points[p]))
    {
      range = { { std::min(range[0], value), std::max(range[1], value) } };
    }
  }
  return range;
}

const auto Everywhere = [](const Vec3&) { return true; };

void ExpectError(TriangleComplex surface, const FeatureSizeOptions& options, Failure kind, const char* word)
{
  ThreadMonitor monitor;
  const auto result = ComputeFeatureSize(surface, options, monitor);
  ASSERT_FALSE(result) << word;
  EXPECT_EQ(result.GetError().kind, kind);
  EXPECT_NE(result.GetError().message.find(word), std::string::npos) << result.GetError().message;
  EXPECT_TRUE(surface.featureSize.empty());
}

} // namespace

TEST(FeatureSize, SphereIsItsDiameter)
{
  ThreadMonitor monitor(2);
  TriangleComplex surface;
  shapes::AddSphere(surface, { 1, 2, 3 }, 2, 4, { 1, 0 });
  const auto report = ComputeFeatureSize(surface, Wide(50), monitor);
  ASSERT_TRUE(report);
  EXPECT_EQ(surface.sizedMaterials, std::vector<int>{ 1 });
  const auto range = Range(surface, 0, Everywhere);
  EXPECT_NEAR(range[0], 4, 0.04);
  EXPECT_NEAR(range[1], 4, 0.04);
  EXPECT_DOUBLE_EQ(surface.targetEdgeLength[7], surface.featureSize[7] * 2 / 6);
  EXPECT_DOUBLE_EQ(report->leastSize, range[0]);
}

TEST(FeatureSize, ShellIsMeasuredFromBothSides)
{
  ThreadMonitor monitor(2);
  TriangleComplex surface;
  shapes::AddSphere(surface, { 0, 0, 0 }, 1, 4, { 1, 2 });
  shapes::AddSphere(surface, { 0, 0, 0 }, 1.3, 4, { 2, 0 });
  ASSERT_TRUE(ComputeFeatureSize(surface, Wide(50), monitor));
  ASSERT_EQ(surface.sizedMaterials, (std::vector<int>{ 1, 2 }));
  const auto inner = Range(surface, 0, Everywhere);
  const auto shell = Range(surface, 1, Everywhere);
  EXPECT_NEAR(inner[0], 2, 0.02);
  EXPECT_NEAR(inner[1], 2, 0.02);
  EXPECT_NEAR(shell[0], 0.3, 0.03);
  EXPECT_NEAR(shell[1], 0.3, 0.03);
  EXPECT_TRUE(std::isnan(surface.thickness.back() - surface.thickness[surface.thickness.size() - 2]));
}

TEST(FeatureSize, SlabIsItsThicknessAndTruncated)
{
  ThreadMonitor monitor;
  TriangleComplex surface;
  shapes::AddBox(surface, { 0, 0, 0 }, { 10, 10, 0.5 }, { { 20, 20, 1 } }, { 1, 0 });
  auto report = ComputeFeatureSize(surface, Wide(6), monitor);
  ASSERT_TRUE(report);
  const auto middle = [](const Vec3& p) { return std::abs(p.x - 5) < 4 && std::abs(p.y - 5) < 4; };
  const auto range = Range(surface, 0, middle);
  EXPECT_NEAR(range[0], 0.5, 1e-12);
  EXPECT_NEAR(range[1], 0.5, 1e-12);
  // Clipping acts on the governing size only, truncation on both.
  FeatureSizeOptions options = Wide(0.4);
  options.minimum = 0.2;
  report = ComputeFeatureSize(surface, options, monitor);
  EXPECT_EQ(report->clippedAbove, static_cast<Id>(surface.points.size()));
  EXPECT_DOUBLE_EQ(Range(surface, 0, middle)[1], 0.4);
  options = Wide(6);
  options.minimum = 2;
  report = ComputeFeatureSize(surface, options, monitor);
  EXPECT_GT(report->clippedBelow, 200);
  EXPECT_NEAR(Range(surface, 0, middle)[0], 0.5, 1e-12);
  EXPECT_DOUBLE_EQ(*std::min_element(surface.featureSize.begin(), surface.featureSize.end()), 2);
}

TEST(FeatureSize, CylinderIsItsDiameter)
{
  ThreadMonitor monitor;
  TriangleComplex surface;
  shapes::AddCylinder(surface, { 0, 0, 0 }, 1, 12, 48, 60, { 4, 0 });
  ASSERT_TRUE(ComputeFeatureSize(surface, Wide(8), monitor));
  const auto range = Range(surface, 0, [](const Vec3& p) { return p.z > 3 && p.z < 9; });
  EXPECT_NEAR(range[0], 2, 0.02);
  EXPECT_NEAR(range[1], 2, 0.02);
}

TEST(FeatureSize, TheGapBetweenTwoTubesIsSeenOutside)
{
  // Two tubes of material 1, 0.1 apart, in a box of material 2.
  ThreadMonitor monitor;
  TriangleComplex surface;
  shapes::AddCylinder(surface, { 0, 0, 0 }, 1, 8, 64, 40, { 1, 2 });
  shapes::AddCylinder(surface, { 2.1, 0, 0 }, 1, 8, 64, 40, { 1, 2 });
  shapes::AddBox(surface, { -6, -6, -4 }, { 8, 6, 12 }, { { 9, 9, 9 } }, { 2, 0 });
  ASSERT_TRUE(ComputeFeatureSize(surface, Wide(9), monitor));
  const auto facing = [](const Vec3& p)
  { return p.z > 2 && p.z < 6 && std::abs(p.y) < 0.05 && p.x > 0.99 && p.x < 1.2; };
  const auto far = [](const Vec3& p)
  { return p.z > 2 && p.z < 6 && std::abs(p.y) < 0.05 && p.x < -0.9 && p.x > -2; };
  EXPECT_NEAR(Range(surface, 1, facing)[1], 0.1, 0.01);
  EXPECT_GT(Range(surface, 1, far)[0], 4);
  EXPECT_NEAR(Range(surface, 0, facing)[0], 2, 0.02);
}

TEST(FeatureSize, OpeningsAreNoWalls)
{
  // The far end of a box 1 x 1 x 3 is an opening: rays that leave through it find nothing.
  ThreadMonitor monitor;
  TriangleComplex surface;
  shapes::AddBox(surface, { 0, 0, 0 }, { 2, 2, 3 }, { { 4, 4, 6 } }, { 1, 0 });
  const auto base = [](const Vec3& p)
  { return p.z == 0 && std::abs(p.x - 1) < 0.1 && std::abs(p.y - 1) < 0.1; };
  ASSERT_TRUE(ComputeFeatureSize(surface, Wide(9), monitor));
  EXPECT_NEAR(Range(surface, 0, base)[0], 3, 1e-12);
  for (const Triangle& t : surface.triangles)
  {
    const bool top = std::all_of(t.begin(), t.end(),
                                 [&](Id p) { return surface.points[static_cast<std::size_t>(p)].z == 3; });
    surface.patches.push_back(top ? 1 : 0);
  }
  ASSERT_TRUE(ComputeFeatureSize(surface, Wide(9), monitor));
  EXPECT_GT(Range(surface, 0, base)[0], 3.5);
}

TEST(FeatureSize, DoesNotDependOnOrderOrThreadsAndIsIdempotent)
{
  TriangleComplex surface;
  shapes::AddSphere(surface, { 0, 0, 0 }, 1, 3, { 1, 2 });
  shapes::AddSphere(surface, { 0.1, 0, 0 }, 1.3, 3, { 2, 0 });
  TriangleComplex other = surface;
  std::vector<Id> order(surface.points.size());
  std::iota(order.begin(), order.end(), Id{ 0 });
  std::shuffle(order.begin(), order.end(), std::mt19937(2));
  for (std::size_t p = 0; p < order.size(); ++p)
  {
    other.points[static_cast<std::size_t>(order[p])] = surface.points[p];
  }
  for (Triangle& t : other.triangles)
  {
    t = { { order[static_cast<std::size_t>(t[0])], order[static_cast<std::size_t>(t[1])],
            order[static_cast<std::size_t>(t[2])] } };
  }
  ThreadMonitor one(1);
  ThreadMonitor three(3);
  FeatureSizeOptions options = Wide(5, 0.3);
  options.layers = 2;
  options.nodesPerCircumference = 12;
  const auto report = ComputeFeatureSize(surface, options, one);
  ASSERT_TRUE(report);
  EXPECT_GT(report->curved, 0);
  ASSERT_TRUE(ComputeFeatureSize(other, options, three));
  for (std::size_t p = 0; p < order.size(); ++p)
  {
    const auto q = static_cast<std::size_t>(order[p]);
    EXPECT_EQ(surface.featureSize[p], other.featureSize[q]);
    EXPECT_EQ(surface.targetEdgeLength[p], other.targetEdgeLength[q]);
    EXPECT_EQ(surface.maximumCurvature[p], other.maximumCurvature[q]);
    EXPECT_TRUE(surface.maximumCurvatureDirection[p] == other.maximumCurvatureDirection[q]);
  }
  auto again = surface.featureSize;
  std::iota(order.begin(), order.end(), Id{ 0 });
  LimitGradient(surface.points, order, 0.3, again, one);
  EXPECT_EQ(again, surface.featureSize);
}

TEST(GradientLimit, AgreesWithAllPairs)
{
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Vec3> points;
  std::vector<Id> ids;
  std::vector<double> values;
  for (Id i = 0; i < 700; ++i)
  {
    points.push_back({ unit(generator), unit(generator), i % 7 == 0 ? 0.5 : unit(generator) });
    ids.push_back(i);
    values.push_back(0.01 + std::pow(unit(generator), 3));
  }
  std::vector<double> expected = values;
  for (std::size_t i = 0; i < 700; ++i)
  {
    for (std::size_t j = 0; j < 700; ++j)
    {
      expected[i] = std::min(expected[i], values[j] + 0.4 * Norm(points[i] - points[j]));
    }
  }
  for (int threads : { 1, 2 })
  {
    ThreadMonitor monitor(threads);
    auto limited = values;
    LimitGradient(points, ids, 0.4, limited, monitor);
    EXPECT_EQ(limited, expected);
    const auto once = limited;
    LimitGradient(points, ids, 0.4, limited, monitor);
    EXPECT_EQ(limited, once);
  }
}

TEST(FeatureSize, BadSizesOfMaterialsAreNamed)
{
  TriangleComplex surface;
  shapes::AddSphere(surface, { 0, 0, 0 }, 1, 1, { 1, 0 });
  const auto expect = [&](std::vector<MaterialSizing> materials, const char* word)
  {
    FeatureSizeOptions options;
    options.materials = std::move(materials);
    ExpectError(surface, options, Failure::InvalidOption, word);
  };
  expect({ { 2, 4, 0, 0, 0 } }, "material 2, which the surface lacks; it has 1");
  expect({ { 0, 4, 0, 0, 0 } }, "numbered from 1");
  expect({ { 1, 4, 0, 0, 0 }, { 1, 5, 0, 0, 0 } }, "given twice");
  expect({ { 1, -4, 0, 0, 0 } }, "layers of material 1 is -4");
  expect({ { 1, 4, -2, 0, 0 } }, "anisotropy of material 1 is -2");
  expect({ { 1, 4, 0, std::nan(""), 0 } }, "minimum of material 1");
  expect({ { 1, 4, 0, 0, -1 } }, "maximum of material 1");
  expect({ { 1, 4, 0, 2, 1 } }, "least feature size of material 1 (2) is above the largest (1)");
  expect({ { 1, 4, 0, 0, 1e-4 } }, "of material 1");
}

TEST(FeatureSize, BadInputIsNamed)
{
  TriangleComplex surface;
  shapes::AddSphere(surface, { 0, 0, 0 }, 1, 1, { 1, 0 });
  FeatureSizeOptions options;
  options.gradient = 0;
  ExpectError(surface, options, Failure::InvalidOption, "gradient");
  options = {};
  options.layers = 0;
  ExpectError(surface, options, Failure::InvalidOption, "layers");
  options = {};
  options.anisotropy = -1;
  ExpectError(surface, options, Failure::InvalidOption, "anisotropy");
  options = {};
  options.minimum = std::nan("");
  ExpectError(surface, options, Failure::InvalidOption, "minimum");
  options = {};
  options.minimum = 3;
  options.maximum = 2;
  ExpectError(surface, options, Failure::InvalidOption, "above the largest");
  options = {};
  options.coneAngle = 90;
  ExpectError(surface, options, Failure::InvalidOption, "coneAngle");
  options = {};
  options.nodesPerCircumference = 2;
  ExpectError(surface, options, Failure::InvalidOption, "nodesPerCircumference is 2");
  options = {};
  options.edgePerLayer = 0;
  ExpectError(surface, options, Failure::InvalidOption, "edgePerLayer is 0");
  options = {};
  options.gradient = -0.3;
  ExpectError(surface, options, Failure::InvalidOption, "gradient is -0.3");
  TriangleComplex open = surface;
  open.triangles.pop_back();
  open.materials.pop_back();
  ExpectError(open, {}, Failure::InvalidInput, "open");
  ExpectError(open, {}, Failure::InvalidInput, "3 edges in all, the first from point ");
  TriangleComplex turned = surface;
  for (Triangle& t : turned.triangles)
  {
    std::swap(t[1], t[2]);
  }
  ExpectError(turned, {}, Failure::InvalidInput, "material 1 is inside out");
  TriangleComplex wrong = surface;
  wrong.materials.pop_back();
  ExpectError(wrong, {}, Failure::InvalidInput, "32 triangles but 31 material pairs");
  wrong = surface;
  wrong.patches.assign(3, 0);
  ExpectError(wrong, {}, Failure::InvalidInput, "3 patch ids");
  TriangleComplex point = surface;
  std::fill(point.points.begin(), point.points.end(), Vec3{ 1, 1, 1 });
  ExpectError(point, {}, Failure::InvalidInput, "coincide");
  TriangleComplex empty;
  ThreadMonitor monitor;
  EXPECT_TRUE(ComputeFeatureSize(empty, {}, monitor));
  ThreadMonitor stopped;
  stopped.Cancel();
  const auto result = ComputeFeatureSize(surface, {}, stopped);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.GetError().kind, Failure::Cancelled);
}

TEST(FeatureSize, FourTrianglesNeedlesAndPiecesAreSized)
{
  ThreadMonitor monitor(2);
  TriangleComplex surface;
  surface.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  surface.triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 2 } };
  surface.materials.assign(4, { 1, 0 });
  shapes::AddBox(surface, { 5, 0, 0 }, { 105, 0.1, 0.1 }, { { 4, 1, 1 } },
                 { 2, 0 }); // a needle apart from it
  ASSERT_TRUE(ComputeFeatureSize(surface, {}, monitor));
  ASSERT_EQ(surface.targetEdgeLength.size(), surface.points.size());
  for (double h : surface.targetEdgeLength)
  {
    EXPECT_TRUE(h > 0 && std::isfinite(h)) << h;
  }
}

TEST(FeatureSize, CancelAtAnyMomentLeavesTheInputAsItWas)
{
  TriangleComplex start;
  shapes::AddSphere(start, {}, 2, 4, { 2, 0 });
  shapes::AddSphere(start, {}, 1, 4, { 1, 2 });
  start.featureSize.assign(start.points.size(), 7); // of an earlier call
  MomentMonitor whole;
  TriangleComplex finished = start;
  ASSERT_TRUE(ComputeFeatureSize(finished, {}, whole));
  ASSERT_GT(whole.Moments(), 12);
  for (Id moment = 1; moment <= whole.Moments(); ++moment)
  {
    MomentMonitor monitor(moment);
    TriangleComplex surface = start;
    const auto result = ComputeFeatureSize(surface, {}, monitor);
    ASSERT_FALSE(result) << "moment " << moment << " of " << whole.Moments();
    EXPECT_EQ(result.GetError().kind, Failure::Cancelled) << moment;
    EXPECT_EQ(surface.points, start.points) << moment;
    EXPECT_EQ(surface.featureSize, start.featureSize) << moment;
    EXPECT_TRUE(surface.targetEdgeLength.empty()) << moment;
    EXPECT_TRUE(surface.thickness.empty()) << moment;
    EXPECT_TRUE(surface.maximumCurvature.empty()) << moment;
    EXPECT_TRUE(surface.minimumCurvature.empty()) << moment;
    EXPECT_TRUE(surface.maximumCurvatureDirection.empty()) << moment;
    EXPECT_TRUE(surface.sizedMaterials.empty()) << moment;
  }
}
