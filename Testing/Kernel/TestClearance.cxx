// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Clearance.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace lamina;

namespace
{

std::array<Vec3, 3> CornersOf(const std::vector<Vec3>& points, const Triangle& t)
{
  return { { points[static_cast<std::size_t>(t[0])], points[static_cast<std::size_t>(t[1])],
             points[static_cast<std::size_t>(t[2])] } };
}

/// The least distance of points on a fine grid over both triangles: never below the truth, and above it by
/// less than the grid's step.
double SampledDistance(const std::array<Vec3, 3>& s, const std::array<Vec3, 3>& t, int steps)
{
  const auto grid = [steps](const std::array<Vec3, 3>& c)
  {
    std::vector<Vec3> places;
    for (int i = 0; i <= steps; ++i)
    {
      for (int j = 0; i + j <= steps; ++j)
      {
        places.push_back((1.0 / steps) * (static_cast<double>(i) * c[0] + static_cast<double>(j) * c[1] +
                                          static_cast<double>(steps - i - j) * c[2]));
      }
    }
    return places;
  };
  double best = 1e300;
  const auto onT = grid(t);
  for (const Vec3& p : grid(s))
  {
    for (const Vec3& q : onT)
    {
      best = std::min(best, Norm2(p - q));
    }
  }
  return std::sqrt(best);
}

std::vector<double> BruteForce(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                               const std::vector<double>& cutoffs)
{
  std::vector<double> least = cutoffs;
  for (const Triangle& s : triangles)
  {
    double best = 0;
    for (Id p : s)
    {
      best = std::max(best, cutoffs[static_cast<std::size_t>(p)]);
    }
    for (const Triangle& t : triangles)
    {
      const bool apart =
        std::none_of(s.begin(), s.end(), [&](Id p) { return std::find(t.begin(), t.end(), p) != t.end(); });
      if (apart)
      {
        best =
          std::min(best, std::sqrt(TriangleTriangleDistance2(CornersOf(points, s), CornersOf(points, t))));
      }
    }
    for (Id p : s)
    {
      least[static_cast<std::size_t>(p)] = std::min(least[static_cast<std::size_t>(p)], best);
    }
  }
  return least;
}

TriangleComplex TwoSpheres()
{
  TriangleComplex surface;
  shapes::AddSphere(surface, {}, 1, 2, { 1, 0 });
  shapes::AddSphere(surface, { 2.3, 0.1, -0.2 }, 1, 2, { 1, 0 });
  return surface;
}

} // namespace

TEST(Clearance, KnownDistances)
{
  const std::array<Vec3, 3> base{ { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 } } };
  const auto to = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    return std::sqrt(TriangleTriangleDistance2(base, { { a, b, c } }));
  };
  EXPECT_DOUBLE_EQ(to({ 1, 1, 2 }, { 5, 1, 6 }, { 1, 5, 6 }), 2);                  // corner over the inside
  EXPECT_DOUBLE_EQ(to({ 1, 1, 3 }, { 2, 1, 3 }, { 1, 2, 3 }), 3);                  // parallel
  EXPECT_DOUBLE_EQ(to({ -3, 1, 4 }, { -3, 2, 4 }, { -9, 1, 4 }), 5);               // edge to edge
  EXPECT_DOUBLE_EQ(to({ -1, 2, -1 }, { -1, 2, 1 }, { -5, 2, 0 }), 1);              // crossing edges
  EXPECT_DOUBLE_EQ(to({ 4, 4, 0 }, { 9, 4, 0 }, { 4, 9, 0 }), 2 * std::sqrt(2.0)); // in one plane
}

TEST(Clearance, DistanceAgreesWithSamples)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> at(0, 1);
  const auto triangle = [&](double shift)
  {
    std::array<Vec3, 3> t;
    for (Vec3& p : t)
    {
      p = { at(random) + shift, at(random), at(random) };
    }
    return t;
  };
  constexpr int steps = 24;
  for (int n = 0; n < 60; ++n)
  {
    const auto s = triangle(0);
    const auto t = triangle(n % 2 == 0 ? 1.02 : 1.4);
    const double exact = std::sqrt(TriangleTriangleDistance2(s, t));
    const double sampled = SampledDistance(s, t, steps);
    EXPECT_LE(exact, sampled + 1e-12);
    EXPECT_GE(exact, sampled - 2 * 1.8 / steps);
    EXPECT_DOUBLE_EQ(exact, std::sqrt(TriangleTriangleDistance2(t, s)));
  }
}

TEST(Clearance, AgreesWithBruteForce)
{
  const TriangleComplex surface = TwoSpheres();
  for (const double cutoff : { 0.05, 0.35, 10.0 })
  {
    const std::vector<double> cutoffs(surface.points.size(), cutoff);
    const auto expected = BruteForce(surface.points, surface.triangles, cutoffs);
    for (int threads : { 1, 3 })
    {
      ThreadMonitor monitor(threads);
      const auto found = PointClearances(surface.points, surface.triangles, cutoff, monitor);
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t p = 0; p < found.size(); ++p)
      {
        EXPECT_NEAR(found[p], expected[p], 1e-14) << cutoff << ' ' << p;
      }
    }
  }
}

TEST(Clearance, EveryPointHasItsOwnCutoff)
{
  const TriangleComplex surface = TwoSpheres();
  std::mt19937 random(9);
  std::uniform_real_distribution<double> length(0, 0.6);
  std::vector<double> cutoffs(surface.points.size());
  for (double& c : cutoffs)
  {
    c = length(random);
  }
  ThreadMonitor monitor(2);
  const auto expected = BruteForce(surface.points, surface.triangles, cutoffs);
  const auto found = PointClearances(surface.points, surface.triangles, cutoffs, monitor);
  int bound = 0;
  for (std::size_t p = 0; p < found.size(); ++p)
  {
    EXPECT_NEAR(found[p], expected[p], 1e-14) << p;
    bound += found[p] < cutoffs[p] ? 1 : 0;
  }
  EXPECT_GT(bound, 10);
}
