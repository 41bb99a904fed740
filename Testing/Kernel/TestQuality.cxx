// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/Quality.h"

#include <gtest/gtest.h>

#include <random>

using namespace lamina;

namespace
{

/// Right prism over triangle (a, b, c), VTK order: the base normal points out.
std::array<Vec3, 6> Prism(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& up)
{
  return { { a, c, b, a + up, c + up, b + up } };
}

const double Root3 = std::sqrt(3.0);

/// The nodes, each moved at random.
template<std::size_t Count>
std::array<Vec3, Count> Shaken(std::array<Vec3, Count> p, std::mt19937& generator,
                               std::normal_distribution<double>& noise)
{
  for (Vec3& node : p)
  {
    node += { noise(generator), noise(generator), noise(generator) };
  }
  return p;
}

std::array<Vec3, 6> EvenPrism(double height)
{
  return Prism({ 0, 0, 0 }, { 1, 0, 0 }, { 0.5, Root3 / 2, 0 }, { 0, 0, height });
}

/// Jacobian of the isoparametric wedge from its shape functions.
double WedgeDeterminant(const std::array<Vec3, 6>& p, double u, double v, double z)
{
  const Vec3 du = (1 - z) * (p[2] - p[0]) + z * (p[5] - p[3]);
  const Vec3 dv = (1 - z) * (p[1] - p[0]) + z * (p[4] - p[3]);
  const Vec3 dz = (1 - u - v) * (p[3] - p[0]) + v * (p[4] - p[1]) + u * (p[5] - p[2]);
  return Dot(Cross(du, dv), dz);
}

double PyramidDeterminant(const std::array<Vec3, 5>& p, double u, double v, double z)
{
  const Vec3 base = (1 - u) * (1 - v) * p[0] + u * (1 - v) * p[1] + u * v * p[2] + (1 - u) * v * p[3];
  const Vec3 du = (1 - z) * ((1 - v) * (p[1] - p[0]) + v * (p[2] - p[3]));
  const Vec3 dv = (1 - z) * ((1 - u) * (p[3] - p[0]) + u * (p[2] - p[1]));
  return Dot(Cross(du, dv), p[4] - base);
}

constexpr double GaussPoints[3] = { 0.11270166537925831, 0.5, 0.88729833462074169 };
constexpr double GaussWeights[3] = { 5.0 / 18, 8.0 / 18, 5.0 / 18 };

template<typename F>
double Integrate(F&& f)
{
  double sum = 0;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      for (int k = 0; k < 3; ++k)
      {
        sum += GaussWeights[i] * GaussWeights[j] * GaussWeights[k] *
               f(GaussPoints[i], GaussPoints[j], GaussPoints[k]);
      }
    }
  }
  return sum;
}

} // namespace

TEST(Quality, Triangle)
{
  EXPECT_NEAR(TriangleQuality({ 0, 0, 0 }, { 1, 0, 0 }, { 0.5, Root3 / 2, 0 }), 1, 1e-15);
  EXPECT_NEAR(TriangleQuality({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }), 2 * std::sqrt(2.0) - 2, 1e-15);
  EXPECT_EQ(TriangleQuality({ 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }), 0);
  EXPECT_EQ(TriangleQuality({ 1, 1, 1 }, { 1, 1, 1 }, { 1, 1, 1 }), 0);
}

TEST(Quality, TetReferenceValues)
{
  EXPECT_NEAR(TetQuality({ 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 }), -1, 1e-14);
  EXPECT_NEAR(TetQuality({ 1, 1, 1 }, { -1, 1, -1 }, { 1, -1, -1 }, { -1, -1, 1 }), 1, 1e-14);
  EXPECT_NEAR(std::abs(TetQuality({ 1, 0, 0.1 }, { -1, 0, 0.1 }, { 0, 1, -0.1 }, { 0, -1, -0.1 })), 0.2927,
              5e-5);
  EXPECT_EQ(TetQuality({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }), 0);
  EXPECT_EQ(TetQuality({ 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 }), 0);
  EXPECT_NEAR(TetVolume({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }), 1.0 / 6, 1e-16);
  const auto angles = TetDihedralAngles({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 });
  EXPECT_NEAR(angles[0], 54.735610317245346, 1e-12);
  EXPECT_NEAR(angles[1], 90, 1e-12);
}

