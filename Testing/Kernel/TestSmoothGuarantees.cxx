// SPDX-License-Identifier: BSD-3-Clause
// What smoothing guarantees whatever the image: no intersections, sheets apart, the image's volumes.
#include "SmoothChecks.h"

using namespace lamina;

namespace
{

TriangleComplex Extracted(const LabelImage& image, ExtractInterfacesReport* told = nullptr)
{
  ThreadMonitor monitor(2);
  TriangleComplex surface;
  const auto report = ExtractInterfaces(image, surface, {}, monitor);
  EXPECT_TRUE(report);
  if (told != nullptr && report)
  {
    *told = *report;
  }
  return surface;
}

void ExpectForRandomImages(unsigned first, unsigned count, const std::vector<int>& sweeps)
{
  for (unsigned seed = first; seed < first + count; ++seed)
  {
    const int labels = 2 + static_cast<int>(seed % 5);
    const int blurs = static_cast<int>(seed / 5 % 4);
    const LabelImage image = checks::RandomLabels(16, labels, seed, blurs);
    const TriangleComplex surface = Extracted(image);
    for (const int n : sweeps)
    {
      checks::ExpectGuarantees(image, surface, n,
                               std::to_string(labels) + " labels, seed " + std::to_string(seed) +
                                 ", blurred " + std::to_string(blurs) + ", " + std::to_string(n) + " sweeps");
    }
  }
}

} // namespace

TEST(SmoothGuarantees, RandomImages)
{
  ExpectForRandomImages(1, 1, { 5 });
  ExpectForRandomImages(9, 2, { 20 });
}

TEST(LongSmoothGuarantees, RandomImages)
{
  ExpectForRandomImages(0, 300, { 5, 20, 100 });
}

TEST(SmoothGuarantees, SheetsOneVoxelApart)
{
  const LabelImage image = images::Make({ { 20, 20, 9 } },
                                        [](Id i, Id j, Id k)
                                        {
                                          const bool rim = i < 2 || j < 2 || i > 17 || j > 17;
                                          return !rim && (k == 2 || k == 3 || k == 5 || k == 6) ? 1 : 0;
                                        });
  for (const int sweeps : { 5, 20, 100 })
  {
    checks::ExpectGuarantees(image, Extracted(image), sweeps, std::to_string(sweeps));
  }
}

TEST(SmoothGuarantees, TouchingVessels)
{
  // Two oblique vessels of two materials that touch, and two of one material a voxel apart.
  for (const int second : { 1, 2 })
  {
    const LabelImage image = images::MakeCentred(26,
                                                 [&](double x, double y, double z)
                                                 {
                                                   const double gap = second == 1 ? 4.2 : 3.4;
                                                   const double u = x - 0.2 * z;
                                                   return std::abs(z) > 10               ? 0
                                                          : std::hypot(u - gap, y) < 3.4 ? 1
                                                          : std::hypot(u + gap, y) < 3.4 ? second
                                                                                         : 0;
                                                 });
    for (const int sweeps : { 5, 20, 100 })
    {
      checks::ExpectGuarantees(image, Extracted(image), sweeps,
                               std::to_string(second) + ", " + std::to_string(sweeps) + " sweeps");
    }
  }
}

TEST(SmoothGuarantees, ChordaeOfTwoVoxels)
{
  for (const double tilt : { 0.0, 0.6 })
  {
    const Vec3 axis = Normalized(Vec3{ std::sin(tilt), 0.3 * std::sin(tilt), std::cos(tilt) });
    const LabelImage image =
      images::MakeCentred(24,
                          [&](double x, double y, double z)
                          {
                            const Vec3 p{ x, y, z };
                            const bool block =
                              std::abs(z) > 7 && std::abs(z) < 10 && std::abs(x) < 10 && std::abs(y) < 10;
                            return block || (std::abs(z) <= 7 && Norm(p - Dot(p, axis) * axis) < 1.1) ? 1 : 0;
                          });
    for (const int sweeps : { 5, 20, 100 })
    {
      checks::ExpectGuarantees(image, Extracted(image), sweeps,
                               std::to_string(tilt) + ", " + std::to_string(sweeps) + " sweeps");
    }
  }
}

TEST(SmoothGuarantees, TheImagesVolumesComeBack)
{
  // Two balls that touch over an edge: the repair bridges them, and a cavity of one voxel is in one of them.
  const LabelImage image = images::Make({ { 26, 26, 14 } },
                                        [](Id i, Id j, Id k)
                                        {
                                          const bool first = i >= 3 && i < 12 && j >= 3 && j < 12;
                                          const bool second = i >= 12 && i < 21 && j >= 12 && j < 21;
                                          return k >= 3 && k < 11 && (first || second) ? 1 : 0;
                                        });
  ExtractInterfacesReport told;
  TriangleComplex surface = Extracted(image, &told);
  const double voxels = images::CountOf(image, 1);
  ASSERT_GT(told.repairedVoxels, 0);
  EXPECT_EQ(told.imageVolumes[0], voxels);
  EXPECT_GT(std::abs(MaterialVolumes(surface, { 1 })[0] - voxels), 0.5);
  ThreadMonitor monitor(2);
  const auto report = SmoothSurface(surface, {}, monitor);
  ASSERT_TRUE(report);
  EXPECT_NEAR(MaterialVolumes(surface, { 1 })[0], voxels, 1e-12 * voxels);
  EXPECT_TRUE(report->missedPieces.empty());
  EXPECT_NEAR(report->volumesHeld[0], voxels, 1e-12 * voxels);
  // A second run has nothing to give back, and holds.
  SmoothSurfaceOptions more;
  more.sweeps = 100;
  ASSERT_TRUE(SmoothSurface(surface, more, monitor));
  EXPECT_NEAR(MaterialVolumes(surface, { 1 })[0], voxels, 1e-12 * voxels);
}

