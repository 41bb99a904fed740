// SPDX-License-Identifier: BSD-3-Clause
// Rays through walls meet every layer that was asked for.
#include "Images.h"
#include "LayerRays.h"
#include "Shapes.h"
#include "Sizing/FeatureSize.h"
#include "Surface/ExtractInterfaces.h"
#include "Surface/RefineSurface.h"
#include "Surface/SmoothSurface.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace lamina;

namespace
{

/// Fills material 1 with `count` layers and sends rays through it.
layers::RayCount Send(const TriangleComplex& surface, int count, double shortest, double longest, Id rays,
                      LayersReport* whatCame = nullptr)
{
  ThreadMonitor monitor(2);
  LayeredTetsOptions options;
  options.materials = { 1 };
  options.layers = count;
  VolumeMesh mesh;
  LayersOnSurface onSurface;
  const auto report = MeshLayeredTets(surface, options, mesh, onSurface, monitor);
  EXPECT_TRUE(report) << (report ? "" : report.GetError().message);
  EXPECT_GT(report->leastQuality, 0.1);
  // No tet spans three layers.
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    int low = 1000;
    int high = -1;
    for (int k = 0; k < 4; ++k)
    {
      const int index = mesh.layerIndex[static_cast<std::size_t>(mesh.Cell(c)[k])];
      low = index < 0 ? low : std::min(low, index);
      high = std::max(high, index);
    }
    EXPECT_LE(high - low, 1);
  }
  if (whatCame != nullptr)
  {
    *whatCame = *report;
  }
  return layers::CountRays(surface, mesh, onSurface, 1, (count - 1) / 2, rays, shortest, longest);
}

/// From labels to the surface that layers stand on.
Result<FeatureSizeReport> Refine(const LabelImage& image, const FeatureSizeOptions& sizing,
                                 TriangleComplex& surface)
{
  ThreadMonitor monitor(2);
  EXPECT_TRUE(ExtractInterfaces(image, surface, {}, monitor));
  EXPECT_TRUE(SmoothSurface(surface, {}, monitor));
  auto sized = ComputeFeatureSize(surface, sizing, monitor);
  EXPECT_TRUE(RefineSurface(surface, {}, monitor));
  return sized;
}

} // namespace

TEST(LayerPromise, SlabAndShellAreWhole)
{
  for (const int count : { 4, 6, 8 })
  {
    TriangleComplex slab;
    shapes::AddBox(slab, { 0, 0, 0 }, { 6, 6, 1 }, { { 3 * count, 3 * count, count / 2 } }, { 1, 0 });
    TriangleComplex shell;
    shapes::AddSphere(shell, {}, 1, 4, { 1, 0 });
    shapes::AddSphere(shell, {}, 0.6, 4, { 1, 2 });
    for (std::size_t t = shell.triangles.size() / 2; t < shell.triangles.size(); ++t)
    {
      std::swap(shell.triangles[t][1], shell.triangles[t][2]);
    }
    for (TriangleComplex* surface : { &slab, &shell })
    {
      ThreadMonitor monitor(2);
      FeatureSizeOptions sizing;
      sizing.minimum = 1e-3;
      ASSERT_TRUE(ComputeFeatureSize(*surface, sizing, monitor));
      const double thickness = surface == &slab ? 1 : 0.4;
      LayersReport report;
      const auto rays = Send(*surface, count, 0.9 * thickness, 1.1 * thickness, 3000, &report);
      EXPECT_EQ(report.stoppedColumns, 0) << count; // the slab has ridges of a right angle
      EXPECT_GT(rays.rays, 1000);
      EXPECT_EQ(rays.whole, rays.rays) << count;
    }
  }
}

TEST(LayerPromise, WallsOfAnImageAreWholeOrFlagged)
{
  // Two cavities of different size in a body, so that walls are thin and thick; a vessel runs through.
  const auto image = images::MakeCentred(40,
                                         [](double x, double y, double z)
                                         {
                                           const double r = std::sqrt(x * x + y * y + 0.6 * z * z);
                                           const double a = std::hypot(std::hypot(x + 6, y), 0.8 * z);
                                           const double b = std::hypot(std::hypot(x - 7.5, y + 1), 0.7 * z);
                                           return a < 6.5 ? 2 : (b < 4 ? 3 : (r < 16 ? 1 : 0));
                                         });
  FeatureSizeOptions sizing;
  sizing.layers = 4;
  TriangleComplex surface;
  const auto sized = Refine(image, sizing, surface);
  ASSERT_TRUE(sized);
  const auto rays = Send(surface, 4, sized->minimum, sized->maximum, 20000);
  EXPECT_GT(rays.rays, 5000);
  EXPECT_GE(static_cast<double>(rays.whole), 0.999 * static_cast<double>(rays.rays));
  EXPECT_EQ(rays.whole + rays.flagged, rays.rays);
}

TEST(LayerPromise, NoTetSpansThreeLayersWhereColumnsStop)
{
  // A sharp wedge of material 1 between two others in a ball: at its edge no layers fit.
  const auto image = images::MakeCentred(28,
                                         [](double x, double y, double z)
                                         {
                                           const int half = z < 0 ? 2 : (z < 0.3 * (x + 6) ? 1 : 3);
                                           return x * x + y * y + z * z < 144 ? half : 0;
                                         });
  FeatureSizeOptions sizing;
  sizing.layers = 8;
  sizing.minimum = 0.6; // coarse for the edge of the wedge
  TriangleComplex surface;
  const auto sized = Refine(image, sizing, surface);
  ASSERT_TRUE(sized);
  LayersReport report;
  Send(surface, 8, sized->minimum, sized->maximum, 2000, &report);
  EXPECT_GT(report.stoppedColumns, 0);
}

TEST(LayerPromise, WallsNearTheImagesBorder)
{
  // Material 2 comes within a voxel of three of the image's planes. These are no walls: layers of material 1
  // have that voxel's room, though it is thick elsewhere.
  const auto image =
    images::Make({ { 16, 16, 16 } },
                 [](Id i, Id j, Id k)
                 {
                   const bool isInside = std::min({ i, j, k }) >= 1 && std::max({ i, j, k }) <= 11;
                   return isInside ? 2 : (i * i + j * j + k * k < 340 ? 1 : 0);
                 });
  TriangleComplex surface;
  const auto sized = Refine(image, {}, surface);
  ASSERT_TRUE(sized);
  LayersReport report;
  const auto rays = Send(surface, 6, sized->minimum, sized->maximum, 5000, &report);
  EXPECT_GT(report.leastQuality, 0.15);
  EXPECT_GT(report.stoppedColumns, 0);
  EXPECT_LT(report.stoppedColumns, report.columns / 10);
  EXPECT_EQ(rays.whole + rays.flagged, rays.rays);
}
