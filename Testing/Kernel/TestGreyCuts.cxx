// SPDX-License-Identifier: BSD-3-Clause
// Cuts between voxels placed by grey values, against shapes whose partial volumes are known.
#include "Geometry/Quality.h"
#include "Images.h"
#include "Mesh/Adjacency.h"
#include "Mesh/Closedness.h"
#include "Mesh/VolumeCorrection.h"
#include "Search/SelfIntersection.h"
#include "Surface/ExtractInterfaces.h"
#include "Surface/GreyCuts.h"
#include "Surface/SmoothSurface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>

using namespace lamina;

namespace
{

/// Distance to a shape, negative inside, and its image: 100 inside, 0 outside, between them over one voxel as
/// where a scanner averages.
using Distance = std::function<double(const Vec3&)>;

struct Pictured
{
  LabelImage labels;
  GreyImage grey;
};

Pictured Picture(Id n, const Distance& shape)
{
  Pictured made;
  const double middle = 0.5 * static_cast<double>(n - 1);
  made.labels = images::Make({ { n, n, n } }, [](Id, Id, Id) { return 0; });
  made.labels.grid.origin = { -middle, -middle, -middle };
  made.grey.grid = made.labels.grid;
  made.grey.values.resize(made.labels.labels.size());
  for (Id k = 0; k < n; ++k)
  {
    for (Id j = 0; j < n; ++j)
    {
      for (Id i = 0; i < n; ++i)
      {
        const auto v = static_cast<std::size_t>(made.labels.grid.Index(i, j, k));
        const double d = shape(
          made.labels.grid.ToWorld(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)));
        made.grey.values[v] = 100 * std::min(1.0, std::max(0.0, 0.5 - d));
        made.labels.labels[v] = made.grey.values[v] > 50 ? 1 : 0;
      }
    }
  }
  return made;
}

TriangleComplex Extract(const Pictured& picture, ExtractInterfacesOptions options = {},
                        ExtractInterfacesReport* told = nullptr, int threads = 2)
{
  ThreadMonitor monitor(threads);
  const GreyView view(picture.grey);
  options.grey = &view;
  TriangleComplex surface;
  const auto report = ExtractInterfaces(picture.labels, surface, options, monitor);
  EXPECT_TRUE(report);
  if (told != nullptr && report)
  {
    *told = *report;
  }
  return surface;
}

TriangleComplex ExtractByLabels(const Pictured& picture)
{
  ThreadMonitor monitor(2);
  TriangleComplex surface;
  EXPECT_TRUE(ExtractInterfaces(picture.labels, surface, {}, monitor));
  return surface;
}

void Smooth(TriangleComplex& surface)
{
  ThreadMonitor monitor(2);
  EXPECT_TRUE(SmoothSurface(surface, {}, monitor));
}

double RootMeanSquare(const TriangleComplex& surface, const Distance& shape)
{
  double sum = 0;
  for (const Vec3& p : surface.points)
  {
    sum += shape(p) * shape(p);
  }
  return std::sqrt(sum / static_cast<double>(surface.points.size()));
}

Distance Ball(double radius)
{
  return [radius](const Vec3& p) { return Norm(p - Vec3{ 0.13, 0.27, 0.41 }) - radius; };
}

void ExpectSound(const TriangleComplex& surface)
{
  ThreadMonitor monitor(2);
  EXPECT_FALSE(CheckClosed(surface, true, monitor));
  EXPECT_TRUE(FindIntersections(surface.points, surface.triangles, monitor).empty());
}

} // namespace

TEST(GreyCuts, TheThresholdIsFound)
{
  const Pictured picture = Picture(24, Ball(8));
  ThreadMonitor monitor(2);
  const auto faces = CollectVoxelFaces(picture.labels, {}, {}, monitor);
  ASSERT_TRUE(faces);
  const auto values = FindCutValues(*faces, picture.grey);
  ASSERT_EQ(values.size(), 1U);
  EXPECT_EQ(values.begin()->first, (MaterialPair{ 0, 1 }));
  EXPECT_NEAR(values.begin()->second, 50, 3);
}

