// SPDX-License-Identifier: BSD-3-Clause
// What a volume-conserving sweep works on: the surface with its adjacency, and where every point may go.
#pragma once

#include "../Mesh/JunctionGraph.h"

#include <algorithm>

namespace lamina
{

/// The directions a point may move in: all, those in a plane, along a line, or none.
struct Freedom
{
  int dimensions = 3;
  Vec3 axis; ///< the plane's normal (2) or the line's direction (1)

  Vec3 Project(const Vec3& d) const
  {
    switch (this->dimensions)
    {
      case 3:
        return d;
      case 2:
        return d - Dot(d, this->axis) * this->axis;
      case 1:
        return Dot(d, this->axis) * this->axis;
      default:
        return {};
    }
  }
};

struct SmoothingState
{
  explicit SmoothingState(TriangleComplex& complex);

  /// The edge of triangle t that its corner k does not touch.
  Edge EdgeAcross(Id t, std::size_t k) const
  {
    const Triangle& tri = this->surface.triangles[static_cast<std::size_t>(t)];
    const auto ends = std::minmax(tri[(k + 1) % 3], tri[(k + 2) % 3]);
    return { ends.first, ends.second };
  }
  /// Calls visit(triangle) for every triangle at an edge.
  template<typename Visit>
  void ForTrianglesAt(const Edge& edge, const Visit& visit) const
  {
    for (const Id t : Row(this->star, edge.a))
    {
      const Triangle& tri = this->surface.triangles[static_cast<std::size_t>(t)];
      if (tri[0] == edge.b || tri[1] == edge.b || tri[2] == edge.b)
      {
        visit(t);
      }
    }
  }

  TriangleComplex& surface;
  Lists star; ///< triangles of points
  Lists ring; ///< neighbours of points, ascending
  EdgeTable table;
  std::vector<char> feature; ///< a flag an edge of `table`
  std::vector<std::array<Id, 2>>
    alongCurve; ///< neighbours along the curve, -1 for points that are not on one
  std::vector<Freedom> freedom;
};

} // namespace lamina
