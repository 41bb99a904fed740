// SPDX-License-Identifier: BSD-3-Clause
#include "Images.h"
#include "Mesh/Closedness.h"
#include "Mesh/JunctionGraph.h"
#include "Mesh/VolumeCorrection.h"
#include "MomentMonitor.h"
#include "RefinedSurfaces.h"
#include "Search/SelfIntersection.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <random>
#include <set>

using namespace lamina;

namespace
{

TriangleComplex Sphere(double target, double radius = 10)
{
  TriangleComplex surface;
  shapes::AddSphere(surface, {}, radius, 4, { 1, 0 });
  surface.targetEdgeLength.assign(surface.points.size(), target);
  return surface;
}

TriangleComplex Sectors(double target, bool capped)
{
  ThreadMonitor monitor(2);
  TriangleComplex surface;
  EXPECT_TRUE(ExtractInterfaces(images::Sectors(16, 6.3, capped), surface, {}, monitor));
  EXPECT_TRUE(SmoothSurface(surface, {}, monitor));
  surface.targetEdgeLength.assign(surface.points.size(), target);
  return surface;
}

Id EulerNumber(const TriangleComplex& surface)
{
  std::set<Id> used;
  for (const Triangle& t : surface.triangles)
  {
    used.insert(t.begin(), t.end());
  }
  return static_cast<Id>(used.size()) - static_cast<Id>(MakeEdgeTable(surface.triangles).edges.size()) +
         static_cast<Id>(surface.triangles.size());
}

/// The length of junction curves by the materials around them.
std::map<std::set<int>, double> CurvesOf(const TriangleComplex& surface)
{
  std::map<std::set<int>, double> lengths;
  const EdgeTable table = MakeEdgeTable(surface.triangles);
  for (std::size_t e = 0; e < table.edges.size(); ++e)
  {
    const ListRow row = Row(table.triangles, static_cast<Id>(e));
    if (!IsFeatureEdge(surface, row.first, row.last))
    {
      continue;
    }
    std::set<int> materials;
    for (Id t : row)
    {
      materials.insert(surface.materials[static_cast<std::size_t>(t)].first);
      materials.insert(surface.materials[static_cast<std::size_t>(t)].second);
    }
    lengths[materials] += Norm(surface.points[static_cast<std::size_t>(table.edges[e].a)] -
                               surface.points[static_cast<std::size_t>(table.edges[e].b)]);
  }
  return lengths;
}

/// Refines, and expects what must hold for any surface.
RefineSurfaceReport RefineAndCheck(TriangleComplex& surface, const std::string& what)
{
  ThreadMonitor monitor(2);
  const TriangleComplex before = surface;
  const auto report = RefineSurface(surface, {}, monitor);
  EXPECT_TRUE(report) << what << ": " << (report ? "" : report.GetError().message);
  if (!report)
  {
    return {};
  }
  const auto error = CheckClosed(surface, true, monitor);
  EXPECT_FALSE(error) << what << ": " << error->message;
  EXPECT_EQ(FindIntersections(surface.points, surface.triangles, monitor).size(), 0u) << what;
  EXPECT_EQ(EulerNumber(surface), EulerNumber(before)) << what;
  EXPECT_EQ(MakeSheetGraph(surface).shellsOfSheet.size(), MakeSheetGraph(before).shellsOfSheet.size())
    << what;
  EXPECT_EQ(MakeSheetGraph(surface).ShellCount(), MakeSheetGraph(before).ShellCount()) << what;
  const auto materials = MaterialsOf(before);
  EXPECT_EQ(MaterialsOf(surface), materials) << what;
  const auto old = MaterialVolumes(before, materials);
  const auto now = MaterialVolumes(surface, materials);
  for (std::size_t m = 0; m < materials.size(); ++m)
  {
    EXPECT_NEAR(now[m], old[m], 1e-6 * old[m]) << what << ", material " << materials[m];
  }
  EXPECT_GE(report->edgesInRange, 0.99) << what;
  EXPECT_EQ(report->triangles, static_cast<Id>(surface.triangles.size())) << what;
  // Every split adds a point and every merge takes one, whatever they were for.
  EXPECT_EQ(static_cast<Id>(surface.points.size()) - static_cast<Id>(before.points.size()),
            report->splits - report->merges)
    << what;
  return *report;
}

void ExpectError(const TriangleComplex& input, const RefineSurfaceOptions& options, Failure kind,
                 const std::string& word)
{
  ThreadMonitor monitor;
  TriangleComplex surface = input;
  const auto result = RefineSurface(surface, options, monitor);
  ASSERT_FALSE(result) << word;
  EXPECT_EQ(result.GetError().kind, kind) << word;
  EXPECT_NE(result.GetError().message.find(word), std::string::npos) << result.GetError().message;
  EXPECT_EQ(surface.points, input.points) << word;
  EXPECT_EQ(surface.triangles, input.triangles) << word;
}

} // namespace

