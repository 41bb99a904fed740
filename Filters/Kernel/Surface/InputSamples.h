// SPDX-License-Identifier: BSD-3-Clause
// Points of the input surface, each kept with the triangle of the edited surface that is nearest to it.
#pragma once

#include "InputSurface.h"

#include <cstdint>

namespace lamina
{

/// Where a sample would go in an edit.
struct SampleOwner
{
  int sample = 0;
  int added = 0; ///< which of the triangles that the edit adds
};

/// One sample for each point of the input and each sheet it lies on. They tell how far the input lies from
/// the edited surface, as the tree tells how far that lies from the input.
class InputSamples
{
public:
  explicit InputSamples(const InputSurface& input);

  /// The first sample on a triangle, and the one after a sample; -1 at the end.
  int First(Id triangle) const { return this->Firsts[static_cast<std::size_t>(triangle)]; }
  int Next(int sample) const { return this->Nexts[static_cast<std::size_t>(sample)]; }
  /// The point of the input that a sample is.
  Id Point(int sample) const { return this->Points[static_cast<std::size_t>(sample)]; }

  void Grow(std::size_t triangles) { this->Firsts.resize(triangles, -1); }
  void Clear(Id triangle) { this->Firsts[static_cast<std::size_t>(triangle)] = -1; }
  void Put(int sample, Id triangle)
  {
    this->Nexts[static_cast<std::size_t>(sample)] = this->First(triangle);
    this->Firsts[static_cast<std::size_t>(triangle)] = sample;
  }

private:
  std::vector<Id> Points;
  std::vector<int> Nexts;
  std::vector<int> Firsts; ///< one a triangle
};

} // namespace lamina
