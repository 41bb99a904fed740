// SPDX-License-Identifier: BSD-3-Clause
#include "GradedPoints.h"

#include "../Mesh/Adjacency.h"
#include "../Search/TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace lamina
{

namespace
{

/// A tet this many layers high on the layer has a third more volume than the prism under it.
constexpr double LayersHigh = 4;
/// Least and largest height of the first tets over the surface's edge, for their shape.
constexpr double LeastHeight = 0.25;
constexpr double LargestHeight = 0.9;
/// How far a point must be from other parts of the surface, over its height.
constexpr double LeastClearance = 0.25;
/// Between points, over the surface's edges.
constexpr double Spacing = 0.35;

std::size_t U(Id i)
{
  return static_cast<std::size_t>(i);
}

std::vector<Vec3> InwardNormals(const TriangleComplex& surface)
{
  std::vector<Vec3> inward(surface.points.size());
  for (const Triangle& t : surface.triangles)
  {
    const Vec3 area = AreaVector2(surface.points, t);
    for (Id p : t)
    {
      inward[U(p)] -= area;
    }
  }
  std::transform(inward.begin(), inward.end(), inward.begin(), [](const Vec3& v) { return Normalized(v); });
  return inward;
}

} // namespace

std::vector<std::size_t> ThinOut(const std::vector<Vec3>& points, const std::vector<double>& radius,
                                 double spacing)
{
  const double cell = spacing * *std::max_element(radius.begin(), radius.end());
  std::vector<std::size_t> kept;
  std::map<std::array<long long, 3>, std::vector<std::size_t>> grid;
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    if (radius[v] == 0)
    {
      continue;
    }
    std::array<long long, 3> at;
    for (int c = 0; c < 3; ++c)
    {
      at[static_cast<std::size_t>(c)] = static_cast<long long>(std::floor(points[v][c] / cell));
    }
    bool isFree = true;
    for (int q = 0; q < 27 && isFree; ++q)
    {
      const auto found = grid.find({ at[0] + q % 3 - 1, at[1] + q / 3 % 3 - 1, at[2] + q / 9 - 1 });
      if (found != grid.end())
      {
        for (std::size_t other : found->second)
        {
          isFree = isFree && Norm(points[other] - points[v]) > spacing * std::min(radius[v], radius[other]);
        }
      }
    }
    if (isFree)
    {
      grid[at].push_back(v);
      kept.push_back(v);
    }
  }
  return kept;
}

std::vector<Vec3> GradedPoints(const TriangleComplex& surface, Monitor& monitor)
{
  if (surface.layerHeight.size() != surface.points.size() || surface.triangles.empty())
  {
    return {};
  }
  const std::vector<double> edge = MeanEdgesAtPoints(surface.points, surface.triangles);
  const std::vector<Vec3> inward = InwardNormals(surface);
  const TriangleTree tree(surface.points, surface.triangles);
  const std::size_t count = surface.points.size();
  std::vector<Vec3> places(count);
  std::vector<double> radius(count, 0);
  monitor.For(static_cast<Id>(count), 256,
              [&](Id begin, Id end)
              {
                for (Id v = begin; v < end; ++v)
                {
                  const double wanted = LayersHigh * surface.layerHeight[U(v)];
                  if (!(wanted > 0 && wanted < LargestHeight * edge[U(v)]))
                  {
                    continue;
                  }
                  const double least = LeastHeight * edge[U(v)];
                  double height = std::max(wanted, least);
                  const auto hit = tree.FirstHit(surface.points[U(v)], inward[U(v)], 1e-9, 2.5 * height,
                                                 [&](Id t)
                                                 {
                                                   const Triangle& c = surface.triangles[U(t)];
                                                   return c[0] != v && c[1] != v && c[2] != v;
                                                 });
                  // In a gap to another part of the surface in its middle, if that is not too flat.
                  height = hit.triangle < 0 ? height : std::min(height, 0.5 * hit.t);
                  const Vec3 place = surface.points[U(v)] + height * inward[U(v)];
                  // Not too near to other parts of the surface.
                  const double limit = LeastClearance * height;
                  const bool isAlone = tree.ClosestPoint(place, limit * limit).triangle < 0;
                  if (isAlone && height >= least)
                  {
                    places[U(v)] = place;
                    radius[U(v)] = edge[U(v)];
                  }
                }
              });
  std::vector<Vec3> points;
  for (std::size_t v : ThinOut(places, radius, Spacing))
  {
    points.push_back(places[v]);
  }
  return points;
}

} // namespace lamina
