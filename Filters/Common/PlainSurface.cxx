// SPDX-License-Identifier: BSD-3-Clause
#include "PlainSurface.h"

#include "MeshArrayNames.h"

#include <algorithm>

namespace lamina
{

namespace
{

/// An edge by its lower and higher point, and whether its triangle runs from the lower to the higher one.
struct HalfEdge
{
  Id low;
  Id high;
  bool upwards;
};

std::vector<HalfEdge> SortedEdges(const std::vector<Triangle>& triangles)
{
  std::vector<HalfEdge> edges;
  edges.reserve(3 * triangles.size());
  for (const Triangle& t : triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Id from = t[i];
      const Id to = t[(i + 1) % 3];
      edges.push_back({ std::min(from, to), std::max(from, to), from < to });
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](const HalfEdge& a, const HalfEdge& b) {
              return a.low != b.low ? a.low < b.low
                                    : (a.high != b.high ? a.high < b.high : a.upwards < b.upwards);
            });
  return edges;
}

/// Middles of the edges that do not have two triangles running in opposite directions.
std::vector<Vec3> BadEdges(const TriangleComplex& surface)
{
  std::vector<Vec3> bad;
  const auto edges = SortedEdges(surface.triangles);
  for (std::size_t i = 0; i < edges.size();)
  {
    std::size_t j = i;
    while (j < edges.size() && edges[j].low == edges[i].low && edges[j].high == edges[i].high)
    {
      ++j;
    }
    if (j - i != 2 || edges[i].upwards == edges[i + 1].upwards)
    {
      bad.push_back(0.5 * (surface.points[static_cast<std::size_t>(edges[i].low)] +
                           surface.points[static_cast<std::size_t>(edges[i].high)]));
    }
    i = j;
  }
  return bad;
}

double SixfoldVolume(const TriangleComplex& surface)
{
  double sum = 0;
  const Vec3 origin = surface.points.empty() ? Vec3{} : surface.points.front();
  for (const Triangle& t : surface.triangles)
  {
    const Vec3 a = surface.points[static_cast<std::size_t>(t[0])] - origin;
    const Vec3 b = surface.points[static_cast<std::size_t>(t[1])] - origin;
    const Vec3 c = surface.points[static_cast<std::size_t>(t[2])] - origin;
    sum += Dot(a, Cross(b, c));
  }
  return sum;
}

} // namespace

Status LabelPlainSurface(TriangleComplex& surface)
{
  const std::vector<Vec3> bad = BadEdges(surface);
  if (!bad.empty())
  {
    return InvalidInput(std::string("no ") + names::BoundaryLabels +
                          " on the triangles: run Multimaterial Marching Cubes first. A surface without them "
                          "must be closed and of one "
                          "orientation, but " +
                          std::to_string(bad.size()) +
                          " edges do not have two triangles of one orientation (points that coincide count "
                          "as different: run Clean)",
                        bad);
  }
  if (SixfoldVolume(surface) < 0)
  {
    for (Triangle& t : surface.triangles)
    {
      std::swap(t[1], t[2]);
    }
  }
  surface.materials.assign(surface.triangles.size(), MaterialPair{ 1, 0 });
  return Done{};
}

} // namespace lamina
