// SPDX-License-Identifier: BSD-3-Clause
// Thin sheets of a middle class between a lower and a higher one: skins of partial volume, and thin layers.
#pragma once

#include "SegmentRules.h"

namespace lamina
{
namespace segment
{

/// A voxel of a thin sheet and the two materials it lies between.
struct SheetVoxel
{
  Id voxel = 0;
  int lower = 0;
  int upper = 0;
  bool climbs = false; ///< the grey values climb all the way from lower to upper
  double own =
    0; ///< how much likelier the grey value is of the own material than of a ramp: log of the ratio
};

/// Two ideas of where a grey value in a class comes from: the material itself, with the values it has where
/// it is thick, or a ramp between two others, which takes all values of the class alike.
class Plateau
{
public:
  Plateau(const ClassValues& values, double width);
  /// The logarithm of the likelihood of the first over that of the second.
  double LogRatio(double value) const;

private:
  ClassValues Values;
  double Width;
};

/// Between which materials sheets are looked for.
enum class SheetsBetween
{
  Allowed,  ///< those that may touch
  Forbidden ///< those that may not
};

/// Finds the sheets at most two voxels thick in voxels that no rule made.
class SheetFinder
{
public:
  SheetFinder(const Work& work, SheetsBetween which);
  /// Those of slice k, in memory order.
  std::vector<SheetVoxel> Find(Id k) const;

private:
  using Place = std::array<Id, 3>;

  bool Inside(const Place& p) const
  {
    return p[0] >= 0 && p[1] >= 0 && p[2] >= 0 && p[0] < this->Size[0] && p[1] < this->Size[1] &&
           p[2] < this->Size[2];
  }
  Id Index(const Place& p) const { return this->Image.image.grid.Index(p[0], p[1], p[2]); }
  /// The label there; the voxel's own, which decides nothing, outside the image.
  int Label(const Place& p, int own) const
  {
    return this->Inside(p) ? this->Image.labels[this->Index(p)] : own;
  }
  bool IsAmongOwn(const Place& p, Id voxel) const;
  bool IsThin(const Place& p, SheetVoxel& found) const;
  bool IsBetween(const Place& p, const std::array<Id, 3>& direction, int own, SheetVoxel& found) const;
  bool IsClimb(const Place& from, const std::array<Id, 3>& step, int steps) const;
  bool ReachesBody(const Place& p, int own) const;
  bool IsBody(const Place& p, int own) const;

  const Work& Image;
  SheetsBetween Which;
  std::array<Id, 3> Size;
  std::vector<Plateau> Plateaus; ///< by material
};

} // namespace segment
} // namespace lamina