TEST(GreyCuts, ABallIsNearerAndHasItsVolume)
{
  for (const double radius : { 6.0, 10.0 })
  {
    const Pictured picture = Picture(29, Ball(radius));
    ExtractInterfacesReport report;
    TriangleComplex byLabels = ExtractByLabels(picture);
    TriangleComplex byGrey = Extract(picture, {}, &report);
    ExpectSound(byGrey);
    EXPECT_GT(report.movedPoints, 0);
    EXPECT_LT(RootMeanSquare(byGrey, Ball(radius)), 0.06);
    const double truth = 4.0 / 3 * 3.141592653589793 * radius * radius * radius;
    EXPECT_NEAR(report.imageVolumes[0], truth, 0.002 * truth);
    Smooth(byLabels);
    Smooth(byGrey);
    ExpectSound(byGrey);
    EXPECT_LT(RootMeanSquare(byGrey, Ball(radius)), 0.95 * RootMeanSquare(byLabels, Ball(radius)));
    EXPECT_NEAR(MaterialVolumes(byGrey, { 1 })[0], report.imageVolumes[0], 1e-9 * truth);
    if (radius == 10)
    {
      EXPECT_LT(RootMeanSquare(byGrey, Ball(radius)), 0.04);
    }
  }
}

TEST(GreyCuts, ClusteringMakesFewerAndBetterTriangles)
{
  const Pictured picture = Picture(29, Ball(10));
  ExtractInterfacesOptions options;
  options.clusterPoints = false;
  const TriangleComplex all = Extract(picture, options);
  ExtractInterfacesReport report;
  const TriangleComplex clustered = Extract(picture, {}, &report);
  EXPECT_LT(clustered.triangles.size(), 2 * all.triangles.size() / 3);
  EXPECT_EQ(report.clusteredPoints, static_cast<Id>(all.points.size() - clustered.points.size()));
  EXPECT_EQ(clustered.points.size() * 2 - clustered.triangles.size(), 4U)
    << "Euler's number of a sphere is 2";
  EXPECT_EQ(MakeSheetGraph(clustered).ShellCount(), 1);
  const auto least = [](const TriangleComplex& surface)
  {
    double worst = 1;
    for (const Triangle& t : surface.triangles)
    {
      worst = std::min(worst, TriangleQuality(surface.points[static_cast<std::size_t>(t[0])],
                                              surface.points[static_cast<std::size_t>(t[1])],
                                              surface.points[static_cast<std::size_t>(t[2])]));
    }
    return worst;
  };
  EXPECT_GT(least(clustered), 3 * least(all));
}

TEST(GreyCuts, VoxelFacesHaveNothingToCluster)
{
  const Pictured picture = Picture(20, Ball(6));
  ThreadMonitor monitor(2);
  ExtractInterfacesOptions options;
  options.clusterPoints = false;
  TriangleComplex surface;
  ASSERT_TRUE(ExtractInterfaces(picture.labels, surface, options, monitor));
  EXPECT_EQ(ExtractByLabels(picture).points, surface.points);
}

TEST(GreyCuts, PointsOfTheBorderStayInIt)
{
  // A ball that the image's border cuts: its cap stays plane, whatever the grey values there.
  const Pictured picture = Picture(20, [](const Vec3& p) { return Norm(p - Vec3{ 0, 0.2, 6.1 }) - 7.3; });
  ExtractInterfacesOptions options;
  options.openMaterials = { 1 };
  options.openAtImageBorder = true;
  for (const bool open : { false, true })
  {
    options.openAtImageBorder = open;
    const TriangleComplex surface = Extract(picture, options);
    ExpectSound(surface);
    Id onBorder = 0;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
      const bool isBorder = !surface.patches.empty() && surface.patches[t] > 0;
      onBorder += isBorder ? 1 : 0;
      for (const Id p : surface.triangles[t])
      {
        EXPECT_LE(surface.points[static_cast<std::size_t>(p)].z, 10 + 1e-12);
        if (isBorder)
        {
          EXPECT_NEAR(surface.points[static_cast<std::size_t>(p)].z, 10, 1e-12);
        }
      }
    }
    EXPECT_GT(onBorder, 50);
  }
}

