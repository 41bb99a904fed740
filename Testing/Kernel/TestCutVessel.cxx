// SPDX-License-Identifier: BSD-3-Clause
#include "Images.h"
#include "Mesh/Closedness.h"
#include "Mesh/VolumeCorrection.h"
#include "Search/SelfIntersection.h"
#include "Shapes.h"
#include "Surface/CutVessel.h"
#include "Surface/ExtractInterfaces.h"

#include <gtest/gtest.h>

#include <map>

using namespace lamina;

namespace
{

constexpr double Pi = 3.141592653589793;

TriangleComplex SurfaceOf(const LabelImage& image)
{
  ThreadMonitor monitor(2);
  TriangleComplex surface;
  EXPECT_TRUE(ExtractInterfaces(image, surface, {}, monitor));
  return surface;
}

/// A tube of blood in tissue along z, in the middle of 24 x 24 x 40 voxels.
LabelImage Vessel()
{
  return images::Make({ { 24, 24, 40 } },
                      [](Id i, Id j, Id k)
                      {
                        const double r =
                          std::hypot(static_cast<double>(i) - 11.5, static_cast<double>(j) - 11.5);
                        return k < 3 || k > 36 ? 0 : (r < 5.2 && k > 5 && k < 34 ? 2 : (r < 8.3 ? 1 : 0));
                      });
}

/// A bent vessel: two legs along z, joined by an arch above z = 20.
LabelImage Arch()
{
  return images::Make({ { 40, 14, 36 } },
                      [](Id i, Id j, Id k)
                      {
                        const double x = static_cast<double>(i) - 19.5;
                        const double y = static_cast<double>(j) - 6.5;
                        const double z = static_cast<double>(k) - 19.5;
                        const double ring = z > 0 ? std::hypot(x, z) : std::abs(x);
                        return k > 2 && std::hypot(ring - 11, y) < 4.3 ? 2 : 0;
                      });
}

CutVesselOptions Plane(const Vec3& origin, const Vec3& normal)
{
  CutVesselOptions options;
  options.origin = origin;
  options.normal = normal;
  return options;
}

CutVesselReport Cut(TriangleComplex& surface, const CutVesselOptions& options)
{
  ThreadMonitor monitor(2);
  const auto report = CutVessel(surface, options, monitor);
  EXPECT_TRUE(report) << report.GetError().message;
  EXPECT_FALSE(CheckClosed(surface, false, monitor));
  EXPECT_FALSE(CheckEmbedded(surface.points, surface.triangles, "the surface", monitor));
  return report ? *report : CutVesselReport{};
}

std::string FailureOf(TriangleComplex surface, const CutVesselOptions& options)
{
  ThreadMonitor monitor(2);
  const std::size_t before = surface.triangles.size();
  const auto report = CutVessel(surface, options, monitor);
  EXPECT_EQ(surface.triangles.size(), before) << "a failure changes nothing";
  return report ? "" : report.GetError().message;
}

/// The area of each patch; its points must lie in the plane.
std::map<std::string, double> EndsOf(const TriangleComplex& surface, const CutVesselOptions& options)
{
  std::map<std::string, double> areas;
  const Vec3 normal = Normalized(options.normal);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const int patch = surface.Patch(static_cast<Id>(t));
    if (patch == 0)
    {
      continue;
    }
    const Vec3 area = 0.5 * AreaVector2(surface.points, surface.triangles[t]);
    EXPECT_GT(Dot(area, normal), 0.999 * Norm(area)) << "ends look towards what was cut off";
    areas[surface.patchNames[static_cast<std::size_t>(patch)]] += Norm(area);
    for (const Id p : surface.triangles[t])
    {
      EXPECT_NEAR(Dot(surface.points[static_cast<std::size_t>(p)] - options.origin, normal), 0, 1e-6);
    }
  }
  return areas;
}

double VolumeOf(const TriangleComplex& surface, int material)
{
  return MaterialVolumes(surface, { material })[0];
}

} // namespace

