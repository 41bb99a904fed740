// SPDX-License-Identifier: BSD-3-Clause
#include "PlaneSection.h"

#include "../Mesh/Adjacency.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

namespace lamina
{
namespace
{

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

std::size_t Root(std::vector<std::size_t>& parent, std::size_t i)
{
  while (parent[i] != i)
  {
    i = parent[i] = parent[parent[i]];
  }
  return i;
}

void Join(std::vector<std::size_t>& parent, std::size_t a, std::size_t b)
{
  const std::size_t ra = Root(parent, a);
  const std::size_t rb = Root(parent, b);
  parent[std::max(ra, rb)] = std::min(ra, rb);
}

double Distance(const Vec2& p, const Vec2& a, const Vec2& b)
{
  const Vec2 d{ b.x - a.x, b.y - a.y };
  const double length2 = d.x * d.x + d.y * d.y;
  const double t = length2 > 0 ? ((p.x - a.x) * d.x + (p.y - a.y) * d.y) / length2 : 0;
  const double s = std::min(1.0, std::max(0.0, t));
  return std::hypot(p.x - a.x - s * d.x, p.y - a.y - s * d.y);
}

} // namespace

PlaneFrame::PlaneFrame(const Vec3& place, const Vec3& direction)
  : origin(place)
  , normal(Normalized(direction))
{
  // Beside the axis that is farthest from the normal.
  const Vec3 size{ std::abs(this->normal.x), std::abs(this->normal.y), std::abs(this->normal.z) };
  const Vec3 axis = size.x <= size.y && size.x <= size.z
                      ? Vec3{ 1, 0, 0 }
                      : (size.y <= size.z ? Vec3{ 0, 1, 0 } : Vec3{ 0, 0, 1 });
  this->u = Normalized(Cross(axis, this->normal));
  this->v = Cross(this->normal, this->u);
}

PlaneSection::PlaneSection(const TriangleComplex& surface, const PlaneFrame& frame,
                           const std::vector<double>& heights)
  : PieceOf(surface.triangles.size(), -1)
{
  // Segments that end on the same edge of the surface belong to one rim.
  std::map<std::array<Id, 2>, std::size_t> firstAt;
  std::vector<std::size_t> parent;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const Triangle& corners = surface.triangles[t];
    std::array<Vec2, 2> ends;
    std::size_t found = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id a = std::min(corners[k], corners[(k + 1) % 3]);
      const Id b = std::max(corners[k], corners[(k + 1) % 3]);
      const double ha = heights[Index(a)];
      const double hb = heights[Index(b)];
      if ((ha > 0) == (hb > 0))
      {
        continue;
      }
      const Vec3 p =
        surface.points[Index(a)] + (surface.points[Index(b)] - surface.points[Index(a)]) * (ha / (ha - hb));
      ends[found++] = frame.ToPlane(p);
      const auto [at, isNew] = firstAt.emplace(std::array<Id, 2>{ { a, b } }, this->Segments.size());
      if (found == 1)
      {
        parent.push_back(this->Segments.size());
      }
      if (!isNew)
      {
        Join(parent, at->second, this->Segments.size());
      }
    }
    if (found == 2)
    {
      const Vec3 normal = AreaVector2(surface.points, corners);
      this->Segments.push_back({ static_cast<Id>(t),
                                 ends[0],
                                 ends[1],
                                 { Dot(normal, frame.u), Dot(normal, frame.v) },
                                 surface.materials[t],
                                 0 });
    }
  }
  for (std::size_t s = 0; s < this->Segments.size(); ++s)
  {
    this->Segments[s].rim = Root(parent, s);
  }
  this->JoinRims();
}

PlaneSection::Sight PlaneSection::Look(const Vec2& from, Id rim) const
{
  Sight sight;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t s = 0; s < this->Segments.size(); ++s)
  {
    const Segment& segment = this->Segments[s];
    if (static_cast<Id>(segment.rim) == rim || (segment.a.y > from.y) == (segment.b.y > from.y))
    {
      continue;
    }
    const double x =
      segment.a.x + (segment.b.x - segment.a.x) * (from.y - segment.a.y) / (segment.b.y - segment.a.y);
    if (x > from.x && x < nearest)
    {
      nearest = x;
      sight = { s, segment.across.x < 0 ? segment.pair.second : segment.pair.first, true };
    }
  }
  return sight;
}

/// Rims bound one piece if what lies between them is material.
void PlaneSection::JoinRims()
{
  std::map<std::size_t, std::size_t> rightmost; // segment of each rim
  const auto right = [&](std::size_t s) { return std::max(this->Segments[s].a.x, this->Segments[s].b.x); };
  for (std::size_t s = 0; s < this->Segments.size(); ++s)
  {
    const auto [at, isNew] = rightmost.emplace(this->Segments[s].rim, s);
    if (!isNew && right(s) > right(at->second))
    {
      at->second = s;
    }
  }
  std::vector<std::size_t> parent(this->Segments.size());
  std::iota(parent.begin(), parent.end(), std::size_t{ 0 });
  for (const auto& [rim, s] : rightmost)
  {
    const Segment& segment = this->Segments[s];
    const Sight sight = this->Look(segment.a.x > segment.b.x ? segment.a : segment.b, static_cast<Id>(rim));
    if (sight.label != 0)
    {
      Join(parent, rim, this->Segments[sight.segment].rim);
    }
  }
  std::map<std::size_t, int> numbers;
  this->PieceOfRim.assign(this->Segments.size(), -1);
  for (const Segment& segment : this->Segments)
  {
    const int piece =
      numbers.emplace(Root(parent, segment.rim), static_cast<int>(numbers.size())).first->second;
    this->PieceOf[Index(segment.triangle)] = piece;
    this->PieceOfRim[segment.rim] = piece;
  }
  this->Count = static_cast<int>(numbers.size());
}

std::vector<Id> PlaneSection::TrianglesOfPiece(int piece) const
{
  std::vector<Id> triangles;
  for (const Segment& segment : this->Segments)
  {
    if (this->PieceOfRim[segment.rim] == piece)
    {
      triangles.push_back(segment.triangle);
    }
  }
  return triangles;
}

PlaneSection::Nearest PlaneSection::Find(const Vec2& place) const
{
  const Sight sight = this->Look(place, -1);
  if (sight.label != 0)
  {
    return { this->PieceOfRim[this->Segments[sight.segment].rim], 0 };
  }
  Nearest nearest;
  nearest.distance = std::numeric_limits<double>::infinity();
  for (const Segment& segment : this->Segments)
  {
    const double distance = Distance(place, segment.a, segment.b);
    if (distance < nearest.distance && (segment.pair.first == 0 || segment.pair.second == 0))
    {
      nearest = { this->PieceOfRim[segment.rim], distance };
    }
  }
  return nearest;
}

double PlaneSection::AreaOfPiece(int piece) const
{
  double twice = 0;
  for (const Segment& segment : this->Segments)
  {
    if (segment.pair.second == 0 && this->PieceOfRim[segment.rim] == piece)
    {
      // With the material on the left.
      const Vec2 along{ segment.b.x - segment.a.x, segment.b.y - segment.a.y };
      const double turn = along.x * segment.across.y - along.y * segment.across.x;
      const double part = segment.a.x * segment.b.y - segment.a.y * segment.b.x;
      twice += turn < 0 ? part : -part;
    }
  }
  return 0.5 * twice;
}

} // namespace lamina
