// SPDX-License-Identifier: BSD-3-Clause
// Pictures of single slices, displacement fields between them, and what one does with both.
#pragma once

#include "../Base/Types.h"

#include <vector>

namespace lamina
{

/// One value a pixel; x runs fastest.
struct SliceImage
{
  Id width = 0;
  Id height = 0;
  std::vector<float> values;

  SliceImage() = default;
  SliceImage(Id w, Id h, float value = 0)
    : width(w)
    , height(h)
    , values(static_cast<std::size_t>(w * h), value)
  {
  }
  Id Count() const { return this->width * this->height; }
  float& At(Id x, Id y) { return this->values[static_cast<std::size_t>(x + this->width * y)]; }
  float At(Id x, Id y) const { return this->values[static_cast<std::size_t>(x + this->width * y)]; }
};

/// Where each pixel of one slice lies on another: pixel (x, y) at (x + dx(x, y), y + dy(x, y)), in pixels.
struct SliceField
{
  SliceImage dx;
  SliceImage dy;
};

/// Pixel edge lengths of a slice, relative to its shorter one: both at least 1, one of them 1.
struct PixelShape
{
  float x = 1;
  float y = 1;
};
PixelShape MakePixelShape(double spacingX, double spacingY);

/// Bilinear; places outside have the value of the nearest place inside.
float Sample(const SliceImage& image, float x, float y);
/// The image pulled back: result(p) = image(p + field(p)).
SliceImage Warp(const SliceImage& image, const SliceField& field);

/// Pulls images back, as Warp() does, by whatever means. It is called by several threads at once.
class SliceWarper
{
public:
  virtual ~SliceWarper() = default;
  /// All of the same size as the field, and at least one.
  virtual std::vector<SliceImage> Pull(const std::vector<const SliceImage*>& images,
                                       const SliceField& field) const;
};

/// First `first`, from where it leads `next`: p -> p + first(p) + next(p + first(p)).
SliceField Compose(const SliceField& first, const SliceField& next, const SliceWarper& warper);
/// The field that leaves everything where it is.
SliceField NoDisplacement(Id width, Id height);
/// Gaussian of standard deviation `sigma`, in pixels of the shorter edge; borders are continued evenly.
SliceImage Blur(const SliceImage& image, float sigma, const PixelShape& shape);

/// Signed distance to the border of the region where `inside` is not 0, positive inside, in pixels of the
/// shorter edge; exact between pixel centres, half a pixel less to the border. The region must be neither
/// empty nor everything; those give a constant of minus or plus the slice's size.
SliceImage SignedDistance(const std::vector<unsigned char>& inside, Id width, Id height,
                          const PixelShape& shape);

} // namespace lamina