TEST(RefineSurface, SphereReachesItsTarget)
{
  for (const double target : { 0.6, 1.0, 2.2 })
  {
    TriangleComplex surface = Sphere(target);
    const auto report = RefineAndCheck(surface, "target " + std::to_string(target));
    EXPECT_GE(report.leastQuality, 0.4) << target;
    EXPECT_EQ(report.hiddenNodes, 0) << target;
    EXPECT_EQ(EulerNumber(surface), 2);
    // As many triangles as equilateral ones of that edge would need, within a factor.
    const double expected = 4 * 3.14159265 * 100 / (std::sqrt(3.0) / 4 * target * target);
    EXPECT_GT(report.triangles, 0.6 * expected) << target;
    EXPECT_LT(report.triangles, 1.8 * expected) << target;
  }
}

TEST(RefineSurface, SizesMayVary)
{
  TriangleComplex surface = Sphere(1);
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    surface.targetEdgeLength[p] = 1.4 + 0.08 * surface.points[p].z; // from 0.6 to 2.2
  }
  RefineAndCheck(surface, "graded");
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    EXPECT_NEAR(surface.targetEdgeLength[p], 1.4 + 0.08 * surface.points[p].z, 0.03);
  }
}

TEST(RefineSurface, FieldsAreCarried)
{
  TriangleComplex surface = Sphere(1.5);
  surface.sizedMaterials = { 1, 5 };
  for (const Vec3& p : surface.points)
  {
    surface.featureSize.push_back(20 + p.x);
    surface.thickness.push_back(30 + p.y);
    surface.thickness.push_back(std::numeric_limits<double>::quiet_NaN());
  }
  RefineAndCheck(surface, "fields");
  const std::size_t count = surface.points.size();
  ASSERT_EQ(surface.featureSize.size(), count);
  ASSERT_EQ(surface.targetEdgeLength.size(), count);
  ASSERT_EQ(surface.thickness.size(), 2 * count);
  ASSERT_EQ(surface.junctionKind.size(), count);
  ASSERT_EQ(surface.junctionOrder.size(), count);
  EXPECT_EQ(surface.sizedMaterials, (std::vector<int>{ 1, 5 }));
  for (std::size_t p = 0; p < count; ++p)
  {
    EXPECT_NEAR(surface.featureSize[p], 20 + surface.points[p].x, 0.2);
    EXPECT_NEAR(surface.thickness[2 * p], 30 + surface.points[p].y, 0.2);
    EXPECT_TRUE(std::isnan(surface.thickness[2 * p + 1]));
    EXPECT_EQ(surface.junctionKind[p], JunctionSheet);
    EXPECT_EQ(surface.junctionOrder[p], 2);
  }
}

TEST(RefineSurface, JunctionsStayBetweenTheSameMaterials)
{
  for (const double target : { 0.7, 1.6 })
  {
    TriangleComplex surface = Sectors(target, true);
    const auto before = CurvesOf(surface);
    EXPECT_EQ(before.size(), 4u); // 1-2-3 along the axis, and each pair of them with the outside
    RefineAndCheck(surface, "sectors " + std::to_string(target));
    const auto after = CurvesOf(surface);
    ASSERT_EQ(after.size(), before.size()) << target;
    for (const auto& curve : before)
    {
      ASSERT_EQ(after.count(curve.first), 1u) << target;
      EXPECT_NEAR(after.at(curve.first), curve.second, 0.05 * curve.second) << target;
    }
  }
}

