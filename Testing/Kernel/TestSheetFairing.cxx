// SPDX-License-Identifier: BSD-3-Clause
// The linear problems of fairing against waves and spheres whose answers are known.
#include "Shapes.h"
#include "Surface/SheetFairing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace lamina;

namespace
{

constexpr double pi = 3.141592653589793;

/// A square of n x n cells of edge 1 in the plane z = 0, with the heights of a wave along x.
TriangleComplex WavySquare(Id n, double wavelength, double height)
{
  TriangleComplex square;
  for (Id j = 0; j <= n; ++j)
  {
    for (Id i = 0; i <= n; ++i)
    {
      const double x = static_cast<double>(i);
      square.points.push_back({ x, static_cast<double>(j), height * std::cos(2 * pi * x / wavelength) });
    }
  }
  for (Id j = 0; j < n; ++j)
  {
    for (Id i = 0; i < n; ++i)
    {
      const Id a = i + (n + 1) * j;
      square.triangles.push_back({ a, a + 1, a + n + 2 });
      square.triangles.push_back({ a, a + n + 2, a + n + 1 });
      square.materials.push_back({ 1, 0 });
      square.materials.push_back({ 1, 0 });
    }
  }
  return square;
}

std::vector<char> All(const TriangleComplex& surface, char flag)
{
  return std::vector<char>(surface.points.size(), flag);
}

} // namespace

TEST(SheetFairing, WavesGoByTheirLength)
{
  // A wave of length L keeps 1 / (1 + (W / L)^4) of its height.
  const Id n = 48;
  for (const double length : { 6.0, 12.0, 24.0 })
  {
    const double height = 0.01;
    const double levelled = 12;
    TriangleComplex square = WavySquare(n, length, height);
    ClassifyJunctions(square);
    ThreadMonitor monitor(2);
    const SmoothingState state(square);
    const SheetFairing fairing(state, monitor);
    const auto offsets =
      fairing.Offsets(std::vector<Vec3>(square.points.size(), { 0, 0, 1 }), All(square, 1), levelled);
    const double kept = 1 / (1 + std::pow(levelled / length, 4));
    for (Id i = 18; i <= 30; ++i) // away from the square's rim
    {
      const auto p = static_cast<std::size_t>(i + (n + 1) * (n / 2));
      const double wave = height * std::cos(2 * pi * static_cast<double>(i) / length);
      EXPECT_NEAR(square.points[p].z + offsets[p], kept * wave, 0.08 * height) << length << ' ' << i;
    }
  }
}

TEST(SheetFairing, SpheresStay)
{
  TriangleComplex sphere;
  shapes::AddSphere(sphere, { 0, 0, 0 }, 10, 4, { 1, 0 });
  std::vector<Vec3> normals;
  for (const Vec3& p : sphere.points)
  {
    normals.push_back(Normalized(p));
  }
  ClassifyJunctions(sphere);
  ThreadMonitor monitor(2);
  const SmoothingState state(sphere);
  const SheetFairing fairing(state, monitor);
  const auto offsets = fairing.Offsets(normals, All(sphere, 1), 10);
  double volume = 0;
  for (std::size_t p = 0; p < offsets.size(); ++p)
  {
    EXPECT_LT(std::abs(offsets[p]), 0.003 * 10)
      << p; // most at the corners of the octahedron, four triangles each
    volume += offsets[p] * fairing.AreaOf(static_cast<Id>(p));
  }
  EXPECT_LT(std::abs(volume), 0.02);
}

TEST(SheetFairing, HeldPointsStay)
{
  TriangleComplex square = WavySquare(12, 6, 0.1);
  ClassifyJunctions(square);
  ThreadMonitor monitor(2);
  const SmoothingState state(square);
  const SheetFairing fairing(state, monitor);
  std::vector<char> free = All(square, 1);
  free[80] = 0;
  const std::vector<Vec3> up(square.points.size(), { 0, 0, 1 });
  EXPECT_EQ(fairing.Offsets(up, free, 12)[80], 0);
  EXPECT_EQ(fairing.Offsets(up, All(square, 0), 12), std::vector<double>(square.points.size(), 0));
}

TEST(SheetFairing, SpreadVolumesAddUp)
{
  TriangleComplex square = WavySquare(20, 7, 0.1);
  ClassifyJunctions(square);
  ThreadMonitor monitor(2);
  const SmoothingState state(square);
  const SheetFairing fairing(state, monitor);
  std::vector<char> free = All(square, 1);
  for (std::size_t p = 0; p < free.size(); p += 5)
  {
    free[p] = 0;
  }
  std::vector<double> volumes(free.size(), 0);
  volumes[222] = 0.3;
  volumes[223] = -0.1;
  ASSERT_TRUE(free[222] && free[223]);
  const auto offsets = fairing.Spread(volumes, free, 3);
  double sum = 0;
  for (std::size_t p = 0; p < offsets.size(); ++p)
  {
    EXPECT_TRUE(free[p] || offsets[p] == 0) << p;
    sum += offsets[p] * fairing.AreaOf(static_cast<Id>(p));
  }
  EXPECT_NEAR(sum, 0.2, 1e-3);
}
