// SPDX-License-Identifier: BSD-3-Clause
#include "MiddlePoints.h"

#include "../Search/TriangleTree.h"
#include "GradedPoints.h"

#include <algorithm>

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
  // A radius is a layer's thickness: along the wall points
  // may stand about half as close as the wall's own.
  const double spacing = std::min(1.0, 0.45 * anisotropy);
  // Not where a third part of the front comes nearer than the two it was put between.
  for (std::size_t v = 0; v < count; ++v)
  {
    const double limit = 0.8 * radius[v];
    radius[v] = tree.ClosestPoint(middle[v], limit * limit).triangle < 0 ? radius[v] : 0;
  }
  std::vector<Vec3> kept;
  for (std::size_t v : ThinOut(middle, radius, spacing))
  {
    kept.push_back(middle[v]);
  }
  return kept;
}

} // namespace lamina
