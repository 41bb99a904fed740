// SPDX-License-Identifier: BSD-3-Clause
#include "FrontCaps.h"

#include "../Geometry/FlatTriangulation.h"
#include "../Search/SelfIntersection.h"

#include <map>

namespace lamina
{

namespace
{

std::size_t U(Id i)
{
  return static_cast<std::size_t>(i);
}

/// Coordinates in a cap's plane, seen from outside.
struct Frame
{
  Vec3 origin;
  Vec3 u;
  Vec3 v;

  explicit Frame(const WallCap& cap)
    : origin(cap.origin)
  {
    const Vec3& n = cap.normal;
    const Vec3 axis = std::abs(n.x) < 0.6 ? Vec3{ 1, 0, 0 } : Vec3{ 0, 1, 0 };
    this->u = Normalized(Cross(axis, n));
    this->v = Cross(n, this->u);
  }
  Vec2 ToPlane(const Vec3& p) const
  {
    return { Dot(p - this->origin, this->u), Dot(p - this->origin, this->v) };
  }
  Vec3 ToSpace(const Vec2& q) const { return this->origin + q.x * this->u + q.y * this->v; }
};

bool Close(const Wall& wall, const WallCap& cap, TriangleComplex& front)
{
  const Frame frame(cap);
  std::vector<Vec2> places;
  std::vector<Id> pointOf;
  std::map<Id, Id> placeOf;
  PlaneEdges edges;
  for (const std::array<Id, 2>& edge : cap.rim)
  {
    std::array<Id, 2> ends{};
    for (std::size_t k = 0; k < 2; ++k)
    {
      const auto [at, isNew] = placeOf.emplace(edge[k], static_cast<Id>(places.size()));
      if (isNew)
      {
        places.push_back(frame.ToPlane(front.points[U(edge[k])]));
        pointOf.push_back(edge[k]);
      }
      ends[k] = at->second;
    }
    edges.push_back(ends);
  }
  const std::vector<FlatRegion> regions = FindFlatRegions(places, edges);
  for (const FlatRegion& region : regions)
  {
    const std::vector<Triangle> triangles = FillFlatRegion(places, region, cap.edge);
    if (triangles.empty())
    {
      return false;
    }
    while (pointOf.size() < places.size())
    {
      pointOf.push_back(static_cast<Id>(front.points.size()));
      front.points.push_back(frame.ToSpace(places[pointOf.size() - 1]));
      front.layerHeight.push_back(0);
      front.layerSide.push_back({});
    }
    for (const Triangle& c : triangles)
    {
      front.triangles.push_back({ pointOf[U(c[0])], pointOf[U(c[1])], pointOf[U(c[2])] });
      front.materials.push_back({ wall.material, 0 });
    }
  }
  return !regions.empty();
}

} // namespace

bool CloseFront(const Wall& wall, TriangleComplex& front, Monitor& monitor)
{
  for (const WallCap& cap : wall.caps)
  {
    if (!Close(wall, cap, front))
    {
      return false;
    }
  }
  return wall.caps.empty() || FindIntersections(front.points, front.triangles, monitor).empty();
}

} // namespace lamina