TEST(SmoothGuarantees, CavitiesBelongToTheirPiece)
{
  // A shell with a hollow inside another material: pieces, not shells, have volumes.
  const LabelImage image = images::MakeCentred(20,
                                               [](double x, double y, double z)
                                               {
                                                 const double r = std::sqrt(x * x + y * y + z * z);
                                                 return r < 2.6 ? 0 : (r < 5.2 ? 2 : (r < 8.2 ? 1 : 0));
                                               });
  ThreadMonitor monitor(2);
  TriangleComplex surface = Extracted(image);
  const auto report = SmoothSurface(surface, {}, monitor);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->pieces, 3) << "material 1, material 2 and the hollow";
  for (int m : { 1, 2 })
  {
    const double voxels = images::CountOf(image, m);
    EXPECT_NEAR(MaterialVolumes(surface, { m })[0], voxels, 1e-12 * voxels);
  }
}

TEST(SmoothGuarantees, StopsByItself)
{
  const LabelImage image = images::Ball(18, 6);
  TriangleComplex surface = Extracted(image);
  TriangleComplex unending = surface;
  ThreadMonitor monitor(2);
  SmoothSurfaceOptions options;
  options.sweeps = 1000;
  const auto report = SmoothSurface(surface, options, monitor);
  ASSERT_TRUE(report);
  EXPECT_LT(report->sweepsDone, 200);
  options.sweeps = 60;
  options.settled = 0;
  const auto all = SmoothSurface(unending, options, monitor);
  ASSERT_TRUE(all);
  EXPECT_EQ(all->sweepsDone, 60);
}

TEST(SmoothGuarantees, DriftCapsAreKept)
{
  const TriangleComplex start = Extracted(images::Ball(22, 8));
  const double unit = MeanEdgeLength(start);
  ThreadMonitor monitor(2);
  SmoothSurfaceOptions options;
  options.largestDisplacement = 0.3;
  TriangleComplex surface = start;
  ASSERT_TRUE(SmoothSurface(surface, options, monitor));
  double most = 0;
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    most = std::max(most, Norm(surface.points[p] - start.points[p]));
  }
  EXPECT_LE(most, (1 + 1e-9) * 0.3 * unit);
  EXPECT_GT(most, 0.2 * unit);
}

TEST(SmoothGuarantees, FaultySurfacesIfAccepted)
{
  // A surface with a hole that also crosses another: what is sound becomes smooth, the rest stays.
  TriangleComplex surface = Extracted(images::Ball(16, 5));
  const TriangleComplex other = surface;
  const Id shift = static_cast<Id>(surface.points.size());
  for (std::size_t p = 0; p < other.points.size(); ++p)
  {
    surface.points.push_back(other.points[p] + Vec3{ 8.3, 1.4, 0.7 });
  }
  for (const Triangle& t : other.triangles)
  {
    surface.triangles.push_back({ { t[0] + shift, t[1] + shift, t[2] + shift } });
    surface.materials.push_back({ 2, 0 });
  }
  surface.triangles.erase(surface.triangles.begin());
  surface.materials.erase(surface.materials.begin());
  surface.junctionKind.clear();
  surface.junctionOrder.clear();
  ThreadMonitor monitor(2);
  SmoothSurfaceOptions options;
  EXPECT_FALSE(SmoothSurface(surface, options, monitor)) << "the default refuses";
  const auto crossing = FindIntersections(surface.points, surface.triangles, monitor);
  ASSERT_FALSE(crossing.empty());
  options.acceptFaults = true;
  const TriangleComplex start = surface;
  const auto report = SmoothSurface(surface, options, monitor);
  ASSERT_TRUE(report) << report.GetError().message;
  EXPECT_GT(report->faultyEdges, 0);
  EXPECT_EQ(report->faultyPairs, static_cast<Id>(crossing.size()));
  EXPECT_EQ(FindIntersections(surface.points, surface.triangles, monitor), crossing) << "no new ones";
  std::size_t moved = 0;
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    moved += surface.points[p] == start.points[p] ? 0 : 1;
  }
  EXPECT_GT(moved, surface.points.size() / 2);
  for (const Id p : start.triangles[static_cast<std::size_t>(crossing[0][0])])
  {
    EXPECT_EQ(surface.points[static_cast<std::size_t>(p)], start.points[static_cast<std::size_t>(p)]);
  }
}
