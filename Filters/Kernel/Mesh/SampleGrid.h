// SPDX-License-Identifier: BSD-3-Clause
// A few places, found by box.
#pragma once

#include "../Base/Types.h"

#include <algorithm>

namespace lamina
{

/// The material of a sample of which nothing is known.
constexpr int Anything = -1;

struct Sample
{
  Vec3 place;
  int material = Anything; ///< that the surface says, 0 outside
};

/// Samples in a uniform grid over a box: few samples and many cells, so the cells are run past the samples.
class SampleGrid
{
public:
  SampleGrid(const std::vector<Sample>& samples, const Vec3& low, const Vec3& high)
    : Low(low)
    , Bins(Steps * Steps * Steps)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->PerLength[k] = high[k] > low[k] ? Steps / (high[k] - low[k]) : 0;
    }
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      const Vec3& p = samples[i].place;
      this->Bins[this->Bin(this->Step(p, 0), this->Step(p, 1), this->Step(p, 2))].push_back(i);
    }
  }

  /// Samples in the bins that the box meets.
  template<typename Visit>
  void ForBox(const Vec3& low, const Vec3& high, Visit&& visit) const
  {
    for (std::size_t z = this->Step(low, 2); z <= this->Step(high, 2); ++z)
    {
      for (std::size_t y = this->Step(low, 1); y <= this->Step(high, 1); ++y)
      {
        for (std::size_t x = this->Step(low, 0); x <= this->Step(high, 0); ++x)
        {
          for (std::size_t i : this->Bins[this->Bin(x, y, z)])
          {
            visit(i);
          }
        }
      }
    }
  }

private:
  std::size_t Step(const Vec3& p, int axis) const
  {
    const double step = (p[axis] - this->Low[axis]) * this->PerLength[axis];
    return static_cast<std::size_t>(std::clamp(step, 0.0, Steps - 1.0));
  }
  static std::size_t Bin(std::size_t x, std::size_t y, std::size_t z) { return x + Steps * (y + Steps * z); }

  static constexpr std::size_t Steps = 24; ///< along each axis

  Vec3 Low;
  Vec3 PerLength;
  std::vector<std::vector<std::size_t>> Bins;
};

} // namespace lamina
