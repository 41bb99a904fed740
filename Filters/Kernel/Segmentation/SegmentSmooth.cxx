// SPDX-License-Identifier: BSD-3-Clause
// Edge-preserving smoothing before the thresholds: a bilateral filter (C. Tomasi, R. Manduchi, Bilateral
// filtering for gray and color images, ICCV 1998) with Tukey's biweight for the grey values, which is nothing
// across an edge (M. J. Black, G. Sapiro, D. H. Marimont, D. Heeger, Robust anisotropic diffusion, IEEE TIP 7
// (1998)).
#include "SegmentRules.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamina
{
namespace segment
{

namespace
{

/// Stands for what is no finite number: too far from anything to be mixed with it. Differences are still
/// finite.
constexpr float Far = std::numeric_limits<float>::max() / 4;

std::vector<float> ReadFloats(const GreyView& grey, Monitor& monitor)
{
  std::vector<float> values(grey.Count());
  const Id length = grey.grid.size[0];
  monitor.For(grey.grid.size[1] * grey.grid.size[2], 64,
              [&](Id begin, Id end)
              {
                std::vector<double> row(length);
                for (Id r = begin; r < end; ++r)
                {
                  grey.Read(r * length, (r + 1) * length, row.data());
                  for (Id i = 0; i < length; ++i)
                  {
                    const float value = static_cast<float>(row[i]);
                    values[r * length + i] = std::abs(value) < Far ? value : (value > 0 ? Far : -Far);
                  }
                }
              });
  return values;
}

/// One neighbour of a voxel: where, and what it counts by its distance.
struct Neighbour
{
  Id i = 0;
  Id j = 0;
  Id k = 0;
  float weight = 0;
};

/// The 26 neighbours, weighed by a Gaussian of 0.8 shortest voxel edges.
std::vector<Neighbour> Neighbours(const Vec3& spacing)
{
  const double width = 0.8 * std::min({ spacing.x, spacing.y, spacing.z });
  std::vector<Neighbour> all;
  for (Id n = 0; n < 27; ++n)
  {
    const Id i = n % 3 - 1;
    const Id j = n / 3 % 3 - 1;
    const Id k = n / 9 - 1;
    const Vec3 step{ i * spacing.x, j * spacing.y, k * spacing.z };
    const double weight = std::exp(-0.5 * Norm2(step) / (width * width));
    if (n != 13 && weight > 1e-6)
    {
      all.push_back({ i, j, k, static_cast<float>(weight) });
    }
  }
  return all;
}

/// Smooths rows of an image, each from the rows around it.
class RowSmoother
{
public:
  RowSmoother(const GridGeometry& grid, const std::vector<float>& values, double reach)
    : Grid(grid)
    , Values(values)
    , Around(Neighbours(grid.spacing))
    , Sharpness(static_cast<float>(1 / (reach * reach)))
    , Weights(grid.size[0])
    , Shifts(grid.size[0])
  {
  }
  void Smooth(Id j, Id k, float* to)
  {
    const Id length = this->Grid.size[0];
    const float* own = this->Values.data() + this->Grid.Index(0, j, k);
    std::fill(this->Weights.begin(), this->Weights.end(), 1.0f);
    std::fill(this->Shifts.begin(), this->Shifts.end(), 0.0f);
    for (const Neighbour& n : this->Around)
    {
      if (j + n.j >= 0 && j + n.j < this->Grid.size[1] && k + n.k >= 0 && k + n.k < this->Grid.size[2])
      {
        const float* other = this->Values.data() + this->Grid.Index(n.i, j + n.j, k + n.k);
        this->Add(own, other, n.weight, std::max<Id>(0, -n.i), std::min(length, length - n.i));
      }
    }
    for (Id i = 0; i < length; ++i)
    {
      to[i] = own[i] + this->Shifts[i] / this->Weights[i];
    }
  }

private:
  /// Free of branches, so that the compiler makes vector instructions of it.
  void Add(const float* own, const float* other, float weight, Id begin, Id end)
  {
    float* weights = this->Weights.data();
    float* shifts = this->Shifts.data();
    const float sharpness = this->Sharpness;
    for (Id i = begin; i < end; ++i)
    {
      const float difference = other[i] - own[i];
      const float alike = 1.0f - difference * difference * sharpness;
      const float kept = alike > 0.0f ? alike : 0.0f;
      const float share = weight * kept * kept;
      weights[i] += share;
      shifts[i] += share * difference;
    }
  }

  const GridGeometry& Grid;
  const std::vector<float>& Values;
  std::vector<Neighbour> Around;
  float Sharpness;
  std::vector<float> Weights;
  std::vector<float> Shifts;
};

void Sweep(const GridGeometry& grid, std::vector<float>& values, double reach, Monitor& monitor)
{
  std::vector<float> smooth(values.size());
  monitor.For(grid.size[1] * grid.size[2], 64,
              [&](Id begin, Id end)
              {
                RowSmoother smoother(grid, values, reach);
                for (Id r = begin; r < end; ++r)
                {
                  smoother.Smooth(r % grid.size[1], r / grid.size[1], smooth.data() + r * grid.size[0]);
                }
              });
  values.swap(smooth);
}

/// Second differences along i, scaled to the deviation of noise, of every so many voxels inside each class.
std::vector<std::vector<float>> SampleNoise(const GreyView& grey, const SegmentOptions& options)
{
  constexpr Id most = 200000;
  const auto& size = grey.grid.size;
  std::vector<std::vector<float>> samples(options.thresholds.size() + 1);
  const Id rows = size[1] * size[2];
  const Id stride = std::max<Id>(1, grey.Count() / (8 * most));
  std::vector<double> row(size[0]);
  for (Id r = 0; r < rows; r += stride)
  {
    grey.Read(r * size[0], (r + 1) * size[0], row.data());
    const auto classOf = [&](double value)
    {
      const auto above = std::upper_bound(options.thresholds.begin(), options.thresholds.end(), value);
      return static_cast<std::size_t>(above - options.thresholds.begin());
    };
    for (Id i = 2; i + 2 < size[0]; ++i)
    {
      const double second = row[i - 1] - 2 * row[i] + row[i + 1];
      const std::size_t own = classOf(row[i]);
      const bool inside = classOf(row[i - 2]) == own && classOf(row[i - 1]) == own &&
                          classOf(row[i + 1]) == own && classOf(row[i + 2]) == own;
      if (inside && std::isfinite(second))
      {
        samples[own].push_back(static_cast<float>(std::abs(second) / std::sqrt(6.0)));
      }
    }
  }
  return samples;
}

} // namespace

double EstimateNoise(const GreyView& grey, const SegmentOptions& options, const SegmentReport& report)
{
  std::vector<std::vector<float>> samples = SampleNoise(grey, options);
  std::size_t all = 0;
  for (const auto& sample : samples)
  {
    all += sample.size();
  }
  double noise = 0;
  for (auto& sample : samples)
  {
    // A class of few voxels tells little.
    if (sample.empty() || sample.size() < all / 100)
    {
      continue;
    }
    const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
    std::nth_element(sample.begin(), middle, sample.end());
    // The median of the absolute value of normal noise is 0.6745 of its deviation.
    const double own = *middle / 0.6745;
    if (own > 1e-6 * (report.greatest - report.least) && (noise == 0 || own < noise))
    {
      noise = own;
    }
  }
  return noise;
}

GreyView Smoothed(const GreyView& grey, const SegmentOptions& options, SegmentReport& report,
                  Monitor& monitor)
{
  report.noise = EstimateNoise(grey, options, report);
  if (options.smoothingSweeps == 0 || !(report.noise > 0))
  {
    return grey;
  }
  // Two voxels of one material differ by 1.4 deviations of the noise as a rule, by 4.5 hardly ever.
  constexpr double reach = 4.5;
  auto values = std::make_shared<std::vector<float>>(ReadFloats(grey, monitor));
  for (int sweep = 0; sweep < options.smoothingSweeps && !monitor.Cancelled(); ++sweep)
  {
    Sweep(grey.grid, *values, reach * report.noise, monitor);
  }
  for (float& value : *values)
  {
    if (!(std::abs(value) < Far))
    {
      value = value > 0 ? std::numeric_limits<float>::infinity() : std::numeric_limits<float>::quiet_NaN();
    }
  }
  return GreyView(grey.grid, values->data(), grey.Count(), values);
}

} // namespace segment
} // namespace lamina
