// SPDX-License-Identifier: BSD-3-Clause
#include "Wall.h"

#include <algorithm>

namespace lamina
{

namespace
{

bool CarriesLayers(const TriangleComplex& surface, Id triangle, int material,
                   const std::vector<int>& neighbours)
{
  const MaterialPair& pair = surface.materials[static_cast<std::size_t>(triangle)];
  const int other = pair.first == material ? pair.second : pair.first;
  const bool isChosen =
    neighbours.empty() || std::find(neighbours.begin(), neighbours.end(), other) != neighbours.end();
  return isChosen && !IsOpening(surface, surface.Patch(triangle));
}

} // namespace

Wall MakeWall(const TriangleComplex& surface, int material, const std::vector<int>& neighbours)
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
    const bool isBare = !CarriesLayers(surface, static_cast<Id>(t), material, neighbours);
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
      wall.fixed[static_cast<std::size_t>(p)] |= isBare ? 1 : 0;
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
