// SPDX-License-Identifier: BSD-3-Clause
#include "Wall.h"

#include <algorithm>
#include <map>
#include <set>

namespace lamina
{

namespace
{

constexpr double Flatness = 1e-8; ///< of a cap, over its extent

std::size_t U(Id i)
{
  return static_cast<std::size_t>(i);
}

bool Contains(const std::vector<int>& list, int value)
{
  return std::find(list.begin(), list.end(), value) != list.end();
}

bool CarriesLayers(const TriangleComplex& surface, Id triangle, int material, const WallChoice& choice)
{
  const MaterialPair& pair = surface.materials[U(triangle)];
  const int other = pair.first == material ? pair.second : pair.first;
  const int patch = surface.Patch(triangle);
  return (choice.neighbours.empty() || Contains(choice.neighbours, other)) &&
         (choice.patches.empty() || Contains(choice.patches, patch)) && !IsOpening(surface, patch);
}

/// Corners with the normal out of the material.
Triangle TurnedOut(const TriangleComplex& surface, Id t, int material)
{
  Triangle corners = surface.triangles[U(t)];
  if (SideOf(surface.materials[U(t)], material) < 0)
  {
    std::swap(corners[1], corners[2]);
  }
  return corners;
}

/// Origin, normal and sizes; false if the triangles do not lie in a plane.
bool Measure(const TriangleComplex& surface, const std::vector<Triangle>& triangles, WallCap& cap)
{
  Vec3 area;
  double edges = 0;
  cap.origin = surface.points[U(triangles[0][0])];
  for (const Triangle& t : triangles)
  {
    area += AreaVector2(surface.points, t);
    for (std::size_t k = 0; k < 3; ++k)
    {
      edges += Norm(surface.points[U(t[(k + 1) % 3])] - surface.points[U(t[k])]);
    }
  }
  cap.normal = Normalized(area);
  cap.edge = edges / static_cast<double>(3 * triangles.size());
  double height = 0;
  for (const Triangle& t : triangles)
  {
    for (Id p : t)
    {
      const Vec3 offset = surface.points[U(p)] - cap.origin;
      cap.extent = std::max(cap.extent, Norm(offset));
      height = std::max(height, std::abs(Dot(offset, cap.normal)));
    }
  }
  return height <= Flatness * cap.extent;
}

/// The edges of triangles that no other of them has, in the triangles' sense.
std::vector<std::array<Id, 2>> RimOf(const std::vector<Triangle>& triangles)
{
  std::set<std::array<Id, 2>> edges;
  for (const Triangle& t : triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      edges.insert({ { t[k], t[(k + 1) % 3] } });
    }
  }
  std::vector<std::array<Id, 2>> rim;
  std::copy_if(edges.begin(), edges.end(), std::back_inserter(rim),
               [&](const std::array<Id, 2>& e) {
                 return edges.count({ { e[1], e[0] } }) == 0;
               });
  return rim;
}

/// The plane openings towards the outside, by patch; rims still with the surface's ids.
std::vector<WallCap> FindCaps(const TriangleComplex& surface, int material)
{
  std::map<int, std::vector<Id>> ofPatch;
  for (Id t = 0; t < static_cast<Id>(surface.triangles.size()); ++t)
  {
    const MaterialPair& pair = surface.materials[U(t)];
    if (SideOf(pair, material) != 0 && pair.second == 0 && IsOpening(surface, surface.Patch(t)))
    {
      ofPatch[surface.Patch(t)].push_back(t);
    }
  }
  std::vector<WallCap> caps;
  for (auto& [patch, ids] : ofPatch)
  {
    std::vector<Triangle> triangles;
    std::transform(ids.begin(), ids.end(), std::back_inserter(triangles),
                   [&](Id t) { return TurnedOut(surface, t, material); });
    WallCap cap;
    if (Measure(surface, triangles, cap))
    {
      cap.rim = RimOf(triangles);
      cap.surfaceTriangles = std::move(ids);
      caps.push_back(std::move(cap));
    }
  }
  return caps;
}

/// Gives the surface's points ids of the wall's own, as they come.
class Numbering
{
public:
  Numbering(const TriangleComplex& surface, Wall& wall)
    : Surface(surface)
    , W(wall)
    , Number(surface.points.size(), -1)
  {
  }
  Id operator()(Id p)
  {
    Id& n = this->Number[U(p)];
    if (n < 0)
    {
      n = static_cast<Id>(this->W.points.size());
      this->W.points.push_back(this->Surface.points[U(p)]);
      this->W.surfacePoints.push_back(p);
      this->W.fixed.push_back(0);
      this->W.capOf.push_back(-1);
    }
    return n;
  }

private:
  const TriangleComplex& Surface;
  Wall& W;
  std::vector<Id> Number;
};

/// Rims in the wall's ids; a point of two caps cannot stay in both planes.
void TakeCaps(std::vector<WallCap> caps, Numbering& number, Wall& wall)
{
  for (WallCap& cap : caps)
  {
    const int c = static_cast<int>(wall.caps.size());
    for (std::array<Id, 2>& edge : cap.rim)
    {
      for (Id& p : edge)
      {
        p = number(p);
        int& own = wall.capOf[U(p)];
        wall.fixed[U(p)] |= own >= 0 && own != c ? 1 : 0;
        own = c;
      }
    }
    wall.caps.push_back(std::move(cap));
  }
}

} // namespace

Wall MakeWall(const TriangleComplex& surface, int material, const WallChoice& choice)
{
  Wall wall;
  wall.material = material;
  std::vector<WallCap> caps = choice.hasCaps ? FindCaps(surface, material) : std::vector<WallCap>{};
  std::set<Id> inCaps;
  for (const WallCap& cap : caps)
  {
    inCaps.insert(cap.surfaceTriangles.begin(), cap.surfaceTriangles.end());
  }
  Numbering number(surface, wall);
  for (Id t = 0; t < static_cast<Id>(surface.triangles.size()); ++t)
  {
    const int side = SideOf(surface.materials[U(t)], material);
    if (side == 0 || inCaps.count(t) > 0)
    {
      continue;
    }
    Triangle corners = surface.triangles[U(t)];
    const bool isBare = !CarriesLayers(surface, t, material, choice);
    for (Id& p : corners)
    {
      p = number(p);
      wall.fixed[U(p)] |= isBare ? 1 : 0;
    }
    if (side > 0) // the triangle's normal leaves the material
    {
      std::swap(corners[1], corners[2]);
    }
    wall.triangles.push_back(corners);
    wall.surfaceTriangles.push_back(t);
  }
  TakeCaps(std::move(caps), number, wall);
  wall.star = TrianglesOfPoints(static_cast<Id>(wall.points.size()), wall.triangles);
  const auto column = std::find(surface.sizedMaterials.begin(), surface.sizedMaterials.end(), material);
  if (column != surface.sizedMaterials.end())
  {
    const std::size_t columns = surface.sizedMaterials.size();
    const auto m = static_cast<std::size_t>(column - surface.sizedMaterials.begin());
    for (Id p : wall.surfacePoints)
    {
      wall.thickness.push_back(surface.thickness[U(p) * columns + m]);
    }
  }
  return wall;
}

} // namespace lamina
