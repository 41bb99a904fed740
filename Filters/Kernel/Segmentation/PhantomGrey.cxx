// SPDX-License-Identifier: BSD-3-Clause
#include "PhantomGrey.h"

#include <cstdint>

namespace lamina
{

namespace
{

constexpr double Pi = 3.14159265358979323846;

/// A well-mixed number for each counter (the finaliser of the SplitMix64 generator). It keeps no state, so
/// that any thread can make any voxel's noise.
std::uint64_t Mix(std::uint64_t x)
{
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

/// A number of the standard normal distribution for each counter.
double NormalNoise(std::uint64_t seed, std::uint64_t counter)
{
  const std::uint64_t stream = Mix(seed ^ 0x5851f42d4c957f2dull);
  const double scale = 1.0 / 9007199254740992.0; // 2^-53
  const double u = (static_cast<double>(Mix(stream + 2 * counter) >> 11) + 0.5) * scale;
  const double v = static_cast<double>(Mix(stream + 2 * counter + 1) >> 11) * scale;
  return std::sqrt(-2 * std::log(u)) * std::cos(2 * Pi * v);
}

/// The share of a voxel on the negative side of a surface. The label has the last word on which side its
/// centre is.
double Share(signed char hundredths, bool inside)
{
  const double share = std::min(1.0, std::max(0.0, 0.5 - 0.01 * hundredths));
  return inside ? std::max(share, 0.55) : std::min(share, 0.45);
}

/// A smooth field between -1 and 1.
double BiasField(double x, double y, double z)
{
  return (std::cos(Pi * (x + 0.2)) + std::cos(Pi * (y - 0.3)) + std::cos(Pi * (z + 0.1))) / 3;
}

/// A Gaussian's weights for distances of 0, 1, ... voxels; the weights of the whole kernel add up to 1.
std::vector<double> GaussianWeights(double fullWidthAtHalfMaximum)
{
  const double sigma = fullWidthAtHalfMaximum / 2.3548200450309493;
  std::vector<double> weights{ 1 };
  double sum = 1;
  for (int i = 1; sigma > 0 && i <= std::ceil(3.5 * sigma); ++i)
  {
    weights.push_back(std::exp(-0.5 * i * i / (sigma * sigma)));
    sum += 2 * weights.back();
  }
  for (double& weight : weights)
  {
    weight /= sum;
  }
  return weights;
}

/// Convolve one line of voxels; beyond its ends the last value goes on.
void BlurLine(double* line, Id length, Id stride, const std::vector<double>& weights,
              std::vector<double>& buffer)
{
  buffer.resize(length);
  for (Id i = 0; i < length; ++i)
  {
    buffer[i] = line[i * stride];
  }
  for (Id i = 0; i < length; ++i)
  {
    double sum = weights[0] * buffer[i];
    for (Id w = 1; w < static_cast<Id>(weights.size()); ++w)
    {
      sum += weights[w] * (buffer[std::max<Id>(i - w, 0)] + buffer[std::min(i + w, length - 1)]);
    }
    line[i * stride] = sum;
  }
}

void Blur(GreyImage& grey, double width, Monitor& monitor)
{
  const std::vector<double> weights = GaussianWeights(width);
  const auto& size = grey.grid.size;
  const Id stride[3] = { 1, size[0], size[0] * size[1] };
  for (int axis = 0; axis < 3 && weights.size() > 1; ++axis)
  {
    const int u = axis == 0 ? 1 : 0;
    const int v = axis == 2 ? 1 : 2;
    monitor.For(size[u] * size[v], 64,
                [&](Id begin, Id end)
                {
                  std::vector<double> buffer;
                  for (Id l = begin; l < end; ++l)
                  {
                    const Id start = l % size[u] * stride[u] + l / size[u] * stride[v];
                    BlurLine(grey.values.data() + start, size[axis], stride[axis], weights, buffer);
                  }
                });
  }
}

} // namespace

bool MakeGreyValues(const LabelImage& labels, const PartialVolume& partial,
                    const HeartPhantomOptions& options, GreyImage& grey, Monitor& monitor)
{
  grey.grid = labels.grid;
  grey.values.resize(labels.labels.size());
  const auto& size = grey.grid.size;
  const Id slice = size[0] * size[1];
  monitor.For(size[2], 1,
              [&](Id begin, Id end)
              {
                for (Id v = begin * slice; v < end * slice; ++v)
                {
                  const double heart = Share(partial.heart[v], labels.labels[v] > 0);
                  const double blood = Share(partial.blood[v], labels.labels[v] == 2);
                  const double wall = options.background + heart * (options.tissue - options.background);
                  grey.values[v] = wall + blood * (options.blood - wall);
                }
              });
  Blur(grey, options.blur, monitor);
  monitor.For(size[2], 1,
              [&](Id begin, Id end)
              {
                for (Id v = begin * slice; v < end * slice; ++v)
                {
                  const double x = double(v % size[0]) / size[0];
                  const double y = double(v / size[0] % size[1]) / size[1];
                  const double z = double(v / slice) / size[2];
                  const double bright = grey.values[v] * (1 + options.bias * BiasField(x, y, z));
                  const double value =
                    bright + options.noise * NormalNoise(options.seed, static_cast<std::uint64_t>(v));
                  grey.values[v] = std::round(std::min(255.0, std::max(0.0, value)));
                }
              });
  return !monitor.Cancelled();
}

} // namespace lamina
