// SPDX-License-Identifier: BSD-3-Clause
#include "SliceRegistration.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace lamina
{

namespace
{

constexpr Id LeastSide = 24;        ///< slices shorter than this are not halved
constexpr float HalvingBlur = 0.8F; ///< against aliasing
constexpr float LevelBlur = 0.7F;   ///< of the slices before they are compared
constexpr float Window = 2;         ///< standard deviation of the neighbourhood that is compared
constexpr int Steps = 4;            ///< Gauss-Newton steps a level
constexpr float LongestStep = 1;    ///< pixels: beyond, the linear model is worth little
constexpr float LeastMass = 1e-3F;  ///< share of a window below which it is nothing
constexpr float Damping = 0.02F;    ///< of the steps, relative to structure and to noise
constexpr float Doubt = 0.1F;       ///< structure, in units of the noise's variance, that counts half

/// One level: both slices, their pixels' shape, and what was halved to come here from the finer level.
struct Level
{
  SliceImage fixed;
  SliceImage moving;
  PixelShape shape; ///< edges in units of the finest level's shorter edge
  bool halvedX = false;
  bool halvedY = false;

  float Unit() const { return std::min(this->shape.x, this->shape.y); }
  PixelShape Relative() const { return { this->shape.x / this->Unit(), this->shape.y / this->Unit() }; }
};

SliceImage Halve(const SliceImage& image, bool alongX, bool alongY, const PixelShape& shape)
{
  const SliceImage blurred = Blur(image, HalvingBlur, shape);
  const Id stepX = alongX ? 2 : 1;
  const Id stepY = alongY ? 2 : 1;
  SliceImage half((image.width + stepX - 1) / stepX, (image.height + stepY - 1) / stepY);
  for (Id y = 0; y < half.height; ++y)
  {
    for (Id x = 0; x < half.width; ++x)
    {
      half.At(x, y) = blurred.At(x * stepX, y * stepY);
    }
  }
  return half;
}

/// From fine to coarse. Of oblong pixels only the shorter edge is doubled, until they are about square.
std::vector<Level> MakePyramid(const SliceImage& fixed, const SliceImage& moving, const PixelShape& shape,
                               int levels)
{
  std::vector<Level> pyramid{ { fixed, moving, shape, false, false } };
  while (static_cast<int>(pyramid.size()) < levels)
  {
    const Level& fine = pyramid.back();
    const PixelShape relative = fine.Relative();
    const bool alongX = fine.fixed.width >= LeastSide && relative.x < 1.5F;
    const bool alongY = fine.fixed.height >= LeastSide && relative.y < 1.5F;
    if (!alongX && !alongY)
    {
      break;
    }
    const PixelShape coarse{ fine.shape.x * (alongX ? 2 : 1), fine.shape.y * (alongY ? 2 : 1) };
    Level next{ Halve(fine.fixed, alongX, alongY, relative), Halve(fine.moving, alongX, alongY, relative),
                coarse, alongX, alongY };
    pyramid.push_back(std::move(next));
  }
  return pyramid;
}

/// The field of a coarser level on a finer one, which was halved along the axes given.
SliceImage Refined(const SliceImage& coarse, const SliceImage& like, bool alongX, bool alongY, bool scale)
{
  SliceImage fine(like.width, like.height);
  for (Id y = 0; y < fine.height; ++y)
  {
    for (Id x = 0; x < fine.width; ++x)
    {
      fine.At(x, y) = (scale ? 2 : 1) * Sample(coarse, static_cast<float>(x) * (alongX ? 0.5F : 1),
                                               static_cast<float>(y) * (alongY ? 0.5F : 1));
    }
  }
  return fine;
}

/// Sums over each pixel's window that a Gauss-Newton step needs: of the squares and products of the gradient
/// (gx, gy) and the difference d, less those of their means.
struct Moments
{
  SliceImage xx;
  SliceImage xy;
  SliceImage yy;
  SliceImage xd;
  SliceImage yd;
};

/// A quantity, and its sum over each pixel's window.
struct Summed
{
  const SliceImage& value;
  SliceImage sum;
};

/// `mass`: the share of each pixel's window that counts.
SliceImage Covariance(const Summed& a, const Summed& b, const SliceImage& mass, const PixelShape& shape)
{
  SliceImage product(mass.width, mass.height);
  std::transform(a.value.values.begin(), a.value.values.end(), b.value.values.begin(), product.values.begin(),
                 std::multiplies<float>());
  product = Blur(product, Window, shape);
  for (std::size_t p = 0; p < product.values.size(); ++p)
  {
    product.values[p] -= a.sum.values[p] * b.sum.values[p] / std::max(mass.values[p], LeastMass);
  }
  return product;
}

/// `warped` is the moving slice by `field`; pixels that come from outside it do not count.
Moments MeasureMoments(const SliceImage& fixed, const SliceImage& warped, const SliceField& field,
                       const PixelShape& shape)
{
  const Id w = fixed.width;
  const Id h = fixed.height;
  SliceImage gx(w, h);
  SliceImage gy(w, h);
  SliceImage d(w, h);
  SliceImage both(w, h);
  for (std::size_t p = 0; p < d.values.size(); ++p)
  {
    d.values[p] = fixed.values[p] - warped.values[p];
    both.values[p] = 0.5F * (fixed.values[p] + warped.values[p]);
  }
  for (Id y = 0; y < h; ++y)
  {
    const Id below = std::max<Id>(0, y - 1);
    const Id above = std::min(h - 1, y + 1);
    for (Id x = 0; x < w; ++x)
    {
      const Id left = std::max<Id>(0, x - 1);
      const Id right = std::min(w - 1, x + 1);
      gx.At(x, y) = (both.At(right, y) - both.At(left, y)) /
                    (shape.x * static_cast<float>(std::max<Id>(1, right - left)));
      gy.At(x, y) = (both.At(x, above) - both.At(x, below)) /
                    (shape.y * static_cast<float>(std::max<Id>(1, above - below)));
    }
  }
  SliceImage mass(w, h, 1);
  for (Id p = 0; p < d.Count(); ++p)
  {
    const std::size_t n = static_cast<std::size_t>(p);
    const float x = static_cast<float>(p % w) + field.dx.values[n];
    const float y = static_cast<float>(p / w) + field.dy.values[n];
    if (x < 0 || y < 0 || x > static_cast<float>(w - 1) || y > static_cast<float>(h - 1))
    {
      gx.values[n] = gy.values[n] = d.values[n] = mass.values[n] = 0;
    }
  }
  mass = Blur(mass, Window, shape);
  const Summed sx{ gx, Blur(gx, Window, shape) };
  const Summed sy{ gy, Blur(gy, Window, shape) };
  const Summed sd{ d, Blur(d, Window, shape) };
  return { Covariance(sx, sx, mass, shape), Covariance(sx, sy, mass, shape), Covariance(sy, sy, mass, shape),
           Covariance(sx, sd, mass, shape), Covariance(sy, sd, mass, shape) };
}

/// Even the field out, places of structure first: the mean over a Gaussian reach, weighted by trust.
void Even(SliceField& field, const SliceImage& trust, float reach, const PixelShape& shape)
{
  const SliceImage sum = Blur(trust, reach, shape);
  for (SliceImage* part : { &field.dx, &field.dy })
  {
    std::transform(part->values.begin(), part->values.end(), trust.values.begin(), part->values.begin(),
                   std::multiplies<float>());
    *part = Blur(*part, reach, shape);
    std::transform(part->values.begin(), part->values.end(), sum.values.begin(), part->values.begin(),
                   std::divides<float>());
  }
}

/// One Gauss-Newton step of every pixel, then the evening out.
void Step(const Level& level, const SliceImage& fixed, const SliceImage& moving,
          const SliceRegistrationOptions& options, SliceField& field)
{
  const PixelShape shape = level.Relative();
  const Moments m = MeasureMoments(fixed, Warp(moving, field), field, shape);
  const float variance = static_cast<float>(std::max(1e-6, options.noise * options.noise));
  const float range = static_cast<float>(options.searchRange) / level.Unit();
  SliceImage trust(fixed.width, fixed.height);
  for (std::size_t p = 0; p < trust.values.size(); ++p)
  {
    const float trace = std::max(0.0F, m.xx.values[p] + m.yy.values[p]);
    const float damp = Damping * (variance + trace);
    const float a = m.xx.values[p] + damp;
    const float c = m.yy.values[p] + damp;
    const float b = m.xy.values[p];
    const float det = std::max(a * c - b * b, damp * damp);
    float sx = (c * m.xd.values[p] - b * m.yd.values[p]) / det;
    float sy = (a * m.yd.values[p] - b * m.xd.values[p]) / det;
    const float shorten = std::min(1.0F, LongestStep / std::max(std::hypot(sx, sy), 1e-9F));
    sx = field.dx.values[p] * shape.x + sx * shorten;
    sy = field.dy.values[p] * shape.y + sy * shorten;
    const float within = std::min(1.0F, range / std::max(std::hypot(sx, sy), 1e-9F));
    field.dx.values[p] = sx * within / shape.x;
    field.dy.values[p] = sy * within / shape.y;
    trust.values[p] = trace / (trace + Doubt * variance) + 1e-3F;
  }
  Even(field, trust, static_cast<float>(options.smoothness), shape);
}

} // namespace

SliceField RegisterSlices(const SliceImage& fixed, const SliceImage& moving, const PixelShape& shape,
                          const SliceRegistrationOptions& options)
{
  const std::vector<Level> pyramid = MakePyramid(fixed, moving, shape, options.levels);
  SliceField field = NoDisplacement(pyramid.back().fixed.width, pyramid.back().fixed.height);
  for (std::size_t l = pyramid.size(); l-- > 0;)
  {
    const Level& level = pyramid[l];
    if (l + 1 < pyramid.size())
    {
      const Level& coarse = pyramid[l + 1];
      field.dx = Refined(field.dx, level.fixed, coarse.halvedX, coarse.halvedY, coarse.halvedX);
      field.dy = Refined(field.dy, level.fixed, coarse.halvedX, coarse.halvedY, coarse.halvedY);
    }
    const SliceImage f = Blur(level.fixed, LevelBlur, level.Relative());
    const SliceImage m = Blur(level.moving, LevelBlur, level.Relative());
    for (int step = 0; step < Steps; ++step)
    {
      Step(level, f, m, options, field);
    }
  }
  return field;
}

} // namespace lamina
