// SPDX-License-Identifier: BSD-3-Clause
#include "ThinSheets.h"

#include <algorithm>
#include <cmath>

namespace lamina
{
namespace segment
{

namespace
{

/// The 13 directions through a voxel's 26 neighbours.
constexpr std::array<std::array<Id, 3>, 13> Directions{ { { { 1, 0, 0 } },
                                                          { { 0, 1, 0 } },
                                                          { { 0, 0, 1 } },
                                                          { { 1, 1, 0 } },
                                                          { { 1, -1, 0 } },
                                                          { { 1, 0, 1 } },
                                                          { { 1, 0, -1 } },
                                                          { { 0, 1, 1 } },
                                                          { { 0, 1, -1 } },
                                                          { { 1, 1, 1 } },
                                                          { { 1, 1, -1 } },
                                                          { { 1, -1, 1 } },
                                                          { { 1, -1, -1 } } } };

} // namespace

Plateau::Plateau(const ClassValues& values, double width)
  : Values(values)
  , Width(width)
{
  // No material is so clean that a thousandth of its class would not be noise.
  this->Values.deviation = std::max(values.deviation, 1e-3 * width);
}

double Plateau::LogRatio(double value) const
{
  constexpr double rootOfTwoPi = 2.5066282746310002;
  if (this->Values.count == 0)
  {
    return 0;
  }
  const double off = (value - this->Values.mean) / this->Values.deviation;
  return std::log(this->Width / (rootOfTwoPi * this->Values.deviation)) - 0.5 * off * off;
}

SheetFinder::SheetFinder(const Work& work, SheetsBetween which)
  : Image(work)
  , Which(which)
  , Size(work.Size())
{
  const std::vector<double>& thresholds = work.options.thresholds;
  for (int m = 0; m < work.Materials(); ++m)
  {
    const bool middle = m > 0 && m + 1 < work.Materials();
    this->Plateaus.emplace_back(work.classes[m], middle ? thresholds[m] - thresholds[m - 1] : 1.0);
  }
}

/// True if all 27 voxels around and at p are of one material: there it is three voxels thick.
bool SheetFinder::IsBody(const Place& p, int own) const
{
  for (Id c = -1; c <= 1; ++c)
  {
    for (Id b = -1; b <= 1; ++b)
    {
      for (Id a = -1; a <= 1; ++a)
      {
        const Place q{ p[0] + a, p[1] + b, p[2] + c };
        if (this->Label(q, own) != own)
        {
          return false;
        }
      }
    }
  }
  return true;
}

/// True if the voxel is part of a body of its own material: next to where it is three voxels thick.
bool SheetFinder::ReachesBody(const Place& p, int own) const
{
  for (Id c = -1; c <= 1; ++c)
  {
    for (Id b = -1; b <= 1; ++b)
    {
      for (Id a = -1; a <= 1; ++a)
      {
        const Place q{ p[0] + a, p[1] + b, p[2] + c };
        if (this->Inside(q) && this->IsBody(q, own))
        {
          return true;
        }
      }
    }
  }
  return false;
}

/// True if the grey values climb all along: where two neighbours of a line are nearly the same, the
/// material's own value is reached and the sheet is real. Less than half of the mean climb is nearly the
/// same.
bool SheetFinder::IsClimb(const Place& from, const std::array<Id, 3>& step, int steps) const
{
  double values[4];
  for (int s = 0; s <= steps; ++s)
  {
    values[s] = this->Image.grey.At(
      this->Index({ from[0] + s * step[0], from[1] + s * step[1], from[2] + s * step[2] }));
  }
  const double least = 0.5 * (values[steps] - values[0]) / steps;
  bool climbs = true;
  for (int s = 2; s < steps; ++s)
  {
    climbs = climbs && values[s] - values[s - 1] >= least;
  }
  return climbs;
}

/// Looks along one line: a lower class before, a higher one behind (or the reverse), at most two voxels of
/// the own class between them.
bool SheetFinder::IsBetween(const Place& p, const std::array<Id, 3>& direction, int own,
                            SheetVoxel& found) const
{
  int ends[2];
  int reach[2];
  for (int side = 0; side < 2; ++side)
  {
    const Id sign = side == 0 ? -1 : 1;
    for (reach[side] = 1; reach[side] <= 2; ++reach[side])
    {
      const Id d = sign * reach[side];
      ends[side] =
        this->Label({ p[0] + d * direction[0], p[1] + d * direction[1], p[2] + d * direction[2] }, own);
      if (ends[side] != own)
      {
        break;
      }
    }
  }
  const int lower = std::min(ends[0], ends[1]);
  const int upper = std::max(ends[0], ends[1]);
  if (reach[0] + reach[1] > 3 || lower < 0 || !(lower < own && own < upper) ||
      this->Image.IsForbidden(lower, upper) != (this->Which == SheetsBetween::Forbidden))
  {
    return false;
  }
  const int low = ends[0] == lower ? 0 : 1;
  const Id sign = low == 0 ? 1 : -1;
  const Place from{ p[0] - sign * reach[low] * direction[0], p[1] - sign * reach[low] * direction[1],
                    p[2] - sign * reach[low] * direction[2] };
  const std::array<Id, 3> step{ sign * direction[0], sign * direction[1], sign * direction[2] };
  found.lower = lower;
  found.upper = upper;
  found.climbs = this->IsClimb(from, step, reach[0] + reach[1]);
  return true;
}

/// True if all 26 neighbours are of the voxel's own label: a quick look that most voxels need no more than.
bool SheetFinder::IsAmongOwn(const Place& p, Id voxel) const
{
  for (int a = 0; a < 3; ++a)
  {
    if (p[a] == 0 || p[a] + 1 == this->Size[a])
    {
      return false;
    }
  }
  const int* at = this->Image.labels.data() + voxel;
  const Id up = this->Size[0];
  const Id over = this->Size[0] * this->Size[1];
  bool same = true;
  for (const Id row : { -over - up, -over, -over + up, -up, Id{ 0 }, up, over - up, over, over + up })
  {
    same = same && at[row - 1] == *at && at[row] == *at && at[row + 1] == *at;
  }
  return same;
}

/// A line along which the values climb is preferred to one along which they do not.
bool SheetFinder::IsThin(const Place& p, SheetVoxel& found) const
{
  found.voxel = this->Index(p);
  const int own = this->Image.labels[found.voxel];
  bool between = false;
  for (const auto& direction : Directions)
  {
    SheetVoxel line = found;
    if (this->IsBetween(p, direction, own, line) && (!between || line.climbs))
    {
      found = line;
      between = true;
    }
    if (found.climbs)
    {
      break;
    }
  }
  return between && !this->ReachesBody(p, own);
}

std::vector<SheetVoxel> SheetFinder::Find(Id k) const
{
  std::vector<SheetVoxel> found;
  const int last = this->Image.Materials() - 1;
  for (Id j = 0; j < this->Size[1]; ++j)
  {
    const Id first = this->Image.image.grid.Index(0, j, k);
    for (Id i = 0; i < this->Size[0]; ++i)
    {
      const int label = this->Image.labels[first + i];
      SheetVoxel skin;
      if (label > 0 && label < last && !(this->Image.flags[first + i] & MadeByRule) &&
          !this->IsAmongOwn({ i, j, k }, first + i) && this->IsThin({ i, j, k }, skin))
      {
        skin.own = this->Plateaus[label].LogRatio(this->Image.grey.At(first + i));
        found.push_back(skin);
      }
    }
  }
  return found;
}

} // namespace segment
} // namespace lamina
