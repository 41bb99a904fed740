// SPDX-License-Identifier: BSD-3-Clause
// Refinement driven by the feature size on shapes whose answers are known.
#include "Mesh/VolumeCorrection.h"
#include "Search/SelfIntersection.h"
#include "Shapes.h"
#include "Sizing/FeatureSize.h"
#include "Surface/RefineSurface.h"

#include <gtest/gtest.h>

using namespace lamina;

namespace
{

constexpr double Pi = 3.14159265358979323846;

TriangleComplex Sized(TriangleComplex surface, double maximum, int layers = 6)
{
  ThreadMonitor monitor(2);
  FeatureSizeOptions options;
  options.maximum = maximum;
  options.layers = layers;
  const auto sized = ComputeFeatureSize(surface, options, monitor);
  EXPECT_TRUE(sized) << (sized ? "" : sized.GetError().message);
  return surface;
}

RefineSurfaceReport Refine(TriangleComplex& surface, const RefineSurfaceOptions& options = {})
{
  ThreadMonitor monitor(2);
  const auto report = RefineSurface(surface, options, monitor);
  EXPECT_TRUE(report) << (report ? "" : report.GetError().message);
  if (!report)
  {
    return {};
  }
  EXPECT_EQ(FindIntersections(surface.points, surface.triangles, monitor).size(), 0u);
  return *report;
}

/// A closed tube along z that tapers from radius 3 to 1.2 over a length of 30.
TriangleComplex TaperingTube(double edge)
{
  TriangleComplex surface;
  shapes::AddClosedTube(surface, {}, 3, 30, edge, 0.2, { 1, 0 });
  for (Vec3& p : surface.points)
  {
    const double shrink = 1 - 0.6 * p.z / 30;
    p.x *= shrink;
    p.y *= shrink;
  }
  return surface;
}

/// The largest distance of points, middles of edges and of triangles from the surface `to`.
double FarthestFrom(const TriangleComplex& from, const TriangleComplex& to)
{
  const TriangleTree tree(to.points, to.triangles);
  double farthest = 0;
  const auto look = [&](const Vec3& p) { farthest = std::max(farthest, tree.ClosestPoint(p).distance2); };
  for (const Triangle& t : from.triangles)
  {
    const auto at = [&](std::size_t k) { return from.points[static_cast<std::size_t>(t[k % 3])]; };
    look((1.0 / 3) * (at(0) + at(1) + at(2)));
    for (std::size_t k = 0; k < 3; ++k)
    {
      look(at(k));
      look(0.5 * (at(k) + at(k + 1)));
    }
  }
  return std::sqrt(farthest);
}

/// Half the triangles that a plane across z cuts: the nodes round that section.
double NodesAround(const TriangleComplex& surface, double z)
{
  Id cut = 0;
  for (const Triangle& t : surface.triangles)
  {
    int above = 0;
    for (Id p : t)
    {
      above += surface.points[static_cast<std::size_t>(p)].z > z ? 1 : 0;
    }
    cut += above == 1 || above == 2 ? 1 : 0;
  }
  return 0.5 * static_cast<double>(cut);
}

Id TrianglesBeyond(const TriangleComplex& surface, double x)
{
  return std::count_if(surface.triangles.begin(), surface.triangles.end(),
                       [&](const Triangle& t)
                       { return surface.points[static_cast<std::size_t>(t[0])].x > x; });
}

} // namespace

TEST(RefineShapes, TaperingTubeKeepsItsNodesRound)
{
  TriangleComplex surface = Sized(TaperingTube(0.3), 100);
  Refine(surface);
  for (double z = 2; z < 28; z += 0.5)
  {
    EXPECT_GE(NodesAround(surface, z), 12) << z;
  }
}

TEST(RefineShapes, LongEdgesAlongATubeSaveHalfTheTriangles)
{
  const TriangleComplex input = Sized(TaperingTube(0.3), 100);
  TriangleComplex alike = input;
  TriangleComplex stretched = input;
  Refine(alike);
  RefineSurfaceOptions options;
  options.tangentialAnisotropy = 3;
  const auto report = Refine(stretched, options);
  EXPECT_LE(2 * stretched.triangles.size(), alike.triangles.size());
  EXPECT_LE(FarthestFrom(stretched, input), 1.1 * FarthestFrom(alike, input));
  EXPECT_LE(FarthestFrom(input, stretched), 1.1 * FarthestFrom(input, alike));
  EXPECT_GE(report.edgesInRange, 0.99);
  EXPECT_GE(report.goodTriangles, 0.999);
  EXPECT_GE(report.leastQuality, 0.3);
  EXPECT_EQ(report.hiddenNodes, 0);
  for (double z = 2; z < 28; z += 0.5)
  {
    EXPECT_GE(NodesAround(stretched, z), 11) << z; // long edges lie along the tube
  }
}

TEST(RefineShapes, ASphereHasNoDirectionOfLongEdges)
{
  TriangleComplex sphere;
  shapes::AddSphere(sphere, {}, 10, 4, { 1, 0 });
  TriangleComplex alike = Sized(sphere, 100);
  TriangleComplex stretched = alike;
  Refine(alike);
  RefineSurfaceOptions options;
  options.tangentialAnisotropy = 4;
  Refine(stretched, options);
  EXPECT_NEAR(static_cast<double>(stretched.triangles.size()) / static_cast<double>(alike.triangles.size()),
              1, 0.1);
}

