// SPDX-License-Identifier: BSD-3-Clause
// How two triangles stand to each other at an edge they share.
#pragma once

#include "Adjacency.h"

namespace lamina
{

/// The unit vector from edge (a, b) towards `far`, across the edge.
inline Vec3 DirectionFromEdge(const Vec3& a, const Vec3& b, const Vec3& far)
{
  const Vec3 u = Normalized(b - a);
  const Vec3 w = far - a;
  return Normalized(w - Dot(w, u) * u);
}

/// The unit vector from the edge into the triangle, across the edge.
inline Vec3 DirectionFromEdge(const std::vector<Vec3>& points, const Triangle& triangle, const Edge& edge)
{
  const auto at = [&](Id p) { return points[static_cast<std::size_t>(p)]; };
  return DirectionFromEdge(at(edge.a), at(edge.b),
                           at(triangle[0] + triangle[1] + triangle[2] - edge.a - edge.b));
}

/// The cosine of the angle between triangles s and t at their edge: 1 where they lie on each other, -1 where
/// they are one plane.
inline double CosineAtEdge(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                           const Edge& edge, Id s, Id t)
{
  return Dot(DirectionFromEdge(points, triangles[static_cast<std::size_t>(s)], edge),
             DirectionFromEdge(points, triangles[static_cast<std::size_t>(t)], edge));
}

} // namespace lamina
