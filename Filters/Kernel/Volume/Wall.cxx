// SPDX-License-Identifier: BSD-3-Clause
#include "Wall.h"

#include <algorithm>

namespace lamina
{

Wall MakeWall(const TriangleComplex& surface, int material)
{
  Wall wall;
  wall.material = material;
  std::vector<Id> number(surface.points.size(), -1);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const int side = SideOf(surface.materials[t], material);
    if (side == 0)
    {
      continue;
    }
    Triangle corners = surface.triangles[t];
    const bool opening = IsOpening(surface, surface.Patch(static_cast<Id>(t)));
    for (Id& p : corners)
    {
      Id& n = number[static_cast<std::size_t>(p)];
      if (n < 0)
      {
        n = static_cast<Id>(wall.points.size());
        wall.points.push_back(surface.points[static_cast<std::size_t>(p)]);
        wall.surfacePoints.push_back(p);
        wall.fixed.push_back(0);
      }
      p = n;
      wall.fixed[static_cast<std::size_t>(p)] |= opening ? 1 : 0;
    }
    if (side > 0) // the triangle's normal leaves the material
    {
      std::swap(corners[1], corners[2]);
    }
    wall.triangles.push_back(corners);
    wall.surfaceTriangles.push_back(static_cast<Id>(t));
  }
  wall.star = TrianglesOfPoints(static_cast<Id>(wall.points.size()), wall.triangles);
  const auto column = std::find(surface.sizedMaterials.begin(), surface.sizedMaterials.end(), material);
  if (column != surface.sizedMaterials.end())
  {
    const std::size_t columns = surface.sizedMaterials.size();
    const auto m = static_cast<std::size_t>(column - surface.sizedMaterials.begin());
    for (Id p : wall.surfacePoints)
    {
      wall.thickness.push_back(surface.thickness[static_cast<std::size_t>(p) * columns + m]);
    }
  }
  return wall;
}

} // namespace lamina