TEST(RefineSurface, BorderPlanesStayPlane)
{
  TriangleComplex surface = Sectors(1.3, false);
  const auto names = surface.patchNames;
  RefineAndCheck(surface, "border planes");
  EXPECT_EQ(surface.patchNames, names);
  ASSERT_EQ(surface.patches.size(), surface.triangles.size());
  int inPlane = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    if (surface.patches[t] == 0)
    {
      continue;
    }
    ++inPlane;
    for (Id p : surface.triangles[t])
    {
      const double z = surface.points[static_cast<std::size_t>(p)].z;
      EXPECT_LT(std::min(std::abs(z + 0.5), std::abs(z - 15.5)), 1e-12) << z;
    }
  }
  EXPECT_GT(inPlane, 50);
}

TEST(RefineSurface, ThreadsMakeNoDifference)
{
  const TriangleComplex start = Sectors(1.2, true);
  TriangleComplex one = start;
  TriangleComplex three = start;
  ThreadMonitor single(1);
  ThreadMonitor triple(3);
  ASSERT_TRUE(RefineSurface(one, {}, single));
  ASSERT_TRUE(RefineSurface(three, {}, triple));
  EXPECT_EQ(one.points, three.points);
  EXPECT_EQ(one.triangles, three.triangles);
  EXPECT_EQ(one.targetEdgeLength, three.targetEdgeLength);
}

TEST(RefineSurface, BadTargetsAreNamed)
{
  TriangleComplex surface = Sphere(1);
  surface.targetEdgeLength.clear();
  ExpectError(surface, {}, Failure::InvalidInput, "TargetEdgeLength");
  surface.targetEdgeLength.assign(surface.points.size() - 1, 1);
  ExpectError(surface, {}, Failure::InvalidInput,
              std::to_string(surface.points.size() - 1) + " target edge lengths");
  for (const double bad :
       { std::numeric_limits<double>::quiet_NaN(), 0.0, -1.0, std::numeric_limits<double>::infinity() })
  {
    surface.targetEdgeLength.assign(surface.points.size(), 1);
    surface.targetEdgeLength[17] = bad;
    ExpectError(surface, {}, Failure::InvalidInput, "point 17");
  }
}

TEST(RefineSurface, BadOptionsAndSurfaces)
{
  const TriangleComplex sphere = Sphere(1);
  RefineSurfaceOptions options;
  options.iterations = 0;
  ExpectError(sphere, options, Failure::InvalidOption, "iterations");
  options = {};
  options.splitRatio = 1;
  ExpectError(sphere, options, Failure::InvalidOption, "split");
  options = {};
  options.mergeRatio = 1;
  ExpectError(sphere, options, Failure::InvalidOption, "merge");
  options = {};
  options.tolerance = -1;
  ExpectError(sphere, options, Failure::InvalidOption, "tolerance");
  TriangleComplex open = sphere;
  open.triangles.pop_back();
  open.materials.pop_back();
  ExpectError(open, {}, Failure::InvalidInput, "open");
  TriangleComplex turned = sphere;
  for (Triangle& t : turned.triangles)
  {
    std::swap(t[1], t[2]);
  }
  ExpectError(turned, {}, Failure::InvalidInput, "material 1 is inside out");
  options = {};
  options.tolerance = 1e-15;
  ExpectError(sphere, options, Failure::InvalidOption, "below what coordinates can hold");
  options.tolerance = std::numeric_limits<double>::quiet_NaN();
  ExpectError(sphere, options, Failure::InvalidOption, "tolerance");
  TriangleComplex crossing = sphere;
  shapes::AddSphere(crossing, { 15, 1, 2 }, 10, 2, { 1, 0 });
  crossing.targetEdgeLength.resize(crossing.points.size(), 1);
  ExpectError(crossing, {}, Failure::InvalidInput, "intersects itself");
}

TEST(RefineSurface, Cancel)
{
  ThreadMonitor monitor;
  monitor.Cancel();
  TriangleComplex surface = Sphere(0.5);
  const auto before = surface.points;
  const auto result = RefineSurface(surface, {}, monitor);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.GetError().kind, Failure::Cancelled);
  EXPECT_EQ(surface.points, before);
}

