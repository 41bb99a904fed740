// SPDX-License-Identifier: BSD-3-Clause
// Which materials of a label image touch, and how many voxels each has.
#pragma once

#include "../Base/Monitor.h"
#include "LabelImage.h"

#include <unordered_set>

namespace lamina
{

/// Pairs of materials that share a block of 2x2x2 voxels; outside the image is background.
class MaterialContacts
{
public:
  MaterialContacts(const LabelImage& image, Monitor& monitor);

  bool Touch(int a, int b) const
  {
    if (a >= 0 && b >= 0 && a < 64 && b < 64)
    {
      return a == b || ((this->Low[static_cast<std::size_t>(a)] >> b) & 1u) != 0;
    }
    return a == b || this->Pairs.count(Key(a, b)) != 0;
  }
  /// The voxels of a material.
  Id Voxels(int material) const
  {
    return static_cast<std::size_t>(material) < this->Counts.size()
             ? this->Counts[static_cast<std::size_t>(material)]
             : 0;
  }

private:
  static unsigned long long Key(int a, int b)
  {
    const auto low = static_cast<unsigned long long>(a < b ? a : b);
    const auto high = static_cast<unsigned long long>(a < b ? b : a);
    return (low << 32) | high;
  }

  void Add(int a, int b);

  std::unordered_set<unsigned long long> Pairs;
  std::array<unsigned long long, 64> Low{}; ///< for ids below 64: a bit for each that touches
  std::vector<Id> Counts;
};

} // namespace lamina