TEST(RefineShapes, TheSameShapeFourTimesAsLargeGetsAsManyTriangles)
{
  TriangleComplex surface;
  shapes::AddSphere(surface, {}, 1, 4, { 1, 0 });
  shapes::AddSphere(surface, { 100, 0, 0 }, 4, 6, { 1, 0 }); // of the same edges, as from one image
  surface = Sized(surface, 100, 12);
  const double uniform = *std::min_element(surface.targetEdgeLength.begin(), surface.targetEdgeLength.end());
  RefineSurfaceOptions options;
  options.tolerance = 0.12; // that of the voxels would ask more of the large one
  Refine(surface, options);
  const Id ofLarge = TrianglesBeyond(surface, 50);
  const Id ofSmall = static_cast<Id>(surface.triangles.size()) - ofLarge;
  EXPECT_NEAR(static_cast<double>(ofLarge) / static_cast<double>(ofSmall), 1, 0.1);
  // A uniform mesh of the smallest size has many times as many.
  const double area = 4 * Pi * (1 + 16);
  const double asUniform = area / (std::sqrt(3.0) / 4 * uniform * uniform);
  EXPECT_GT(asUniform, 5 * static_cast<double>(surface.triangles.size()));
}

TEST(RefineShapes, ANeedleStaysValid)
{
  TriangleComplex needle;
  shapes::AddBox(needle, {}, { 100, 0.1, 0.1 }, { 4, 1, 1 }, { 1, 0 });
  needle.targetEdgeLength.assign(needle.points.size(), 5);
  const auto report = Refine(needle);
  EXPECT_GT(report.triangles, 0);
  EXPECT_LT(report.largestVolumeChange, 1e-6);
}

TEST(RefineShapes, FourTrianglesStayFourOrGrow)
{
  for (const double target : { 0.3, 10.0 })
  {
    TriangleComplex tetrahedron;
    tetrahedron.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    tetrahedron.triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 2 } };
    tetrahedron.materials.assign(4, { 1, 0 });
    tetrahedron.targetEdgeLength.assign(4, target);
    const auto report = Refine(tetrahedron);
    EXPECT_GE(report.triangles, target < 1 ? 20 : 4) << target;
    EXPECT_LT(report.largestVolumeChange, 1e-6) << target;
  }
}

TEST(RefineShapes, TargetsFarFromTheInputsEdgesAreNoTrouble)
{
  TriangleComplex box;
  shapes::AddBox(box, {}, { 50, 50, 50 }, { 1, 1, 1 }, { 1, 0 });
  box.targetEdgeLength.assign(box.points.size(), 1.5);
  EXPECT_GT(Refine(box).triangles, 12000);
  TriangleComplex sphere;
  shapes::AddSphere(sphere, {}, 1, 4, { 1, 0 });
  sphere.targetEdgeLength.assign(sphere.points.size(), 1e6);
  const auto report = Refine(sphere);
  EXPECT_LT(report.triangles, 1000); // as few as the tolerance lets it be
  EXPECT_LT(report.largestVolumeChange, 1e-6);
}

TEST(RefineShapes, HiddenNodesAreForbiddenOnlyByTheInputsOwnRidges)
{
  // A knife: its ridge of 20 degrees hides every node on it, whatever the triangles.
  const auto knife = [](double degrees)
  {
    TriangleComplex surface;
    const double half = 10 * std::tan(0.5 * degrees * Pi / 180);
    surface.points = { { 0, 0, 0 },  { 10, half, 0 },  { 10, -half, 0 },
                       { 0, 0, 20 }, { 10, half, 20 }, { 10, -half, 20 } };
    surface.triangles = { { 0, 1, 2 }, { 3, 5, 4 }, { 0, 3, 4 }, { 0, 4, 1 },
                          { 0, 2, 5 }, { 0, 5, 3 }, { 1, 4, 5 }, { 1, 5, 2 } };
    surface.materials.assign(8, { 1, 0 });
    if (MaterialVolumes(surface, { 1 })[0] < 0)
    {
      for (Triangle& t : surface.triangles)
      {
        std::swap(t[1], t[2]);
      }
    }
    surface.targetEdgeLength.assign(6, 2);
    return surface;
  };
  RefineSurfaceOptions options;
  options.tolerance = 0.02;
  TriangleComplex sharp = knife(20);
  const auto report = Refine(sharp, options);
  EXPECT_GE(report.hiddenNodes, 8); // along the ridge
  EXPECT_EQ(report.forbiddenNodes, report.hiddenNodes);
  EXPECT_EQ(report.hiddenPoints.size(), static_cast<std::size_t>(report.hiddenNodes));
  TriangleComplex blunt = knife(60); // as are its other two
  const auto other = Refine(blunt, options);
  EXPECT_EQ(other.hiddenNodes, other.forbiddenNodes);
  EXPECT_LE(other.hiddenNodes, 6); // corners at most
}

TEST(RefineShapes, SizesEvaluatedAnewAtTheRefinedPointsAreThoseCarriedThere)
{
  TriangleComplex surface = Sized(TaperingTube(0.3), 100);
  Refine(surface);
  const TriangleComplex anew = Sized(surface, 100);
  ASSERT_EQ(anew.points, surface.points);
  int count = 0;
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    if (surface.points[p].z > 6 && surface.points[p].z < 24)
    {
      ++count;
      EXPECT_NEAR(anew.thickness[p] / surface.thickness[p], 1, 0.03) << surface.points[p].z;
      EXPECT_NEAR(anew.targetEdgeLength[p] / surface.targetEdgeLength[p], 1, 0.1) << surface.points[p].z;
    }
  }
  EXPECT_GT(count, 200);
}