TEST(CutVessel, AnObliquePlaneThroughAWalledVessel)
{
  // Radii of voxel shapes from their sections along z, where an oblique cut is larger by 1 / cosine.
  const LabelImage image = Vessel();
  const TriangleComplex whole = SurfaceOf(image);
  const auto first = image.labels.begin() + image.grid.Index(0, 0, 20);
  const auto slice = [&](int m) { return static_cast<double>(std::count(first, first + 24 * 24, m)); };
  for (const Vec3& normal : { Vec3{ 0, 0, 1 }, Vec3{ 0.3, -0.2, 1 }, Vec3{ 2, 1, 4 }, Vec3{ 0.5, 0.5, -1 } })
  {
    TriangleComplex surface = whole;
    CutVesselOptions options = Plane({ 11.3, 11.7, 20.2 }, normal);
    options.name = "outflow";
    const CutVesselReport report = Cut(surface, options);
    EXPECT_EQ(report.sections, 1);
    const auto ends = EndsOf(surface, options);
    ASSERT_EQ(ends.size(), 2u);
    const double cosine = std::abs(normal.z) / Norm(normal);
    EXPECT_NEAR(ends.at("opening_outflow"), slice(2) / cosine, 0.03 * slice(2));
    EXPECT_NEAR(ends.at("border_outflow"), slice(1) / cosine, 0.03 * slice(1));
    EXPECT_NEAR(report.area, (slice(1) + slice(2)) / cosine, 0.03 * slice(1));
    EXPECT_EQ(report.patches.size(), 2u);
    // What is left up to the plane, by the volumes of the two parts.
    TriangleComplex other = whole;
    Cut(other, Plane(options.origin, -normal));
    for (const int material : { 1, 2 })
    {
      EXPECT_NEAR(VolumeOf(surface, material) + VolumeOf(other, material), VolumeOf(whole, material),
                  2e-3 * VolumeOf(whole, material));
    }
    const double left = VolumeOf(surface, 1) + VolumeOf(surface, 2);
    EXPECT_NEAR(report.cutShare, 1 - left / (VolumeOf(whole, 1) + VolumeOf(whole, 2)), 1e-9);
  }
}

TEST(CutVessel, ARoundTube)
{
  TriangleComplex surface;
  shapes::AddClosedTube(surface, { 0, 0, 0 }, 2, 10, 0.3, 0, { 2, 0 });
  CutVesselOptions options = Plane({ 0.1, 0, 5 }, { 1, 0, 2 });
  Cut(surface, options);
  const double exact = 4 * Pi * std::sqrt(5.0) / 2;
  EXPECT_NEAR(EndsOf(surface, options).at("opening_1"), exact, 0.01 * exact);
  EXPECT_NEAR(VolumeOf(surface, 2), 4 * Pi * 5.05, 0.01 * 4 * Pi * 5);
}

TEST(CutVessel, OneLegOfAnArch)
{
  const TriangleComplex whole = SurfaceOf(Arch());
  TriangleComplex surface = whole;
  const CutVesselOptions options = Plane({ 30.5, 6.5, 10.3 }, { 0.1, 0, -1 });
  const CutVesselReport report = Cut(surface, options);
  EXPECT_EQ(report.sections, 1);
  EXPECT_EQ(EndsOf(surface, options).size(), 1u);
  // The other leg, which the same plane meets, ends where it did.
  double lowest[2] = { 1e300, 1e300 };
  for (const Vec3& p : surface.points)
  {
    double& least = lowest[p.x > 19.5 ? 1 : 0];
    least = std::min(least, p.z);
  }
  EXPECT_EQ(lowest[0], 2.5);
  EXPECT_GT(lowest[1], 9.5);
}

TEST(CutVessel, WhatComesBackIsCutInBothPlaces)
{
  TriangleComplex surface = SurfaceOf(Arch());
  const CutVesselOptions options = Plane({ 30.5, 6.5, 10.3 }, { 0.1, 0, 1 });
  const CutVesselReport report = Cut(surface, options);
  EXPECT_EQ(report.sections, 2);
  const auto ends = EndsOf(surface, options);
  EXPECT_EQ(ends.count("opening_1") + ends.count("opening_2"), 2u);
  EXPECT_GT(report.cutShare, 0.5);
}

TEST(CutVessel, InclusionsGoWithWhatTheyLieIn)
{
  // Beyond the plane a cavity with a stone in it, which is a body of its own, a stone in the blood, and a
  // body outside; a stone on this side.
  LabelImage image = Vessel();
  const auto put = [&](Id i, Id j, Id k, Id edge, int label)
  {
    for (Id n = 0; n < edge * edge * edge; ++n)
    {
      image.labels[static_cast<std::size_t>(
        image.grid.Index(i + n % edge, j + n / edge % edge, k + n / edge / edge))] = label;
    }
  };
  put(10, 10, 24, 5, 0);
  put(11, 11, 25, 2, 3);
  put(10, 10, 31, 2, 4);
  put(10, 10, 8, 2, 5);
  put(0, 0, 30, 2, 6);
  TriangleComplex surface = SurfaceOf(image);
  Cut(surface, Plane({ 11.5, 11.5, 20.2 }, { 0.1, 0.2, 1 }));
  EXPECT_EQ(MaterialsOf(surface), (std::vector<int>{ 1, 2, 3, 5, 6 }));
}

