// SPDX-License-Identifier: BSD-3-Clause
// Which triangles meet at a point, and which edges a complex has.
#pragma once

#include "TriangleComplex.h"

#include <cstddef>

namespace lamina
{

/// Lists of ids in one array: the items of row r are data[offsets[r]] to data[offsets[r + 1] - 1].
struct Lists
{
  std::vector<Id> offsets;
  std::vector<Id> data;

  const Id* Begin(Id row) const { return this->data.data() + this->offsets[static_cast<std::size_t>(row)]; }
  const Id* End(Id row) const { return this->data.data() + this->offsets[static_cast<std::size_t>(row) + 1]; }
  Id Count(Id row) const { return static_cast<Id>(this->End(row) - this->Begin(row)); }
};

/// The range of one row, for range-based loops.
struct ListRow
{
  const Id* first;
  const Id* last;
  const Id* begin() const { return this->first; }
  const Id* end() const { return this->last; }
};
inline ListRow Row(const Lists& lists, Id row)
{
  return { lists.Begin(row), lists.End(row) };
}

/// The triangles at every point, ascending.
Lists TrianglesOfPoints(Id pointCount, const std::vector<Triangle>& triangles);

/// An edge with its triangles: those of `EdgeTable::triangles`' row.
struct Edge
{
  Id a = 0; ///< the lower point id
  Id b = 0;
};

/// All edges of a complex, ascending by (a, b), with the triangles at each.
struct EdgeTable
{
  std::vector<Edge> edges;
  Lists triangles;
};
EdgeTable MakeEdgeTable(const std::vector<Triangle>& triangles);

/// The materials that occur in a complex, ascending, background apart.
std::vector<int> MaterialsOf(const TriangleComplex& surface);

/// +1 if the triangle's normal points out of `material`, -1 if into it, 0 if it does not border it.
inline int SideOf(const MaterialPair& pair, int material)
{
  return pair.first == material ? 1 : (pair.second == material ? -1 : 0);
}

/// True if patch p of the surface is an opening: a plane end of a material through which it is meant to go
/// on.
bool IsOpening(const TriangleComplex& surface, int patch);

/// Twice the area times the unit normal of a triangle.
inline Vec3 AreaVector2(const std::vector<Vec3>& points, const Triangle& t)
{
  const Vec3& a = points[static_cast<std::size_t>(t[0])];
  return Cross(points[static_cast<std::size_t>(t[1])] - a, points[static_cast<std::size_t>(t[2])] - a);
}

/// The mean length of the edges at each point; 0 where there is none.
std::vector<double> MeanEdgesAtPoints(const std::vector<Vec3>& points,
                                      const std::vector<Triangle>& triangles);

/// The mean edge length over all triangles; 0 for an empty complex.
double MeanEdgeLength(const TriangleComplex& surface);

} // namespace lamina
