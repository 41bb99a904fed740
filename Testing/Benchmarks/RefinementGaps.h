// SPDX-License-Identifier: BSD-3-Clause
// How near sheets stand to each other and how sharply triangles meet, before and after refinement.
#pragma once

#include "Mesh/EdgeAngles.h"
#include "RefinementSheets.h"
#include "Search/Clearance.h"
#include "Search/Facing.h"
#include "Search/SheetGaps.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

namespace lamina::measures
{

constexpr double quarter = 0.25;     ///< of a voxel: sheets must not come nearer
constexpr double farthestLook = 0.6; ///< in voxels: half of it is more than a quarter

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
  const auto unit = [&](std::size_t p) { return voxel > 0 ? voxel : s.targetEdgeLength[p]; };
  std::vector<double> reaches;
  for (std::size_t p = 0; p < s.points.size(); ++p)
  {
    reaches.push_back(farthestLook * unit(p));
  }
  const std::vector<double> gaps = MeasureTrueGaps(s, table, star, reaches, monitor);
  Nearness found;
  found.gap = farthestLook;
  for (std::size_t p = 0; p < gaps.size(); ++p)
  {
    const double gap = gaps[p] / unit(p);
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

/// The pairs of triangles that bound a gap of less than a quarter (of a voxel, or of the target where that is
/// less or there is none) and of less than half of what lies between the nearest places of their sheets in
/// the surface before. Here all pairs are looked at, one by one.
inline Id CountNarrowed(const TriangleComplex& before, const TriangleComplex& after, double voxel,
                        Monitor& monitor)
{
  constexpr double rounding = 1e-6;
  constexpr double facing = 0.7071; // 45 degrees
  const Sheets own(after);
  const Sheets sheets(before);
  const Lists star = TrianglesOfPoints(static_cast<Id>(after.points.size()), after.triangles);
  const TriangleTree tree(after.points, after.triangles);
  const auto most = *std::max_element(after.targetEdgeLength.begin(), after.targetEdgeLength.end());
  const auto isKept = [&](Id s, Id t, double unit, const Vec3& from, const Vec3& to)
  {
    const Vec3 way = to - from;
    const double gap = Norm(way);
    const auto towards = [&](Id triangle, const Vec3& direction)
    {
      const auto corners = CornersAt(after, triangle);
      const double along =
        Dot(Normalized(Cross(corners[1] - corners[0], corners[2] - corners[0])), direction) / gap;
      const int material = MaterialTowards(after.materials[static_cast<std::size_t>(triangle)], along);
      return std::abs(along) < facing ? -1 : material;
    };
    const int material = gap < (1 - rounding) * quarter * unit ? towards(s, way) : -1;
    if (material < 0 || towards(t, -1 * way) != material)
    {
      return true;
    }
    const auto origin = [&](Id triangle, const Vec3& x)
    { return sheets.Tree(own.KeyOf(static_cast<std::size_t>(triangle)))->ClosestPoint(x).point; };
    return gap >= (1 - rounding) * 0.5 * Norm(origin(s, from) - origin(t, to)) ||
           AreJoined(
             from, after.triangles[static_cast<std::size_t>(s)], to,
             after.triangles[static_cast<std::size_t>(t)], shortWay * gap, [&](Id p) { return At(after, p); },
             [&](Id p, const auto& visit)
             {
               for (const Id around : Row(star, p))
               {
                 for (const Id q : after.triangles[static_cast<std::size_t>(around)])
                 {
                   visit(q);
                 }
               }
             });
  };
  std::atomic<Id> narrowed{ 0 };
  tree.ForPairs(quarter * (voxel > 0 ? voxel : most), monitor,
                [&](Id s, Id t)
                {
                  const Triangle& c = after.triangles[static_cast<std::size_t>(s)];
                  const Triangle& d = after.triangles[static_cast<std::size_t>(t)];
                  if (ShareCorner(c, d))
                  {
                    return;
                  }
                  double unit = voxel > 0 ? voxel : most;
                  for (std::size_t k = 0; k < 3; ++k)
                  {
                    unit = std::min({ unit, after.targetEdgeLength[static_cast<std::size_t>(c[k])],
                                      after.targetEdgeLength[static_cast<std::size_t>(d[k])] });
                  }
                  narrowed += AllOfConnections(CornersAt(after, s), CornersAt(after, t),
                                               [&](const Vec3& from, const Vec3& to)
                                               { return isKept(s, t, unit, from, to); })
                                ? 0
                                : 1;
                });
  return narrowed;
}

/// No angle falls below ten degrees, or what there was.
inline bool StayOpen(const Nearness& before, const Nearness& after)
{
  constexpr double least = 10;
  return after.angle >= std::min(least, before.angle);
}

} // namespace lamina::measures
