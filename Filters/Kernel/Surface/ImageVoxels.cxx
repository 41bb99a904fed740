// SPDX-License-Identifier: BSD-3-Clause
#include "ImageVoxels.h"

#include <algorithm>
#include <limits>

namespace lamina
{
namespace
{

constexpr int Farthest = 8; ///< voxels that are searched for a border

} // namespace

double ImageVoxels::ToBorder(const Vec3& world, const MaterialPair& pair) const
{
  const Vec3 at = this->Locate(world);
  const std::array<Id, 3> home{ { std::llround(at.x), std::llround(at.y), std::llround(at.z) } };
  const Vec3& s = this->Image.grid.spacing;
  const double step = std::min({ s.x, s.y, s.z });
  double best = std::numeric_limits<double>::infinity();
  for (int reach = 1; reach <= Farthest && !(best <= (reach - 1.5) * step); ++reach)
  {
    best = this->NearestFace(at, home, reach, pair);
  }
  return std::min(best, Farthest * step);
}

double ImageVoxels::NearestFace(const Vec3& at, const std::array<Id, 3>& home, int reach,
                                const MaterialPair& pair) const
{
  double best2 = std::numeric_limits<double>::infinity();
  for (Id k = home[2] - reach; k <= home[2] + reach; ++k)
  {
    for (Id j = home[1] - reach; j <= home[1] + reach; ++j)
    {
      for (Id i = home[0] - reach; i <= home[0] + reach; ++i)
      {
        const int here = this->Label({ { i, j, k } });
        if (here != pair.first && here != pair.second)
        {
          continue;
        }
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          std::array<Id, 3> next{ { i, j, k } };
          ++next[axis];
          const int there = this->Label(next);
          if (here != there && (there == pair.first || there == pair.second))
          {
            best2 = std::min(best2, this->ToFace2(at, { { i, j, k } }, axis));
          }
        }
      }
    }
  }
  return std::sqrt(best2);
}

double ImageVoxels::ToFace2(const Vec3& at, const std::array<Id, 3>& voxel, std::size_t axis) const
{
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double away = at[static_cast<int>(k)] - static_cast<double>(voxel[k]);
    const double d = k == axis ? away - 0.5 : std::max(0.0, std::abs(away) - 0.5);
    sum += std::pow(d * this->Image.grid.spacing[static_cast<int>(k)], 2);
  }
  return sum;
}

} // namespace lamina
