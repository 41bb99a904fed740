// SPDX-License-Identifier: BSD-3-Clause
// How near sheets stand to each other and how sharply triangles meet, before and after refinement.
#pragma once

#include "Mesh/EdgeAngles.h"
#include "Search/SheetGaps.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lamina::measures
{

constexpr double quarter = 0.25; ///< of a voxel: sheets must not come nearer

struct Nearness
{
  double gap = 0;     ///< the least one between triangles, in voxels or, without them, targets
  Id near = 0;        ///< points where it is less than a quarter
  double angle = 180; ///< least one between triangles that share an edge, in degrees
};

/// `voxel`: 0 if there is none.
inline Nearness MeasureNearness(const TriangleComplex& s, double voxel, Monitor& monitor)
{
  const EdgeTable table = MakeEdgeTable(s.triangles);
  const Lists star = TrianglesOfPoints(static_cast<Id>(s.points.size()), s.triangles);
  const double widest =
    voxel > 0 ? voxel : *std::max_element(s.targetEdgeLength.begin(), s.targetEdgeLength.end());
  const std::vector<double> gaps = MeasureTrueGaps(s, table, star, widest, monitor);
  Nearness found;
  found.gap = 1;
  for (std::size_t p = 0; p < gaps.size(); ++p)
  {
    const double gap = gaps[p] / (voxel > 0 ? voxel : s.targetEdgeLength[p]);
    found.gap = std::min(found.gap, gap);
    found.near += gap < quarter ? 1 : 0;
  }
  double greatest = -1;
  for (std::size_t e = 0; e < table.edges.size(); ++e)
  {
    const ListRow row = Row(table.triangles, static_cast<Id>(e));
    for (const Id* t = row.first; t != row.last; ++t)
    {
      for (const Id* u = t + 1; u != row.last; ++u)
      {
        greatest = std::max(greatest, CosineAtEdge(s.points, s.triangles, table.edges[e], *t, *u));
      }
    }
  }
  found.angle = std::acos(std::min(1.0, greatest)) * 180 / 3.141592653589793;
  return found;
}

/// Sheets stay a quarter apart, or half of the least distance that there was.
inline bool StayApart(const Nearness& before, const Nearness& after)
{
  constexpr double rounding = 1e-6;
  return after.gap >= std::min(quarter, 0.5 * before.gap) * (1 - rounding);
}

/// No angle falls below ten degrees, or what there was.
inline bool StayOpen(const Nearness& before, const Nearness& after)
{
  constexpr double least = 10;
  return after.angle >= std::min(least, before.angle);
}

} // namespace lamina::measures
