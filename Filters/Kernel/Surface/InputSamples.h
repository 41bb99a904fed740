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

/// A sample for each point of the input and each sheet it lies on, and three within each
/// edge. They tell how far the input lies from the edited surface, as the tree tells how far that lies from
/// the input.
class InputSamples
{
public:
  explicit InputSamples(const InputSurface& input);

  /// The first sample on a triangle, and the one after a sample; -1 at the end.
  int First(Id triangle) const { return this->Firsts[static_cast<std::size_t>(triangle)]; }
  int Next(int sample) const { return this->Nexts[static_cast<std::size_t>(sample)]; }
  const Vec3& Place(int sample) const { return this->Places[static_cast<std::size_t>(sample)].point; }
  double Tolerance(int sample) const { return this->Places[static_cast<std::size_t>(sample)].tolerance; }

  void Grow(std::size_t triangles) { this->Firsts.resize(triangles, -1); }
  void Clear(Id triangle) { this->Firsts[static_cast<std::size_t>(triangle)] = -1; }
  void Put(int sample, Id triangle)
  {
    this->Nexts[static_cast<std::size_t>(sample)] = this->First(triangle);
    this->Firsts[static_cast<std::size_t>(triangle)] = sample;
  }

  /// Triangle i is from now on what order[i] was; the others have no samples.
  void Renumber(const std::vector<Id>& order);

private:
  struct Sample
  {
    Vec3 point;
    double tolerance;
  };
  void Add(const Vec3& point, double tolerance, Id triangle);

  std::vector<Sample> Places;
  std::vector<int> Nexts;
  std::vector<int> Firsts; ///< one a triangle
};

} // namespace lamina
