// SPDX-License-Identifier: BSD-3-Clause
// Grey images made by hand, and what segmentation makes of them.
#pragma once

#include "Segmentation/Segment.h"

#include <algorithm>
#include <random>
#include <string>

namespace lamina::greys
{

constexpr double Other = 20;
constexpr double Muscle = 85;
constexpr double Between = 130;
constexpr double Lumen = 190;

/// A cube of `size` voxels of `value`.
inline GreyImage Cube(Id size, double value)
{
  GreyImage image;
  image.grid.size = { size, size, size };
  image.values.assign(image.grid.Count(), value);
  return image;
}

/// Set the box [from, to] (inclusive) to a value.
inline void Fill(GreyImage& image, std::array<Id, 3> from, std::array<Id, 3> to, double value)
{
  for (Id k = from[2]; k <= to[2]; ++k)
  {
    for (Id j = from[1]; j <= to[1]; ++j)
    {
      for (Id i = from[0]; i <= to[0]; ++i)
      {
        image.values[image.grid.Index(i, j, k)] = value;
      }
    }
  }
}

/// Background, in it a cube of muscle from 3 to 16, in that a cube of blood from 7 to 12.
inline GreyImage Heart()
{
  GreyImage image = Cube(20, Other);
  Fill(image, { 3, 3, 3 }, { 16, 16, 16 }, Muscle);
  Fill(image, { 7, 7, 7 }, { 12, 12, 12 }, Lumen);
  return image;
}

/// Add normal noise, the same for each seed.
inline void AddNoise(GreyImage& image, double deviation, unsigned seed = 3)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, 1);
  for (double& value : image.values)
  {
    value += deviation * noise(random);
  }
}

/// Thirds of 20, 85 and 190 along i with normal noise, times `scale` and moved by `offset`.
inline GreyImage Thirds(double deviation, double scale = 1, double offset = 0)
{
  GreyImage image = Cube(30, Other);
  Fill(image, { 10, 0, 0 }, { 19, 29, 29 }, Muscle);
  Fill(image, { 20, 0, 0 }, { 29, 29, 29 }, Lumen);
  AddNoise(image, deviation);
  for (double& value : image.values)
  {
    value = offset + scale * value;
  }
  return image;
}

struct Outcome
{
  LabelImage labels;
  std::vector<unsigned char> flags;
  SegmentReport report;
  std::string error;

  int At(Id i, Id j, Id k) const { return this->labels.labels[this->labels.grid.Index(i, j, k)]; }
  Id Voxels(int id) const { return std::count(this->labels.labels.begin(), this->labels.labels.end(), id); }
  /// What a material is like in the end.
  BettiNumbers Of(int material) const
  {
    for (const BettiNumbers& betti : this->report.after)
    {
      if (betti.material == material)
      {
        return betti;
      }
    }
    return {};
  }
  Id Rule(const std::string& name, int material) const
  {
    for (const SegmentRule& rule : this->report.rules)
    {
      if (rule.name == name && rule.material == material)
      {
        return rule.voxels;
      }
    }
    return -1;
  }
};

inline Outcome Segmented(const GreyImage& image, const SegmentOptions& options = {}, int threads = 1)
{
  Outcome outcome;
  ThreadMonitor monitor(threads);
  const auto report = Segment(image, outcome.labels, outcome.flags, options, monitor);
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

inline bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

} // namespace lamina::greys