TEST(GreyCuts, ThreeMaterialsShareTheirCurve)
{
  // Two half balls of different brightness.
  Pictured picture = Picture(25, Ball(8));
  for (std::size_t v = 0; v < picture.labels.labels.size(); ++v)
  {
    const Id i = static_cast<Id>(v) % 25;
    const bool second = i > 12 && picture.labels.labels[v] == 1;
    picture.grey.values[v] *= i > 12 ? 2.4 : 1;
    picture.labels.labels[v] = i > 12 ? (picture.grey.values[v] > 120 ? 2 : 0) : picture.labels.labels[v];
    EXPECT_EQ(second, picture.labels.labels[v] == 2);
  }
  TriangleComplex surface = Extract(picture);
  ExpectSound(surface);
  EXPECT_EQ(MaterialsOf(surface), (std::vector<int>{ 1, 2 }));
  const auto held = MaterialVolumes(surface, { 1, 2 });
  Smooth(surface);
  ExpectSound(surface);
  const auto volumes = MaterialVolumes(surface, { 1, 2 });
  EXPECT_NEAR(volumes[0], held[0], 0.01 * held[0]);
  EXPECT_NEAR(volumes[1], held[1], 0.01 * held[1]);
}

TEST(GreyCuts, NoiseAndNothingKnownAreSound)
{
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 40);
  for (const bool unknown : { false, true })
  {
    Pictured picture = Picture(18, Ball(5));
    for (std::size_t v = 0; v < picture.grey.values.size(); ++v)
    {
      picture.grey.values[v] += noise(random);
      picture.labels.labels[v] = picture.grey.values[v] > 50 ? 1 : 0;
      if (unknown && v % 3 == 0)
      {
        picture.grey.values[v] = std::numeric_limits<double>::quiet_NaN();
      }
    }
    TriangleComplex surface = Extract(picture);
    ExpectSound(surface);
    Smooth(surface);
    ExpectSound(surface);
  }
}

TEST(GreyCuts, UniformGreyLeavesTheFaces)
{
  Pictured picture = Picture(18, Ball(5));
  std::fill(picture.grey.values.begin(), picture.grey.values.end(), 7.0);
  EXPECT_EQ(Extract(picture).points, ExtractByLabels(picture).points);
}

TEST(GreyCuts, AnisotropicTurnedGridsGiveTheSameInVoxels)
{
  Pictured picture = Picture(20, Ball(6));
  ExtractInterfacesOptions options;
  options.clusterPoints = false;
  const TriangleComplex plain = Extract(picture, options);
  // The same voxels, stretched along k and turned about i.
  picture.labels.grid.spacing = { 2, 2, 2 };
  picture.labels.grid.direction = { 1, 0, 0, 0, 0.6, -0.8, 0, 0.8, 0.6 };
  picture.labels.grid.origin = { 3, 4, 5 };
  picture.grey.grid = picture.labels.grid;
  const TriangleComplex turned = Extract(picture, options);
  ASSERT_EQ(turned.points.size(), plain.points.size());
  const double middle = 0.5 * 19;
  for (std::size_t p = 0; p < plain.points.size(); ++p)
  {
    const Vec3 index = plain.points[p] + Vec3{ middle, middle, middle };
    EXPECT_LT(Norm(turned.points[p] - picture.labels.grid.ToWorld(index.x, index.y, index.z)), 1e-9);
  }
}

TEST(GreyCuts, TheSameForAnyNumberOfThreads)
{
  const Pictured picture = Picture(24, Ball(8));
  const TriangleComplex one = Extract(picture, {}, nullptr, 1);
  const TriangleComplex three = Extract(picture, {}, nullptr, 3);
  EXPECT_EQ(one.points, three.points);
  EXPECT_EQ(one.triangles, three.triangles);
  EXPECT_EQ(one.missing, three.missing);
}

TEST(GreyCuts, AnImageOfAnotherSizeIsRefused)
{
  const Pictured picture = Picture(12, Ball(4));
  const Pictured other = Picture(13, Ball(4));
  const GreyView view(other.grey);
  ExtractInterfacesOptions options;
  options.grey = &view;
  ThreadMonitor monitor;
  TriangleComplex surface;
  const auto report = ExtractInterfaces(picture.labels, surface, options, monitor);
  ASSERT_FALSE(report);
  EXPECT_NE(report.GetError().message.find("grey image"), std::string::npos);
}