TEST(CutVessel, ThroughAnInclusionAndACavity)
{
  LabelImage image = Vessel();
  for (Id n = 0; n < 64; ++n)
  {
    image.labels[static_cast<std::size_t>(image.grid.Index(10 + n % 4, 10 + n / 4 % 4, 19 + n / 16))] = 3;
    image.labels[static_cast<std::size_t>(image.grid.Index(10 + n % 4, 17 + n / 4 % 2, 19 + n / 16))] = 0;
  }
  TriangleComplex surface = SurfaceOf(image);
  CutVesselOptions options = Plane({ 11.5, 8.2, 20.7 }, { 0.1, 0.05, 1 });
  options.openMaterials = { 2, 3 };
  const CutVesselReport report = Cut(surface, options);
  EXPECT_EQ(report.sections, 1);
  const auto ends = EndsOf(surface, options);
  EXPECT_EQ(ends.size(), 3u);
  EXPECT_NEAR(ends.count("opening_2") != 0 ? ends.at("opening_2") : 0, 16, 1);
}

TEST(CutVessel, AgainAtTheOtherEnd)
{
  TriangleComplex surface = SurfaceOf(Vessel());
  Cut(surface, Plane({ 11.5, 11.5, 28.2 }, { 0.1, 0, 1 }));
  Cut(surface, Plane({ 11.5, 11.5, 12.2 }, { 0.1, 0, -1 }));
  EXPECT_EQ(surface.patchNames,
            (std::vector<std::string>{ "wall", "border_1", "opening_1", "border_2", "opening_2" }));
}

TEST(CutVessel, OriginBesideTheVessel)
{
  TriangleComplex surface = SurfaceOf(Vessel());
  Cut(surface, Plane({ 11.5, 22.5, 20.2 }, { 0, 0, 1 }));
  const TriangleComplex whole = SurfaceOf(Vessel());
  EXPECT_NE(FailureOf(whole, Plane({ 11.5, 40, 20.2 }, { 0, 0, 1 })).find("misses the vessel"),
            std::string::npos);
}

TEST(CutVessel, PlanesThatMissAndWrongOptions)
{
  const TriangleComplex whole = SurfaceOf(Vessel());
  EXPECT_NE(FailureOf(whole, Plane({ 11.5, 11.5, 60 }, { 0, 0, 1 })).find("misses the surface"),
            std::string::npos);
  EXPECT_NE(FailureOf(whole, Plane({ 11.5, 11.5, 20 }, { 0, 0, 0 })).find("normal that is not zero"),
            std::string::npos);
  EXPECT_NE(FailureOf(whole, Plane({ NAN, 11.5, 20 }, { 0, 0, 1 })).find("finite origin"), std::string::npos);
  CutVesselOptions named = Plane({ 11.5, 11.5, 20.2 }, { 0, 0, 1 });
  named.name = "two words";
  EXPECT_NE(FailureOf(whole, named).find("letters, digits"), std::string::npos);
  TriangleComplex open = whole;
  open.triangles.pop_back();
  open.materials.pop_back();
  if (!open.patches.empty())
  {
    open.patches.pop_back();
  }
  EXPECT_NE(FailureOf(open, Plane({ 11.5, 11.5, 20.2 }, { 0, 0, 1 })), "");
  ThreadMonitor monitor(2);
  monitor.Cancel();
  TriangleComplex copy = whole;
  const auto stopped = CutVessel(copy, Plane({ 11.5, 11.5, 20.2 }, { 0, 0, 1 }), monitor);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.GetError().kind, Failure::Cancelled);
}

TEST(CutVessel, AnyPlaneThroughNoise)
{
  // Bodies of every shape: whatever the plane, the result is closed and meets itself nowhere.
  for (unsigned seed = 0; seed < 6; ++seed)
  {
    TriangleComplex whole = SurfaceOf(images::Noise(8, 3, seed));
    whole.patches.clear();
    whole.patchNames.clear();
    for (int n = 0; n < 6; ++n)
    {
      TriangleComplex surface = whole;
      const CutVesselOptions options = Plane({ 3.4, 3.1, 2.2 + 0.3 * n }, { 0.3 * n - 0.7, 0.4, 1 });
      Cut(surface, options);
      EndsOf(surface, options);
    }
  }
}
