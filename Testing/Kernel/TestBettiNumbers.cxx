// SPDX-License-Identifier: BSD-3-Clause
#include "Images.h"
#include "Segmentation/BettiNumbers.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace lamina;

namespace
{

double Length(double x, double y, double z)
{
  return std::sqrt(x * x + y * y + z * z);
}

/// Distance to a ring in the plane z = 0.
double ToRing(double x, double y, double z, double radius)
{
  return Length(std::sqrt(x * x + y * y) - radius, z, 0);
}

BettiNumbers Of(const LabelImage& image, int material)
{
  ThreadMonitor monitor;
  for (const BettiNumbers& numbers : CountBettiNumbers(image, monitor))
  {
    if (numbers.material == material)
    {
      return numbers;
    }
  }
  return {};
}

void Expect(const BettiNumbers& numbers, Id b0, Id b1, Id b2, const char* what)
{
  EXPECT_EQ(numbers.b0, b0) << what;
  EXPECT_EQ(numbers.b1, b1) << what;
  EXPECT_EQ(numbers.b2, b2) << what;
}

/// A 40^3 image of `inside`, coordinates from its centre.
template<typename Inside>
LabelImage Shape(const Inside& inside)
{
  return images::Make({ { 40, 40, 40 } },
                      [&](Id i, Id j, Id k) { return inside(i - 19.5, j - 19.5, k - 19.5) ? 1 : 0; });
}

} // namespace

TEST(BettiNumbers, Ball)
{
  const LabelImage image = Shape([](double x, double y, double z) { return Length(x, y, z) < 12; });
  Expect(Of(image, 1), 1, 0, 0, "ball");
  Expect(Of(image, 0), 1, 0, 1, "around it");
}

TEST(BettiNumbers, Torus)
{
  const LabelImage image = Shape([](double x, double y, double z) { return ToRing(x, y, z, 12) < 4; });
  Expect(Of(image, 1), 1, 1, 0, "torus");
  Expect(Of(image, 0), 1, 1, 1, "around it");
}

TEST(BettiNumbers, Shell)
{
  const LabelImage image = Shape(
    [](double x, double y, double z)
    {
      const double r = Length(x, y, z);
      return r < 14 && r > 9;
    });
  Expect(Of(image, 1), 1, 0, 1, "shell");
  Expect(Of(image, 0), 2, 0, 1, "around and in it");
}

TEST(BettiNumbers, TwoToriLinkedAndApart)
{
  const auto linked = [](double x, double y, double z)
  { return ToRing(x + 5, y, z, 9) < 2.5 || ToRing(x - 5, z, y, 9) < 2.5; };
  const auto apart = [](double x, double y, double z)
  { return ToRing(x, y, z + 10, 12) < 3 || ToRing(x, y, z - 10, 12) < 3; };
  Expect(Of(Shape(linked), 1), 2, 2, 0, "linked");
  Expect(Of(Shape(apart), 1), 2, 2, 0, "apart");
}

TEST(BettiNumbers, TorusWithAHollowWall)
{
  const LabelImage image = Shape(
    [](double x, double y, double z)
    {
      const double r = ToRing(x, y, z, 12);
      return r < 5 && r > 2;
    });
  // The wall of a tube bent to a ring: around the ring, around the tube; the lumen is a cavity.
  Expect(Of(image, 1), 1, 2, 1, "hollow torus");
}

TEST(BettiNumbers, EdgesAndCornersTieTheRestOnly)
{
  LabelImage image =
    images::Make({ { 4, 4, 4 } }, [](Id i, Id j, Id k)
                 { return (i == 1 && j == 1 && k == 1) || (i == 2 && j == 2 && k == 1) ? 1 : 0; });
  Expect(Of(image, 1), 2, 0, 0, "over an edge");
  for (int& label : image.labels)
  {
    label = 1 - label;
  }
  Expect(Of(image, 1), 1, 0, 1, "holes that meet in an edge are one cavity");
}

TEST(BettiNumbers, MaterialsAtTheBorderAndThreads)
{
  const LabelImage image =
    images::Make({ { 9, 9, 9 } }, [](Id i, Id j, Id) { return i < 3 ? 7 : (j < 5 ? 65535 : 0); });
  Expect(Of(image, 7), 1, 0, 0, "slab");
  Expect(Of(image, 65535), 1, 0, 0, "block");
  Expect(Of(image, 0), 1, 0, 1, "around the two");
  EXPECT_EQ(Of(image, 7).voxels, 243);
  EXPECT_EQ(Of(image, 0).voxels, 6 * 4 * 9);
  ThreadMonitor one(1);
  ThreadMonitor three(3);
  const LabelImage noise = images::Noise(12, 4, 3);
  const auto a = CountBettiNumbers(noise, one);
  const auto b = CountBettiNumbers(noise, three);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t m = 0; m < a.size(); ++m)
  {
    Expect(a[m], b[m].b0, b[m].b1, b[m].b2, "threads");
  }
}
