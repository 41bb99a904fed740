// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/VisibleDirection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace lamina;

namespace
{

double LeastCosine(const Vec3& direction, const std::vector<Vec3>& normals)
{
  double least = 1;
  for (const Vec3& n : normals)
  {
    least = std::min(least, Dot(direction, n));
  }
  return least;
}

/// Directions spread evenly over the sphere (a Fibonacci spiral).
std::vector<Vec3> Spiral(int count)
{
  std::vector<Vec3> directions;
  for (int i = 0; i < count; ++i)
  {
    const double z = 1 - (2 * i + 1.0) / count;
    const double turn = i * 2.399963229728653;
    const double r = std::sqrt(1 - z * z);
    directions.push_back({ r * std::cos(turn), r * std::sin(turn), z });
  }
  return directions;
}

double BestSample(const std::vector<Vec3>& normals)
{
  static const std::vector<Vec3> directions = Spiral(20000); // about 1.5 degrees apart
  double best = -1;
  for (const Vec3& d : directions)
  {
    best = std::max(best, LeastCosine(d, normals));
  }
  return best;
}

Vec3 RandomUnit(std::mt19937& random)
{
  std::normal_distribution<double> normal;
  return Normalized({ normal(random), normal(random), normal(random) });
}

} // namespace

TEST(VisibleDirection, KnownCones)
{
  EXPECT_EQ(FindVisibleDirection({}).leastCosine, -1);
  const VisibleDirection one = FindVisibleDirection({ { 0, 0, 1 } });
  EXPECT_EQ(one.direction, (Vec3{ 0, 0, 1 }));
  EXPECT_EQ(one.leastCosine, 1);
  const VisibleDirection corner = FindVisibleDirection({ { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } });
  EXPECT_NEAR(corner.leastCosine, 1 / std::sqrt(3.0), 1e-14);
  EXPECT_NEAR(Norm(corner.direction - Normalized({ 1, 1, 1 })), 0, 1e-14);
  const VisibleDirection ridge = FindVisibleDirection({ { 1, 0, 0 }, { 0, 1, 0 }, Normalized({ 1, 1, 0 }) });
  EXPECT_NEAR(ridge.leastCosine, std::sqrt(0.5), 1e-14);
}

TEST(VisibleDirection, NormalsRoundACone)
{
  for (const double degrees : { 5.0, 40.0, 85.0 })
  {
    const double a = degrees * 3.14159265358979323846 / 180;
    std::vector<Vec3> normals;
    for (int i = 0; i < 9; ++i)
    {
      normals.push_back({ std::sin(a) * std::cos(0.7 * i), std::sin(a) * std::sin(0.7 * i), std::cos(a) });
    }
    const VisibleDirection best = FindVisibleDirection(normals);
    EXPECT_NEAR(best.leastCosine, std::cos(a), 1e-10) << degrees;
    EXPECT_NEAR(best.direction.z, 1, 1e-10) << degrees;
  }
}

TEST(VisibleDirection, WeighedAgainstSampling)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> length(0.2, 1);
  for (int round = 0; round < 60; ++round)
  {
    std::vector<Vec3> vectors;
    const Vec3 up = RandomUnit(random);
    for (int i = 0; i < 3 + round % 6; ++i)
    {
      vectors.push_back(length(random) * Normalized(RandomUnit(random) + 1.2 * up));
    }
    const VisibleDirection best = FindWeightedDirection(vectors);
    EXPECT_NEAR(Norm(best.direction), 1, 1e-12);
    EXPECT_NEAR(best.leastCosine, LeastCosine(best.direction, vectors), 1e-12);
    EXPECT_GE(best.leastCosine, BestSample(vectors) - 1e-12);
    EXPECT_LE(best.leastCosine, BestSample(vectors) + 0.03);
  }
  // With vectors of one length it is the direction that sees all best.
  const std::vector<Vec3> corner{ { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  EXPECT_NEAR(FindWeightedDirection(corner).leastCosine, FindVisibleDirection(corner).leastCosine, 1e-12);
  EXPECT_EQ(FindWeightedDirection({}).leastCosine, -1);
}

TEST(VisibleDirection, NothingIsSeenFromBothSides)
{
  EXPECT_LE(FindVisibleDirection({ { 0, 0, 1 }, { 0, 0, -1 } }).leastCosine, 0);
  EXPECT_LE(
    FindVisibleDirection({ { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } })
      .leastCosine,
    0);
}

TEST(VisibleDirection, NoSampleIsBetterOnRandomCones)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> opening(0, 1);
  for (int n = 0; n < 60; ++n)
  {
    const Vec3 axis = RandomUnit(random);
    const double least = n % 3 == 0 ? 0.1 : opening(random); // cosine of the cone's half-angle
    std::vector<Vec3> normals;
    while (normals.size() < 3 + random() % 10)
    {
      const Vec3 v = RandomUnit(random);
      if (Dot(v, axis) >= least)
      {
        normals.push_back(v);
      }
    }
    const VisibleDirection best = FindVisibleDirection(normals);
    const double sampled = BestSample(normals);
    EXPECT_NEAR(Norm(best.direction), 1, 1e-12);
    EXPECT_NEAR(best.leastCosine, LeastCosine(best.direction, normals), 1e-12);
    EXPECT_GE(best.leastCosine, sampled - 1e-9) << n;
    EXPECT_LE(best.leastCosine, sampled + 0.03) << n;
  }
}

TEST(VisibleDirection, TellsWhetherThereIsOne)
{
  std::mt19937 random(6);
  int seen = 0;
  int hidden = 0;
  for (int n = 0; n < 60; ++n)
  {
    std::vector<Vec3> normals;
    for (int i = 0; i < 6; ++i)
    {
      normals.push_back(RandomUnit(random));
    }
    const double sampled = BestSample(normals);
    const double found = FindVisibleDirection(normals).leastCosine;
    if (sampled > 0)
    {
      ++seen;
      EXPECT_GE(found, sampled - 1e-9) << n;
    }
    else if (sampled < -0.03)
    {
      ++hidden;
      EXPECT_LE(found, 0) << n;
    }
  }
  EXPECT_GT(seen, 5);
  EXPECT_GT(hidden, 5);
}