TEST(RefineSurface, CancelAtAnyMomentLeavesTheInputAsItWas)
{
  TriangleComplex start = Sectors(0.9, true);
  start.junctionKind.clear();
  start.junctionOrder.clear();
  MomentMonitor whole;
  TriangleComplex finished = start;
  ASSERT_TRUE(RefineSurface(finished, {}, whole));
  constexpr Id parts = 24;
  ASSERT_GT(whole.Moments(), 2 * parts);
  for (Id part = 0; part < parts; ++part)
  {
    const Id moment = 1 + part * (whole.Moments() - 1) / parts;
    for (const int threads : { 1, 2 })
    {
      MomentMonitor monitor(moment, threads);
      TriangleComplex surface = start;
      const auto result = RefineSurface(surface, {}, monitor);
      ASSERT_FALSE(result) << "moment " << moment << " of " << whole.Moments();
      EXPECT_EQ(result.GetError().kind, Failure::Cancelled) << moment;
      EXPECT_EQ(surface.points, start.points) << moment;
      EXPECT_EQ(surface.triangles, start.triangles) << moment;
      EXPECT_EQ(surface.targetEdgeLength, start.targetEdgeLength) << moment;
      EXPECT_TRUE(surface.junctionKind.empty()) << moment;
    }
  }
}

TEST(RefineSurface, NeitherSurfaceLeavesTheOther)
{
  TriangleComplex surface = Sectors(1.4, true);
  const TriangleComplex before = surface;
  ThreadMonitor monitor(2);
  RefineSurfaceOptions options;
  options.tolerance = 0.1;
  ASSERT_TRUE(RefineSurface(surface, options, monitor));
  const auto farthest = [](const TriangleComplex& from, const TriangleComplex& to)
  {
    const TriangleTree tree(to.points, to.triangles);
    double most = 0;
    for (const Triangle& t : from.triangles)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Vec3& a = from.points[static_cast<std::size_t>(t[k])];
        const Vec3& b = from.points[static_cast<std::size_t>(t[(k + 1) % 3])];
        for (const double w : { 0.0, 0.25, 0.5, 0.75 })
        {
          most = std::max(most, tree.ClosestPoint((1 - w) * a + w * b).distance2);
        }
      }
    }
    return std::sqrt(most);
  };
  EXPECT_LE(farthest(surface, before), 0.1);
  EXPECT_LE(farthest(before, surface), 0.1);
}

TEST(RefineSurface, AnisotropyIsChecked)
{
  const TriangleComplex sphere = Sphere(1);
  RefineSurfaceOptions options;
  for (const double bad : { 0.9, 4.1, std::numeric_limits<double>::quiet_NaN() })
  {
    options.tangentialAnisotropy = bad;
    ExpectError(sphere, options, Failure::InvalidOption, "anisotropy");
  }
  options.tangentialAnisotropy = 2;
  ExpectError(sphere, options, Failure::InvalidInput, "Feature Size");
}

TEST(RefineSurface, BorderPlanesStayPlaneInNoise)
{
  // Materials at random up to the image's border: many nodes there are hidden and uncovered by moves.
  std::mt19937 random(3);
  const LabelImage image =
    images::Make({ { 12, 12, 12 } }, [&](Id, Id, Id) { return static_cast<int>(random() % 4); });
  const TriangleComplex surface = RefinedSurface(image);
  std::map<int, std::array<Vec3, 2>> boxes;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const int patch = surface.Patch(static_cast<Id>(t));
    for (Id p : surface.triangles[t])
    {
      const Vec3& x = surface.points[static_cast<std::size_t>(p)];
      auto& box = boxes.insert({ patch, { { x, x } } }).first->second;
      for (int a = 0; a < 3; ++a)
      {
        box[0][a] = std::min(box[0][a], x[a]);
        box[1][a] = std::max(box[1][a], x[a]);
      }
    }
  }
  EXPECT_EQ(boxes.size(), 7u);
  for (const auto& box : boxes)
  {
    const Vec3 extent = box.second[1] - box.second[0];
    const double least = std::min({ extent.x, extent.y, extent.z });
    EXPECT_TRUE(box.first == 0 || least < 1e-9) << "patch " << box.first << ": " << least;
  }
}
