// SPDX-License-Identifier: BSD-3-Clause
// Smoothed digital shapes against the shapes that were digitised: the staircase must be gone at the defaults.
#include "Images.h"
#include "Mesh/Adjacency.h"
#include "Surface/ExtractInterfaces.h"
#include "Surface/SmoothSurface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace lamina;

namespace
{

constexpr double degree = 3.141592653589793 / 180;

/// A shape by its signed distance, negative inside, in voxels from the image's middle.
using Distance = std::function<double(const Vec3&)>;
using Region = std::function<bool(const Vec3&)>;

TriangleComplex Extracted(Id n, const Distance& shape)
{
  ThreadMonitor monitor(2);
  const double middle = static_cast<double>(n - 1) / 2;
  LabelImage image =
    images::Make({ { n, n, n } },
                 [&](Id i, Id j, Id k)
                 {
                   const bool rim = i < 3 || j < 3 || k < 3 || i >= n - 3 || j >= n - 3 || k >= n - 3;
                   const Vec3 p{ static_cast<double>(i) - middle, static_cast<double>(j) - middle,
                                 static_cast<double>(k) - middle };
                   return !rim && shape(p) < 0 ? 1 : 0;
                 });
  image.grid.origin = { -middle, -middle, -middle };
  TriangleComplex surface;
  EXPECT_TRUE(ExtractInterfaces(image, surface, {}, monitor));
  return surface;
}

TriangleComplex Smoothed(Id n, const Distance& shape)
{
  ThreadMonitor monitor(2);
  TriangleComplex surface = Extracted(n, shape);
  EXPECT_TRUE(SmoothSurface(surface, {}, monitor));
  return surface;
}

Vec3 NormalOf(const Distance& shape, const Vec3& p)
{
  const double h = 1e-4;
  return Normalized({ shape(p + Vec3{ h, 0, 0 }) - shape(p - Vec3{ h, 0, 0 }),
                      shape(p + Vec3{ 0, h, 0 }) - shape(p - Vec3{ 0, h, 0 }),
                      shape(p + Vec3{ 0, 0, h }) - shape(p - Vec3{ 0, 0, h }) });
}

/// Root mean squares over the triangles and points in a region: the angle in degrees, the distance in voxels.
void ExpectNear(const TriangleComplex& surface, const Distance& shape, const Region& region, double angle,
                double distance, const std::string& what)
{
  double angles = 0;
  Id triangles = 0;
  for (const Triangle& t : surface.triangles)
  {
    Vec3 middle;
    for (Id p : t)
    {
      middle += (1.0 / 3) * surface.points[static_cast<std::size_t>(p)];
    }
    if (region(middle))
    {
      const Vec3 normal = Normalized(AreaVector2(surface.points, t));
      const double turn = std::acos(std::min(1.0, std::abs(Dot(normal, NormalOf(shape, middle))))) / degree;
      angles += turn * turn;
      ++triangles;
    }
  }
  double distances = 0;
  Id points = 0;
  for (const Vec3& p : surface.points)
  {
    if (region(p))
    {
      distances += shape(p) * shape(p);
      ++points;
    }
  }
  ASSERT_GT(triangles, 100) << what;
  EXPECT_LE(std::sqrt(angles / static_cast<double>(triangles)), angle) << what;
  EXPECT_LE(std::sqrt(distances / static_cast<double>(points)), distance) << what;
}

Distance Ball(double radius)
{
  return [radius](const Vec3& p) { return Norm(p - Vec3{ 0.13, 0.27, 0.41 }) - radius; };
}

Distance Slab(double tilt)
{
  const Vec3 normal{ std::sin(tilt * degree), 0, std::cos(tilt * degree) };
  return [normal](const Vec3& p) { return std::abs(Dot(p, normal) - 0.1) - 8.3; };
}

Distance Cylinder(const Vec3& axis, double radius, double halfHeight)
{
  return [=](const Vec3& p)
  {
    const double along = Dot(p, axis);
    return std::max(Norm(p - along * axis) - radius, std::abs(along) - halfHeight);
  };
}

/// The volume of a strand along `axis` between z = -height and z = height, by the divergence theorem in each
/// slice.
double VolumeInSlices(const TriangleComplex& surface, const Vec3& axis, double height)
{
  double volume = 0;
  for (const Triangle& t : surface.triangles)
  {
    Vec3 middle;
    for (Id p : t)
    {
      middle += (1.0 / 3) * surface.points[static_cast<std::size_t>(p)];
    }
    const Vec3 area = 0.5 * AreaVector2(surface.points, t);
    const Vec3 out = middle - (middle.z / axis.z) * axis;
    volume += std::abs(middle.z) < height ? (out.x * area.x + out.y * area.y) / 2 : 0;
  }
  return std::abs(volume);
}

} // namespace

TEST(SmoothTruth, Balls)
{
  const Region all = [](const Vec3&) { return true; };
  ExpectNear(Smoothed(29, Ball(10)), Ball(10), all, 3.5, 0.12, "radius 10");
  ExpectNear(Smoothed(49, Ball(20)), Ball(20), all, 2.5, 0.12, "radius 20");
  ExpectNear(Smoothed(89, Ball(40)), Ball(40), all, 2.0, 0.12, "radius 40");
}

TEST(SmoothTruth, TiltedSlabs)
{
  const Region inner = [](const Vec3& p)
  { return std::abs(p.x) < 20 && std::abs(p.y) < 20 && std::abs(p.z) < 22; };
  ExpectNear(Smoothed(64, Slab(3)), Slab(3), inner, 4.5, 0.25, "3 degrees");
  for (const double tilt : { 8.0, 15.0, 25.0, 40.0 })
  {
    ExpectNear(Smoothed(64, Slab(tilt)), Slab(tilt), inner, 1.5, 0.12, std::to_string(tilt) + " degrees");
  }
}

TEST(SmoothTruth, Cylinders)
{
  for (const Vec3& axis : { Vec3{ 0, 0, 1 }, Normalized(Vec3{ 0.3, 0.2, 0.93 }) })
  {
    const Distance shape = Cylinder(axis, 10, 22);
    ExpectNear(
      Smoothed(60, shape), shape, [&](const Vec3& p) { return std::abs(Dot(p, axis)) < 15; }, 3, 0.12,
      ToString(axis));
  }
}

TEST(SmoothTruth, StrandsKeepTheirCrossSection)
{
  // Two blocks tied by a strand of two voxels, straight or oblique: nothing may flow from one to the other.
  for (const double tilt : { 0.0, 0.3, 0.6 })
  {
    const Vec3 axis = Normalized(Vec3{ std::sin(tilt), 0.3 * std::sin(tilt), std::cos(tilt) });
    const double radius = 1.1;
    const auto inside = [&](const Vec3& p)
    {
      const bool block = std::abs(p.z) > 18 && std::abs(p.z) < 26 && std::abs(p.x) < 24 && std::abs(p.y) < 24;
      return block || (std::abs(p.z) <= 18 && Norm(p - Dot(p, axis) * axis) < radius);
    };
    const Distance shape = [&](const Vec3& p) { return inside(p) ? -1.0 : 1.0; };
    const double after = VolumeInSlices(Smoothed(60, shape), axis, 12);
    double voxels = 0;
    for (int n = 0; n < 24 * 60 * 60; ++n)
    {
      voxels += inside({ n % 60 - 29.5, n / 60 % 60 - 29.5, n / 3600 - 11.5 }) ? 1 : 0;
    }
    // The repair of the labels takes 2 % of the steepest before smoothing, which gives it back.
    EXPECT_NEAR(after / voxels, 1, 0.01) << tilt;
  }
}
