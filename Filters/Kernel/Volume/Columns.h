// SPDX-License-Identifier: BSD-3-Clause
// Straight columns of layer points on a wall: where every layer's nodes stand, such that all cells between
// them are valid and no two fronts meet.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "Wall.h"

namespace lamina
{

enum class ColumnCells
{
  Prisms, ///< wedges; pyramids and tets where columns stopped
  Tets    ///< each wedge split into three tets by the least-id rule
};

struct ColumnOptions
{
  int layers = 5;
  double growth = 1;   ///< height of a layer over the one below
  double share = 0.25; ///< of the local thickness that all layers together take
  ColumnCells cells = ColumnCells::Prisms;
  double total = 0;       ///< height of all layers, a length, instead of the share; 0: by the share
  double firstHeight = 0; ///< of the first layer, a length, instead of both; 0: not fixed
  /// Prisms are better (WedgeQuality), or their columns stop; but not where no direction sees
  /// all faces well, or one of them is poor.
  double leastQuality = 0.2;
  std::vector<char> stopped{}; ///< one a wall node, not 0: no column stands there; empty: all may
};

/// Layer k (0 the wall, `layers` the front) of node v stands at wall.points[v] + height[v] * fraction[k] *
/// direction[v].
struct Columns
{
  int layers = 0;
  std::vector<Vec3> direction;
  std::vector<double> height;   ///< 0: the column stopped, all its layers are the wall node
  std::vector<double> wanted;   ///< height asked for
  std::vector<double> fraction; ///< layers + 1 values from 0 to 1
  std::vector<char> hidden;     ///< nodes that no direction sees: their columns are stopped

  bool Stopped(Id v) const { return this->height[static_cast<std::size_t>(v)] == 0; }
  Vec3 Place(const Wall& wall, Id v, int layer) const
  {
    const auto i = static_cast<std::size_t>(v);
    return wall.points[i] +
           (this->height[i] * this->fraction[static_cast<std::size_t>(layer)]) * this->direction[i];
  }
};

/// Grow columns on the whole wall. Heights start at `share` of the thickness, are limited in slope, and
/// shrink where a cell would be invalid or badly shaped or where fronts come too near to each other, until
/// all is sound; where even thin layers are not, columns stop. The wall must be free of intersections.
Result<Columns> GrowColumns(const Wall& wall, const ColumnOptions& options, Monitor& monitor);

} // namespace lamina
