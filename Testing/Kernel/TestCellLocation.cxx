// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/CellLocation.h"
#include "Geometry/Quality.h"

#include <gtest/gtest.h>

#include <random>

using namespace lamina;

TEST(CellLocation, Tet)
{
  const std::array<Vec3, 4> tet{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };
  EXPECT_EQ(LocateInTet(tet, { 0.2, 0.2, 0.2 }), Location::Inside);
  EXPECT_EQ(LocateInTet(tet, { 0.2, 0.2, 0 }), Location::Border);
  EXPECT_EQ(LocateInTet(tet, { 0.4, 0.4, 0.4 }), Location::Outside);
  EXPECT_EQ(LocateInTet(tet, { 2, 0, 0 }), Location::Outside);
}

TEST(CellLocation, ImagesOfInnerCoordinatesLieInside)
{
  std::mt19937 generator(8);
  std::normal_distribution<double> noise(0, 0.08);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int cell = 0; cell < 300; ++cell)
  {
    std::array<Vec3, 6> w{ { { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 0, 0, 1 }, { 0, 1, 1 }, { 1, 0, 1 } } };
    std::array<Vec3, 5> p{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0.5, 0.5, 0.7 } } };
    for (Vec3& node : w)
    {
      node += { noise(generator), noise(generator), noise(generator) };
    }
    for (Vec3& node : p)
    {
      node += { noise(generator), noise(generator), noise(generator) };
    }
    ASSERT_TRUE(WedgeIsValid(w));
    ASSERT_TRUE(PyramidIsValid(p));
    for (int i = 0; i < 20; ++i)
    {
      double u = 0.01 + 0.97 * unit(generator);
      double v = 0.01 + 0.97 * unit(generator);
      const double z = 0.01 + 0.97 * unit(generator);
      const Vec3 base = (1 - u) * (1 - v) * p[0] + u * (1 - v) * p[1] + u * v * p[2] + (1 - u) * v * p[3];
      EXPECT_EQ(LocateInPyramid(p, (1 - z) * base + z * p[4]), Location::Inside);
      EXPECT_NE(LocateInPyramid(p, base + 0.02 * (base - p[4])), Location::Inside);
      v *= 0.99 - u;
      const auto wedgeAt = [&](double height)
      {
        return (1 - height) * ((1 - u - v) * w[0] + u * w[1] + v * w[2]) +
               height * ((1 - u - v) * w[3] + u * w[4] + v * w[5]);
      };
      if (v > 0.001)
      {
        EXPECT_EQ(LocateInWedge(w, wedgeAt(z)), Location::Inside);
        EXPECT_EQ(LocateInWedge(w, wedgeAt(1.02)), Location::Outside);
        EXPECT_EQ(LocateInWedge(w, wedgeAt(-0.02)), Location::Outside);
      }
    }
  }
}
