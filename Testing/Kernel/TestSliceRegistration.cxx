// SPDX-License-Identifier: BSD-3-Clause
#include "Segmentation/SliceRegistration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

using namespace lamina;

namespace
{

constexpr Id Width = 96;
constexpr Id Height = 72;
const PixelShape Square{ 1, 1 };

/// A smooth texture without repetition: the same for the same place.
float Texture(double x, double y)
{
  return static_cast<float>(0.5 + 0.2 * std::sin(0.31 * x + 0.7 * std::sin(0.11 * y)) +
                            0.2 * std::cos(0.27 * y + 0.9 * std::sin(0.13 * x)) +
                            0.1 * std::sin(0.17 * x + 0.23 * y));
}

SliceImage Draw(const std::function<float(double, double)>& value, Id width = Width, Id height = Height)
{
  SliceImage image(width, height);
  for (Id y = 0; y < height; ++y)
  {
    for (Id x = 0; x < width; ++x)
    {
      image.At(x, y) = value(static_cast<double>(x), static_cast<double>(y));
    }
  }
  return image;
}

/// Root mean square distance of a field from the truth, `margin` pixels away from the border.
template<typename Truth>
double Error(const SliceField& field, Truth&& truth, Id margin = 8)
{
  double sum = 0;
  double count = 0;
  for (Id y = margin; y < field.dx.height - margin; ++y)
  {
    for (Id x = margin; x < field.dx.width - margin; ++x)
    {
      const std::array<double, 2> t = truth(static_cast<double>(x), static_cast<double>(y));
      const double dx = static_cast<double>(field.dx.At(x, y)) - t[0];
      const double dy = static_cast<double>(field.dy.At(x, y)) - t[1];
      sum += dx * dx + dy * dy;
      ++count;
    }
  }
  return std::sqrt(sum / count);
}

/// The error of the field found between a texture and the same moved by (dx, dy).
double ShiftError(double dx, double dy, const SliceRegistrationOptions& options = {},
                  const PixelShape& shape = Square)
{
  const SliceImage fixed = Draw(Texture);
  const SliceImage moving = Draw([&](double x, double y) { return Texture(x - dx, y - dy); });
  return Error(RegisterSlices(fixed, moving, shape, options),
               [&](double, double) {
                 return std::array<double, 2>{ { dx, dy } };
               });
}

} // namespace

TEST(SliceImage, SignedDistances)
{
  std::vector<unsigned char> inside(20 * 10, 0);
  for (std::size_t p = 0; p < inside.size(); ++p)
  {
    inside[p] = p % 20 < 8 ? 1 : 0;
  }
  const SliceImage half = SignedDistance(inside, 20, 10, Square);
  const SliceImage wide = SignedDistance(inside, 20, 10, { 2, 1 });
  for (Id x = 0; x < 20; ++x)
  {
    EXPECT_FLOAT_EQ(half.At(x, 5), x < 8 ? 7.5F - static_cast<float>(x) : 7.5F - static_cast<float>(x));
    EXPECT_FLOAT_EQ(wide.At(x, 5), x < 8 ? 2 * (8.0F - static_cast<float>(x)) - 0.5F
                                         : 0.5F - 2 * (static_cast<float>(x) - 7.0F));
  }
  std::fill(inside.begin(), inside.end(), 0);
  inside[5 * 20 + 10] = 1;
  const SliceImage point = SignedDistance(inside, 20, 10, Square);
  EXPECT_FLOAT_EQ(point.At(10, 5), 0.5F);
  EXPECT_FLOAT_EQ(point.At(13, 9), 0.5F - 5.0F) << "three along x and four along y";
  inside[5 * 20 + 10] = 0;
  EXPECT_LT(SignedDistance(inside, 20, 10, Square).At(3, 3), -20);
  std::fill(inside.begin(), inside.end(), 1);
  EXPECT_GT(SignedDistance(inside, 20, 10, Square).At(3, 3), 20);
}

TEST(SliceImage, BlurKeepsConstantsAndSums)
{
  const SliceImage flat = Blur(SliceImage(30, 20, 3), 2.5F, { 1, 2 });
  for (const float value : flat.values)
  {
    EXPECT_NEAR(value, 3, 1e-5);
  }
  SliceImage point(31, 31);
  point.At(15, 15) = 1;
  const SliceImage spread = Blur(point, 2, Square);
  double sum = 0;
  double square = 0;
  for (Id p = 0; p < spread.Count(); ++p)
  {
    const double value = static_cast<double>(spread.values[static_cast<std::size_t>(p)]);
    sum += value;
    square += value * static_cast<double>((p % 31 - 15) * (p % 31 - 15));
  }
  EXPECT_NEAR(sum, 1, 1e-5);
  EXPECT_NEAR(std::sqrt(square), 2, 0.05);
}

TEST(SliceImage, ComposedShiftsAdd)
{
  SliceField a = NoDisplacement(20, 20);
  std::fill(a.dx.values.begin(), a.dx.values.end(), 1.5F);
  SliceField b = NoDisplacement(20, 20);
  std::fill(b.dy.values.begin(), b.dy.values.end(), -2.0F);
  const SliceField both = Compose(a, b, SliceWarper());
  EXPECT_FLOAT_EQ(both.dx.At(7, 7), 1.5F);
  EXPECT_FLOAT_EQ(both.dy.At(7, 7), -2.0F);
  const SliceImage ramp = Draw([](double x, double y) { return static_cast<float>(x + 10 * y); }, 20, 20);
  EXPECT_FLOAT_EQ(Warp(ramp, both).At(7, 7), 8.5F + 50.0F);
}

