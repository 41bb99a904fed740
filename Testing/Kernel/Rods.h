// SPDX-License-Identifier: BSD-3-Clause
// Images with masks that a user might draw, and what propagation makes of them.
#pragma once

#include "Segmentation/MaskPropagation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace lamina
{
namespace rods
{

/// An image, and the regions that a user would draw on all of its slices.
struct Case
{
  GreyImage grey;
  LabelImage truth;
};

inline Case Make(const std::array<Id, 3>& size, const std::function<int(double, double, double)>& label,
                 double noise = 6)
{
  Case made;
  made.grey.grid.size = size;
  made.truth.grid.size = size;
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0, noise);
  for (Id k = 0; k < size[2]; ++k)
  {
    for (Id j = 0; j < size[1]; ++j)
    {
      for (Id i = 0; i < size[0]; ++i)
      {
        const int region = label(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
        made.truth.labels.push_back(region);
        made.grey.values.push_back(40 + 60 * region + normal(random));
      }
    }
  }
  return made;
}

/// A rod that leans by three quarters of a pixel a slice and swells.
inline Case Rod()
{
  return Make({ { 60, 40, 37 } },
              [](double x, double y, double z) {
                return std::hypot(x - 14 - 0.75 * z, y - 20 + 4 * std::sin(0.15 * z)) < 8 + 0.08 * z ? 1 : 0;
              });
}

/// The mask on every `step`-th slice across `axis` from `first` on.
inline LabelImage Drawn(const LabelImage& truth, Id step, Id first = 0, std::size_t axis = 2)
{
  LabelImage mask = truth;
  const auto& n = truth.grid.size;
  for (Id v = 0; v < truth.grid.Count(); ++v)
  {
    const std::array<Id, 3> index{ { v % n[0], v / n[0] % n[1], v / (n[0] * n[1]) } };
    if ((index[axis] + step - first) % step != 0)
    {
      mask.labels[static_cast<std::size_t>(v)] = 0;
    }
  }
  return mask;
}

struct Outcome
{
  LabelImage full;
  MaskPropagationReport report;
  std::string error;

  Id Voxels(Id k) const
  {
    const Id area = this->full.grid.size[0] * this->full.grid.size[1];
    const auto begin = this->full.labels.begin() + static_cast<std::ptrdiff_t>(k * area);
    return area - std::count(begin, begin + static_cast<std::ptrdiff_t>(area), 0);
  }
};

inline Outcome Propagated(const GreyImage& grey, const LabelImage& mask,
                          const MaskPropagationOptions& options = {}, int threads = 2)
{
  Outcome outcome;
  ThreadMonitor monitor(threads);
  auto report = PropagateMask(grey, mask, outcome.full, options, monitor);
  if (report)
  {
    outcome.report = *report;
  }
  else
  {
    outcome.error = report.GetError().message;
  }
  return outcome;
}

inline double Dice(const LabelImage& a, const LabelImage& b)
{
  double common = 0;
  double both = 0;
  for (std::size_t v = 0; v < a.labels.size(); ++v)
  {
    common += a.labels[v] != 0 && a.labels[v] == b.labels[v] ? 1 : 0;
    both += (a.labels[v] != 0 ? 1 : 0) + (b.labels[v] != 0 ? 1 : 0);
  }
  return 2 * common / both;
}

inline MaskPropagationOptions By(int method)
{
  MaskPropagationOptions options;
  options.method = method;
  return options;
}

inline void ExpectFailure(const Outcome& outcome, const std::string& part)
{
  EXPECT_NE(outcome.error.find(part), std::string::npos) << part << ": " << outcome.error;
}

} // namespace rods
} // namespace lamina
