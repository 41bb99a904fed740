// SPDX-License-Identifier: BSD-3-Clause
#include "SmoothingState.h"

#include <algorithm>

namespace lamina
{

namespace
{

Lists RingsOfPoints(std::size_t pointCount, const EdgeTable& table)
{
  Lists rings;
  rings.offsets.assign(pointCount + 1, 0);
  for (const Edge& e : table.edges)
  {
    ++rings.offsets[static_cast<std::size_t>(e.a) + 1];
    ++rings.offsets[static_cast<std::size_t>(e.b) + 1];
  }
  for (std::size_t i = 1; i <= pointCount; ++i)
  {
    rings.offsets[i] += rings.offsets[i - 1];
  }
  rings.data.resize(2 * table.edges.size());
  std::vector<Id> fill(rings.offsets.begin(), rings.offsets.end() - 1);
  for (const Edge& e : table.edges) // ascending (a, b): each row comes out ascending for b, then sorted below
  {
    rings.data[static_cast<std::size_t>(fill[static_cast<std::size_t>(e.a)]++)] = e.b;
    rings.data[static_cast<std::size_t>(fill[static_cast<std::size_t>(e.b)]++)] = e.a;
  }
  for (std::size_t i = 0; i < pointCount; ++i)
  {
    std::sort(rings.data.begin() + rings.offsets[i], rings.data.begin() + rings.offsets[i + 1]);
  }
  return rings;
}

/// Where the plane patches around a point let it go: the intersection of their planes.
Freedom FreedomOf(const TriangleComplex& surface, const Lists& star, Id point)
{
  Freedom freedom;
  for (Id t : Row(star, point))
  {
    if (surface.Patch(t) == 0)
    {
      continue;
    }
    const Vec3 normal =
      Normalized(AreaVector2(surface.points, surface.triangles[static_cast<std::size_t>(t)]));
    if (freedom.dimensions == 3)
    {
      freedom = { 2, normal };
    }
    else if (freedom.dimensions == 2 && std::abs(Dot(freedom.axis, normal)) < 0.999)
    {
      freedom = { 1, Normalized(Cross(freedom.axis, normal)) };
    }
    else if (freedom.dimensions == 1 && std::abs(Dot(freedom.axis, normal)) > 0.05)
    {
      return { 0, {} };
    }
  }
  return freedom;
}

} // namespace

SmoothingState::SmoothingState(TriangleComplex& complex)
  : surface(complex)
  , star(TrianglesOfPoints(static_cast<Id>(complex.points.size()), complex.triangles))
  , table(MakeEdgeTable(complex.triangles))
  , feature(FeatureEdges(complex, table))
{
  const std::size_t count = complex.points.size();
  this->ring = RingsOfPoints(count, this->table);
  this->alongCurve.assign(count, { { -1, -1 } });
  for (std::size_t e = 0; e < this->table.edges.size(); ++e)
  {
    if (!this->feature[e])
    {
      continue;
    }
    const Edge& edge = this->table.edges[e];
    for (int end = 0; end < 2; ++end)
    {
      const Id p = end == 0 ? edge.a : edge.b;
      const Id q = end == 0 ? edge.b : edge.a;
      if ((complex.junctionKind[static_cast<std::size_t>(p)] & 3) == JunctionCurve)
      {
        auto& both = this->alongCurve[static_cast<std::size_t>(p)];
        both[both[0] < 0 ? 0 : 1] = q;
      }
    }
  }
  this->freedom.resize(count);
  for (std::size_t p = 0; p < count; ++p)
  {
    this->freedom[p] = FreedomOf(complex, this->star, static_cast<Id>(p));
  }
}

} // namespace lamina