TEST(SliceRegistration, TheSameSliceStays)
{
  EXPECT_LT(ShiftError(0, 0), 1e-4);
}

TEST(SliceRegistration, FindsShifts)
{
  EXPECT_LT(ShiftError(2.3, -1.7), 0.1);
  EXPECT_LT(ShiftError(-0.4, 0.25), 0.05);
}

TEST(SliceRegistration, CoarseLevelsFindLargeShifts)
{
  EXPECT_LT(ShiftError(8, 5), 0.3);
  SliceRegistrationOptions fine;
  fine.levels = 1;
  EXPECT_GT(ShiftError(8, 5, fine), 3) << "a few steps of at most a pixel cannot reach as far";
}

TEST(SliceRegistration, OblongPixels)
{
  EXPECT_LT(ShiftError(2, 1, {}, { 1, 3 }), 0.15);
  EXPECT_LT(ShiftError(1, 3, {}, { 2.5F, 1 }), 0.15);
}

TEST(SliceRegistration, TheSearchRangeHolds)
{
  SliceRegistrationOptions options;
  options.searchRange = 2;
  const SliceImage fixed = Draw(Texture);
  const SliceImage moving = Draw([](double x, double y) { return Texture(x - 6, y); });
  const SliceField field = RegisterSlices(fixed, moving, Square, options);
  for (std::size_t p = 0; p < field.dx.values.size(); ++p)
  {
    ASSERT_LT(std::hypot(field.dx.values[p], field.dy.values[p]), 2.001F);
  }
}

TEST(SliceRegistration, FindsASmoothField)
{
  const auto truth = [](double x, double y) {
    return std::array<double, 2>{ { 2.5 * std::sin(0.06 * y), 2 * std::cos(0.05 * x) } };
  };
  // moving(p + u(p)) is fixed(p): make the fixed slice by looking the texture up where the field leads.
  const SliceImage moving = Draw(Texture);
  const SliceImage fixed = Draw(
    [&](double x, double y)
    {
      const auto u = truth(x, y);
      return Texture(x + u[0], y + u[1]);
    });
  EXPECT_LT(Error(RegisterSlices(fixed, moving, Square, {}), truth), 0.2);
  SliceRegistrationOptions stiff;
  stiff.smoothness = 12;
  EXPECT_GT(Error(RegisterSlices(fixed, moving, Square, stiff), truth), 0.35);
}

TEST(SliceRegistration, BrightnessMovesNothing)
{
  const SliceImage fixed = Draw(Texture);
  const SliceImage brighter =
    Draw([](double x, double y) { return Texture(x - 1.5, y + 1) + 0.3F + 0.002F * static_cast<float>(x); });
  const SliceField field = RegisterSlices(fixed, brighter, Square, {});
  EXPECT_LT(Error(field, [](double, double) { return std::array<double, 2>{ { 1.5, -1 } }; }), 0.3);
}

TEST(SliceRegistration, NothingToSeeMovesNothing)
{
  const SliceImage flat(Width, Height, 0.4F);
  const SliceField field = RegisterSlices(flat, SliceImage(Width, Height, 0.6F), Square, {});
  EXPECT_LT(Error(field, [](double, double) { return std::array<double, 2>{ { 0, 0 } }; }), 1e-3);
}

TEST(SliceRegistration, NoiseBesideStructureDoesNotCount)
{
  // A disc that moves, in noise: the field inside and around the disc is that of the disc.
  std::mt19937 random(3);
  std::normal_distribution<float> noise(0, 0.05F);
  const auto disc = [&](double cx)
  {
    return Draw(
      [&](double x, double y)
      {
        const double d = 16 - std::hypot(x - cx, y - 36);
        return static_cast<float>(std::min(1.0, std::max(0.0, 0.5 + d))) + noise(random);
      });
  };
  SliceRegistrationOptions options;
  options.noise = 0.05;
  const SliceField field = RegisterSlices(disc(45), disc(48), Square, options);
  EXPECT_NEAR(field.dx.At(29, 36), 3, 0.5);
  EXPECT_NEAR(field.dx.At(61, 36), 3, 0.5);
}

TEST(SliceRegistration, TheDriftOfAChainIsSmall)
{
  const auto slice = [](int k)
  { return Draw([&](double x, double y) { return Texture(x - 0.6 * k, y + 0.35 * k); }); };
  SliceField chain = NoDisplacement(Width, Height);
  constexpr int slices = 12;
  for (int k = 1; k <= slices; ++k)
  {
    chain = Compose(RegisterSlices(slice(k), slice(k - 1), Square, {}), chain, SliceWarper());
  }
  // Away from where something came in over the border.
  const auto truth = [](double, double) { return std::array<double, 2>{ { -0.6 * slices, 0.35 * slices } }; };
  EXPECT_LT(Error(chain, truth, 24), 0.6) << "of a way of 8.3 pixels";
}
