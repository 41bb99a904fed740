// SPDX-License-Identifier: BSD-3-Clause
#include "SliceImage.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamina
{

namespace
{

std::vector<float> GaussianWeights(float sigma)
{
  const int radius = std::max(1, static_cast<int>(std::ceil(3 * sigma)));
  std::vector<float> weights(static_cast<std::size_t>(radius) + 1);
  float sum = 0;
  for (int i = 0; i <= radius; ++i)
  {
    weights[static_cast<std::size_t>(i)] = std::exp(-0.5F * static_cast<float>(i * i) / (sigma * sigma));
    sum += (i == 0 ? 1 : 2) * weights[static_cast<std::size_t>(i)];
  }
  for (float& weight : weights)
  {
    weight /= sum;
  }
  return weights;
}

/// Along x: each row is continued on both sides, so that the inner loop has no borders.
void BlurRows(SliceImage& image, const std::vector<float>& weights)
{
  const Id radius = static_cast<Id>(weights.size()) - 1;
  const Id w = image.width;
  std::vector<float> row(static_cast<std::size_t>(w + 2 * radius));
  for (Id y = 0; y < image.height; ++y)
  {
    float* line = &image.At(0, y);
    std::fill(row.begin(), row.begin() + radius, line[0]);
    std::copy(line, line + w, row.begin() + radius);
    std::fill(row.end() - radius, row.end(), line[w - 1]);
    const float* centre = row.data() + radius;
    std::transform(centre, centre + w, line, [&](float v) { return weights[0] * v; });
    for (Id r = 1; r <= radius; ++r)
    {
      const float weight = weights[static_cast<std::size_t>(r)];
      for (Id x = 0; x < w; ++x)
      {
        line[x] += weight * (centre[x - r] + centre[x + r]);
      }
    }
  }
}

void BlurColumns(SliceImage& image, const std::vector<float>& weights)
{
  const Id radius = static_cast<Id>(weights.size()) - 1;
  const SliceImage source = image;
  for (Id y = 0; y < image.height; ++y)
  {
    float* line = &image.At(0, y);
    std::transform(line, line + image.width, line, [&](float v) { return weights[0] * v; });
    for (Id r = 1; r <= radius; ++r)
    {
      const float weight = weights[static_cast<std::size_t>(r)];
      const float* above = &source.values[static_cast<std::size_t>(std::max<Id>(0, y - r) * image.width)];
      const float* below =
        &source.values[static_cast<std::size_t>(std::min(image.height - 1, y + r) * image.width)];
      for (Id x = 0; x < image.width; ++x)
      {
        line[x] += weight * (above[x] + below[x]);
      }
    }
  }
}

/// The lower envelope of parabolas along one line: squared distances to the nearest place of cost, for places
/// `step` apart (Felzenszwalb and Huttenlocher, Theory of Computing 8, 2012).
void LowerEnvelope(std::vector<double>& cost, double step, std::vector<std::size_t>& vertex,
                   std::vector<double>& from, std::vector<double>& result)
{
  const std::size_t count = cost.size();
  const auto square = [&](std::size_t i) { return step * step * static_cast<double>(i * i); };
  std::size_t last = 0;
  vertex[0] = 0;
  from[0] = -std::numeric_limits<double>::infinity();
  for (std::size_t q = 1; q < count; ++q)
  {
    const auto meet = [&](std::size_t p)
    { return (cost[q] + square(q) - cost[p] - square(p)) / (2 * step * step * static_cast<double>(q - p)); };
    double place = meet(vertex[last]);
    while (place <= from[last])
    {
      --last;
      place = meet(vertex[last]);
    }
    ++last;
    vertex[last] = q;
    from[last] = place;
  }
  std::size_t k = 0;
  for (std::size_t q = 0; q < count; ++q)
  {
    while (k < last && from[k + 1] < static_cast<double>(q))
    {
      ++k;
    }
    const double away = step * (static_cast<double>(q) - static_cast<double>(vertex[k]));
    result[q] = away * away + cost[vertex[k]];
  }
  cost = result;
}

/// Distance of every pixel to the nearest one whose `inside` is `target`.
SliceImage DistanceTo(bool target, const std::vector<unsigned char>& inside, Id width, Id height,
                      const PixelShape& shape)
{
  constexpr double far = 1e12;
  std::vector<double> squares(inside.size());
  std::transform(inside.begin(), inside.end(), squares.begin(),
                 [&](unsigned char v) { return (v != 0) == target ? 0.0 : far; });
  const auto sweep = [&](Id lines, Id length, Id lineStep, Id step, double edge)
  {
    const std::size_t n = static_cast<std::size_t>(length);
    std::vector<double> cost(n);
    std::vector<double> result(n);
    std::vector<double> from(n);
    std::vector<std::size_t> vertex(n);
    for (Id line = 0; line < lines; ++line)
    {
      for (std::size_t i = 0; i < n; ++i)
      {
        cost[i] = squares[static_cast<std::size_t>(line * lineStep) + i * static_cast<std::size_t>(step)];
      }
      LowerEnvelope(cost, edge, vertex, from, result);
      for (std::size_t i = 0; i < n; ++i)
      {
        squares[static_cast<std::size_t>(line * lineStep) + i * static_cast<std::size_t>(step)] = cost[i];
      }
    }
  };
  sweep(width, height, 1, width, shape.y);
  sweep(height, width, width, 1, shape.x);
  SliceImage distance(width, height);
  std::transform(squares.begin(), squares.end(), distance.values.begin(),
                 [](double s) { return static_cast<float>(std::sqrt(s)); });
  return distance;
}

} // namespace

PixelShape MakePixelShape(double spacingX, double spacingY)
{
  const double least = std::min(spacingX, spacingY);
  return { static_cast<float>(spacingX / least), static_cast<float>(spacingY / least) };
}

float Sample(const SliceImage& image, float x, float y)
{
  const float cx = std::min(std::max(x, 0.0F), static_cast<float>(image.width - 1));
  const float cy = std::min(std::max(y, 0.0F), static_cast<float>(image.height - 1));
  const Id i = std::min(static_cast<Id>(cx), std::max<Id>(0, image.width - 2));
  const Id j = std::min(static_cast<Id>(cy), std::max<Id>(0, image.height - 2));
  const Id right = image.width > 1 ? 1 : 0;
  const Id up = image.height > 1 ? image.width : 0;
  const float a = cx - static_cast<float>(i);
  const float b = cy - static_cast<float>(j);
  const float* v = &image.values[static_cast<std::size_t>(i + image.width * j)];
  return (1 - b) * ((1 - a) * v[0] + a * v[right]) + b * ((1 - a) * v[up] + a * v[up + right]);
}

SliceImage Warp(const SliceImage& image, const SliceField& field)
{
  SliceImage result(field.dx.width, field.dx.height);
  for (Id y = 0; y < result.height; ++y)
  {
    for (Id x = 0; x < result.width; ++x)
    {
      result.At(x, y) =
        Sample(image, static_cast<float>(x) + field.dx.At(x, y), static_cast<float>(y) + field.dy.At(x, y));
    }
  }
  return result;
}

std::vector<SliceImage> SliceWarper::Pull(const std::vector<const SliceImage*>& images,
                                          const SliceField& field) const
{
  std::vector<SliceImage> pulled;
  for (const SliceImage* image : images)
  {
    pulled.push_back(Warp(*image, field));
  }
  return pulled;
}

SliceField Compose(const SliceField& first, const SliceField& next, const SliceWarper& warper)
{
  std::vector<SliceImage> there = warper.Pull({ &next.dx, &next.dy }, first);
  SliceField sum{ std::move(there[0]), std::move(there[1]) };
  for (std::size_t p = 0; p < sum.dx.values.size(); ++p)
  {
    sum.dx.values[p] += first.dx.values[p];
    sum.dy.values[p] += first.dy.values[p];
  }
  return sum;
}

SliceField NoDisplacement(Id width, Id height)
{
  return { SliceImage(width, height), SliceImage(width, height) };
}

SliceImage Blur(const SliceImage& image, float sigma, const PixelShape& shape)
{
  SliceImage result = image;
  // Below a third of a pixel the neighbours' weight is under 1 %.
  if (sigma / shape.x > 0.33F)
  {
    BlurRows(result, GaussianWeights(sigma / shape.x));
  }
  if (sigma / shape.y > 0.33F)
  {
    BlurColumns(result, GaussianWeights(sigma / shape.y));
  }
  return result;
}

SliceImage SignedDistance(const std::vector<unsigned char>& inside, Id width, Id height,
                          const PixelShape& shape)
{
  const bool any = std::any_of(inside.begin(), inside.end(), [](unsigned char v) { return v != 0; });
  const bool all = std::all_of(inside.begin(), inside.end(), [](unsigned char v) { return v != 0; });
  if (!any || all)
  {
    const float size = shape.x * static_cast<float>(width) + shape.y * static_cast<float>(height);
    return SliceImage(width, height, any ? size : -size);
  }
  SliceImage distance = DistanceTo(false, inside, width, height, shape);
  const SliceImage outside = DistanceTo(true, inside, width, height, shape);
  for (std::size_t p = 0; p < inside.size(); ++p)
  {
    distance.values[p] = inside[p] ? distance.values[p] - 0.5F : 0.5F - outside.values[p];
  }
  return distance;
}

} // namespace lamina
