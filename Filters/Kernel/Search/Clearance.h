// SPDX-License-Identifier: BSD-3-Clause
// How far the points of a surface may move before parts of it that share no corner could meet.
#pragma once

#include "../Base/Monitor.h"
#include "TriangleTree.h"

namespace lamina
{

inline bool ShareCorner(const Triangle& s, const Triangle& t)
{
  return s[0] == t[0] || s[0] == t[1] || s[0] == t[2] || s[1] == t[0] || s[1] == t[1] || s[1] == t[2] ||
         s[2] == t[0] || s[2] == t[1] || s[2] == t[2];
}

/// Where the shortest connection of segments (p, p2) and (q, q2) ends on either, 0 to 1.
std::array<double, 2> SegmentParameters(const Vec3& p, const Vec3& p2, const Vec3& q, const Vec3& q2);

/// The shortest connection of segments (p, p2) and (q, q2), towards the first.
Vec3 SegmentConnection(const Vec3& p, const Vec3& p2, const Vec3& q, const Vec3& q2);

/// True if `holds(from, to)` for all connections of which one is the shortest of two triangles that do not
/// intersect: from each corner to the other triangle, and between each two edges; `from` lies on s.
template<typename Holds>
bool AllOfConnections(const std::array<Vec3, 3>& s, const std::array<Vec3, 3>& t, Holds&& holds)
{
  Vec3 closest;
  std::array<double, 3> weights;
  for (std::size_t i = 0; i < 3; ++i)
  {
    PointTriangleDistance2(s[i], t[0], t[1], t[2], closest, weights);
    if (!holds(s[i], closest))
    {
      return false;
    }
    PointTriangleDistance2(t[i], s[0], s[1], s[2], closest, weights);
    if (!holds(closest, t[i]))
    {
      return false;
    }
    for (std::size_t j = 0; j < 3; ++j)
    {
      const auto at = SegmentParameters(s[i], s[(i + 1) % 3], t[j], t[(j + 1) % 3]);
      if (!holds(s[i] + at[0] * (s[(i + 1) % 3] - s[i]), t[j] + at[1] * (t[(j + 1) % 3] - t[j])))
      {
        return false;
      }
    }
  }
  return true;
}

/// Squared distance of two triangles that do not intersect.
double TriangleTriangleDistance2(const std::array<Vec3, 3>& s, const std::array<Vec3, 3>& t);

/// Distance of triangle t to the nearest one of the tree without a common corner, at most `cutoff`.
double TriangleClearance(const TriangleTree& tree, const std::vector<Vec3>& points,
                         const std::vector<Triangle>& triangles, Id t, double cutoff);

/// Per point the least distance of its triangles to any triangle without a common corner, at most `cutoff`.
/// If every point stays within less than half of its value, no two such triangles can meet.
std::vector<double> PointClearances(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                                    double cutoff, Monitor& monitor);
/// The same with a cutoff for every point; a triangle takes the largest of its corners'.
std::vector<double> PointClearances(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                                    const std::vector<double>& cutoffs, Monitor& monitor);

} // namespace lamina