TEST(Quality, WedgeReferenceValues)
{
  const Vec3 a{ 0, 0, 0 };
  const Vec3 b{ 1, 0, 0 };
  const Vec3 c{ 0.5, Root3 / 2, 0 };
  for (double height : { 0.01, 1.0, 30.0 })
  {
    EXPECT_NEAR(WedgeQuality(Prism(a, b, c, { 0, 0, height })), 1, 1e-12);
    EXPECT_NEAR(WedgeVolume(Prism(a, b, c, { 0, 0, height })), height * Root3 / 4, 1e-12);
  }
  EXPECT_NEAR(WedgeQuality(Prism(a, b, c, { 1, 0, 1 })), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(WedgeQuality(Prism(a, b, { 0, 1, 0 }, { 0, 0, 1 })), std::sqrt(2.0 / 3), 1e-12);
  EXPECT_LT(WedgeQuality(Prism(a, b, c, { 0, 0, -1 })), 0);
  EXPECT_FALSE(WedgeIsValid(Prism(a, b, c, { 0, 0, -1 })));
  EXPECT_FALSE(WedgeIsValid(Prism(a, b, c, { 0, 0, 0 })));
  // Turned by almost half a turn on its way up it is still sound, though middle coefficients are negative.
  const double turn = 179.0 / 57.29577951308232;
  auto twisted = Prism({ 1, 0, 0 }, { -0.5, Root3 / 2, 0 }, { -0.5, -Root3 / 2, 0 }, { 0, 0, 1 });
  for (std::size_t i = 3; i < 6; ++i)
  {
    const Vec3 p = twisted[i];
    twisted[i] = { p.x * std::cos(turn) - p.y * std::sin(turn), p.x * std::sin(turn) + p.y * std::cos(turn),
                   p.z };
  }
  EXPECT_TRUE(WedgeIsValid(twisted));
  EXPECT_LT(WedgeJacobian(twisted)[1][0], 0);
}

TEST(Quality, SplitsOfWedges)
{
  // All tets with a corner on each side edge and one edge along one, against what the wedge's order says.
  std::mt19937 generator(5);
  std::normal_distribution<double> noise(0, 0.2);
  int valid = 0;
  for (int cell = 0; cell < 400; ++cell)
  {
    const auto right = EvenPrism(0.6);
    const auto p = Shaken(right, generator, noise);
    bool all = true;
    for (unsigned choice = 0; choice < 24; ++choice)
    {
      // Corner `choice % 3` is there below and above; the other two, each below or above.
      const std::size_t i = choice % 3;
      const std::size_t j = (i + 1) % 3 + (choice / 3 % 2) * 3;
      const std::size_t k = (i + 2) % 3 + (choice / 6 % 2) * 3;
      const double sign = TetVolume(right[i], right[j], right[k], right[i + 3]);
      all = all && sign * TetVolume(p[i], p[j], p[k], p[i + 3]) > 0;
    }
    EXPECT_EQ(WedgeSplitsAreValid(p), all) << cell;
    valid += all ? 1 : 0;
  }
  EXPECT_GT(valid, 50);
  EXPECT_LT(valid, 350);
  EXPECT_TRUE(WedgeSplitsAreValid(Prism({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 })));
  EXPECT_FALSE(WedgeSplitsAreValid(Prism({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, -1 })));
}

TEST(Quality, WedgeAgreesWithSamplingAndQuadrature)
{
  std::mt19937 generator(3);
  std::normal_distribution<double> noise(0, 0.28);
  int valid = 0;
  for (int cell = 0; cell < 1000; ++cell)
  {
    const auto p = Shaken(EvenPrism(0.8), generator, noise);
    double least = 1e300;
    constexpr int steps = 400;
    for (int k = 0; k <= steps; ++k)
    {
      const double z = k / static_cast<double>(steps);
      least = std::min({ least, WedgeDeterminant(p, 0, 0, z), WedgeDeterminant(p, 1, 0, z),
                         WedgeDeterminant(p, 0, 1, z), WedgeDeterminant(p, 0.3, 0.3, z),
                         WedgeDeterminant(p, 0.1, 0.6, z) });
    }
    if (std::abs(least) > 1e-5) // else the samples are too coarse to tell
    {
      EXPECT_EQ(WedgeIsValid(p), least > 0);
      EXPECT_EQ(WedgeQuality(p) > 0, least > 0);
    }
    valid += least > 0;
    // The triangle as a square squeezed by v -> v (1 - u).
    const double volume = Integrate([&](double u, double v, double z)
                                    { return (1 - u) * WedgeDeterminant(p, u, v * (1 - u), z); });
    EXPECT_NEAR(WedgeVolume(p), volume, 1e-13);
  }
  EXPECT_GT(valid, 200);
  EXPECT_LT(valid, 900);
}

TEST(Quality, PyramidAgreesWithSamplingAndQuadrature)
{
  std::mt19937 generator(4);
  std::normal_distribution<double> noise(0, 0.3);
  int valid = 0;
  for (int cell = 0; cell < 1000; ++cell)
  {
    const std::array<Vec3, 5> even{
      { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0.5, 0.5, 0.6 } }
    };
    const auto p = Shaken(even, generator, noise);
    double least = 1e300;
    for (int i = 0; i <= 10; ++i)
    {
      for (int j = 0; j <= 10; ++j)
      {
        least = std::min(least, PyramidDeterminant(p, 0.1 * i, 0.1 * j, 0));
      }
    }
    if (std::abs(least) > 1e-12)
    {
      EXPECT_EQ(PyramidIsValid(p), least > 0);
    }
    EXPECT_TRUE(least > 0 || PyramidQuality(p) <= 0);
    valid += least > 0;
    // The determinant already holds (1-z)^2.
    EXPECT_NEAR(PyramidVolume(p),
                Integrate([&](double u, double v, double z) { return PyramidDeterminant(p, u, v, z); }),
                1e-13);
  }
  EXPECT_GT(valid, 200);
  EXPECT_LT(valid, 900);
  const double h = std::sqrt(0.5);
  EXPECT_NEAR(PyramidQuality({ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0.5, 0.5, h } } }),
              TetQuality({ 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0.5, 0.5, h }), 1e-14);
}
