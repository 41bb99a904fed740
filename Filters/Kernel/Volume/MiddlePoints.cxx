// SPDX-License-Identifier: BSD-3-Clause
#include "MiddlePoints.h"

#include "../Search/TriangleTree.h"

#include <cmath>
#include <map>

namespace lamina
{

namespace
{

std::size_t U(Id i)
{
  return static_cast<std::size_t>(i);
}

} // namespace

std::vector<Vec3> MiddlePoints(const Wall& wall, const Columns& columns, const TriangleComplex& front,
                               int layers, double anisotropy, Monitor& monitor)
{
  const TriangleTree tree(front.points, front.triangles);
  const std::size_t count = wall.points.size();
  std::vector<Vec3> middle(count);
  std::vector<double> radius(count, 0);
  monitor.For(static_cast<Id>(count), 256,
              [&](Id begin, Id end)
              {
                for (Id v = begin; v < end; ++v)
                {
                  if (wall.fixed[U(v)] || (columns.layers > 0 && columns.Stopped(v)))
                  {
                    continue;
                  }
                  const Vec3& m = columns.direction[U(v)];
                  const double thickness = wall.thickness.empty() ? 0 : wall.thickness[U(v)];
                  const auto hit =
                    tree.FirstHit(front.points[U(v)], m, 1e-3 * thickness, 3.0 * thickness / layers,
                                  [&](Id t)
                                  {
                                    const Triangle& c = front.triangles[U(t)];
                                    return c[0] != v && c[1] != v && c[2] != v;
                                  });
                  if (hit.triangle >= 0)
                  {
                    middle[U(v)] = front.points[U(v)] + (0.5 * hit.t) * m;
                    radius[U(v)] = 0.5 * hit.t;
                  }
                }
              });
  // Greedy thinning on a grid, in the order of ids. A radius is a layer's thickness: along the wall points
  // may stand about half as close as the wall's own.
  const double spacing = std::min(1.0, 0.45 * anisotropy);
  double cell = 0;
  for (double r : radius)
  {
    cell = std::max(cell, r);
  }
  std::vector<Vec3> kept;
  std::vector<double> keptRadius;
  std::map<std::array<long long, 3>, std::vector<std::size_t>> grid;
  for (std::size_t v = 0; v < count; ++v)
  {
    if (radius[v] == 0)
    {
      continue;
    }
    std::array<long long, 3> at;
    for (int c = 0; c < 3; ++c)
    {
      at[static_cast<std::size_t>(c)] = static_cast<long long>(std::floor(middle[v][c] / cell));
    }
    bool free = true;
    for (int q = 0; q < 27 && free; ++q)
    {
      const auto found = grid.find({ at[0] + q % 3 - 1, at[1] + q / 3 % 3 - 1, at[2] + q / 9 - 1 });
      if (found != grid.end())
      {
        for (std::size_t other : found->second)
        {
          free = free && Norm(kept[other] - middle[v]) > spacing * std::min(radius[v], keptRadius[other]);
        }
      }
    }
    // Not where a third part of the front comes nearer than the two it was put between.
    if (free && tree.ClosestPoint(middle[v], 0.64 * radius[v] * radius[v]).triangle < 0)
    {
      grid[at].push_back(kept.size());
      kept.push_back(middle[v]);
      keptRadius.push_back(radius[v]);
    }
  }
  return kept;
}

} // namespace lamina
