// SPDX-License-Identifier: BSD-3-Clause
#include "MoveGuard.h"

#include "../Mesh/EdgeAngles.h"

#include <algorithm>

namespace lamina
{

namespace
{

constexpr double leastTurnCosine =
  0.82;                              ///< between a triangle's normal now and at the phase's start: 35 degrees
constexpr double wideOpening = -0.5; ///< neighbours that open 120 degrees: two turns of 35 leave them at 50
constexpr double leastShape = 0.08;  ///< twice the area over the longest edge squared
constexpr double leastGrowth = 0.05; ///< of area over the square of the moves
/// Averages over neighbours that make normals of the surface from those of voxel faces.
constexpr int normalPasses = 2;
constexpr double flattestFold =
  -0.7; ///< cosine between neighbours' directions: no dihedral below about 45 degrees

} // namespace

MoveGuard::MoveGuard(const SmoothingState& state, const DriftCaps& caps)
  : State(state)
  , Caps(caps)
  , Origin(state.surface.points)
  , OriginNormal(state.surface.points.size())
{
  for (const Triangle& t : state.surface.triangles)
  {
    const Vec3 area = AreaVector2(state.surface.points, t);
    for (Id p : t)
    {
      this->OriginNormal[static_cast<std::size_t>(p)] += area;
    }
  }
  for (int pass = 0; pass < normalPasses; ++pass)
  {
    const std::vector<Vec3> before = this->OriginNormal;
    for (std::size_t p = 0; p < before.size(); ++p)
    {
      for (Id q : Row(state.ring, static_cast<Id>(p)))
      {
        this->OriginNormal[p] += before[static_cast<std::size_t>(q)];
      }
    }
  }
  for (Vec3& n : this->OriginNormal)
  {
    n = Normalized(n);
  }
}

void MoveGuard::StartPhase(std::vector<double> radii)
{
  this->Radii = std::move(radii);
  this->Anchor = this->State.surface.points;
  this->AnchorNormal.clear();
  for (const Triangle& t : this->State.surface.triangles)
  {
    this->AnchorNormal.push_back(Normalized(AreaVector2(this->Anchor, t)));
  }
  this->Sharp.assign(this->State.surface.triangles.size(), 0);
  for (std::size_t e = 0; e < this->State.table.edges.size(); ++e)
  {
    if (!this->OpensWide(static_cast<Id>(e)))
    {
      for (Id t : Row(this->State.table.triangles, static_cast<Id>(e)))
      {
        this->Sharp[static_cast<std::size_t>(t)] = 1;
      }
    }
  }
}

/// True if all triangles at the edge stand so wide apart that their angle need not be watched.
bool MoveGuard::OpensWide(Id e) const
{
  const Edge& edge = this->State.table.edges[static_cast<std::size_t>(e)];
  const Vec3& a = this->Anchor[static_cast<std::size_t>(edge.a)];
  const Vec3 u = Normalized(this->Anchor[static_cast<std::size_t>(edge.b)] - a);
  const auto direction = [&](Id triangle)
  {
    const Triangle& tri = this->State.surface.triangles[static_cast<std::size_t>(triangle)];
    const Vec3 w = this->Anchor[static_cast<std::size_t>(tri[0] + tri[1] + tri[2] - edge.a - edge.b)] - a;
    return Normalized(w - Dot(w, u) * u);
  };
  const ListRow row = Row(this->State.table.triangles, e);
  if (row.last - row.first != 2)
  {
    return false;
  }
  return Dot(direction(row.first[0]), direction(row.first[1])) <= wideOpening;
}

Vec3 MoveGuard::Place(Id p, const Relaxation& r) const
{
  const Vec3& x = this->State.surface.points[static_cast<std::size_t>(p)];
  return p == r.a ? x + r.moveA : (p == r.b ? x + r.moveB : x);
}

bool MoveGuard::StaysNear(Id p, const Vec3& place) const
{
  const auto v = static_cast<std::size_t>(p);
  const Vec3 drift = place - this->Origin[v];
  return IsFinite(place) && Norm2(place - this->Anchor[v]) <= this->Radii[v] * this->Radii[v] &&
         std::abs(Dot(drift, this->OriginNormal[v])) <= this->Caps.alongNormal &&
         Norm2(drift) <= this->Caps.inAll * this->Caps.inAll;
}

bool MoveGuard::Keeps(Id t, const Vec3& a, const Vec3& b, const Vec3& c) const
{
  const Vec3 area = Cross(b - a, c - a);
  const double size2 = Norm2(area);
  const double along = Dot(area, this->AnchorNormal[static_cast<std::size_t>(t)]);
  const double longest2 = std::max({ Norm2(b - a), Norm2(c - b), Norm2(a - c) });
  return along >= 0 && along * along >= leastTurnCosine * leastTurnCosine * size2 &&
         size2 >= leastShape * leastShape * longest2 * longest2;
}

bool MoveGuard::KeepsTriangle(Id t) const
{
  const Triangle& tri = this->State.surface.triangles[static_cast<std::size_t>(t)];
  const auto x = [&](Id p) { return this->State.surface.points[static_cast<std::size_t>(p)]; };
  return this->Keeps(t, x(tri[0]), x(tri[1]), x(tri[2]));
}

/// True if two triangles at the edge stand closer than they may and closer than they did at `before`.
bool MoveGuard::Closes(const Edge& edge, const std::vector<Vec3>& before) const
{
  const auto cosine = [&](Id s, Id t, const std::vector<Vec3>& x)
  { return CosineAtEdge(x, this->State.surface.triangles, edge, s, t); };
  const auto close = [&](Id s, Id t)
  {
    const double now = cosine(s, t, this->State.surface.points);
    return now > -flattestFold && now > cosine(s, t, before);
  };
  bool any = false;
  this->State.ForTrianglesAt(
    edge,
    [&](Id s) { this->State.ForTrianglesAt(edge, [&](Id t) { any = any || (s < t && close(s, t)); }); });
  return any;
}

std::vector<Id> MoveGuard::Offending(const std::vector<Vec3>& before, Monitor& monitor) const
{
  const std::vector<Vec3>& points = this->State.surface.points;
  const auto moved = [&](Id p)
  { return !(points[static_cast<std::size_t>(p)] == before[static_cast<std::size_t>(p)]); };
  std::vector<char> far(points.size(), 0);
  monitor.For(static_cast<Id>(points.size()), 8192,
              [&](Id begin, Id end)
              {
                for (Id p = begin; p < end; ++p)
                {
                  far[static_cast<std::size_t>(p)] =
                    moved(p) && !this->StaysNear(p, points[static_cast<std::size_t>(p)]) ? 1 : 0;
                }
              });
  const std::vector<Triangle>& triangles = this->State.surface.triangles;
  std::vector<char> bad(triangles.size(), 0);
  monitor.For(static_cast<Id>(triangles.size()), 4096,
              [&](Id begin, Id end)
              {
                for (Id t = begin; t < end; ++t)
                {
                  const Triangle& tri = triangles[static_cast<std::size_t>(t)];
                  if (!moved(tri[0]) && !moved(tri[1]) && !moved(tri[2]))
                  {
                    continue;
                  }
                  bool offends = !this->KeepsTriangle(t);
                  for (std::size_t k = 0; k < 3 && this->IsSharp(t); ++k)
                  {
                    offends = offends || this->Closes(this->State.EdgeAcross(t, k), before);
                  }
                  bad[static_cast<std::size_t>(t)] = offends ? 1 : 0;
                }
              });
  std::vector<Id> offending;
  for (std::size_t t = 0; t < bad.size(); ++t)
  {
    for (std::size_t k = 0; k < 3 && bad[t]; ++k)
    {
      far[static_cast<std::size_t>(triangles[t][k])] = 1;
    }
  }
  for (std::size_t p = 0; p < far.size(); ++p)
  {
    if (far[p] && moved(static_cast<Id>(p)))
    {
      offending.push_back(static_cast<Id>(p));
    }
  }
  return offending;
}

bool MoveGuard::KeepsTriangles(Id p, const Relaxation& r, double& growth) const
{
  for (Id t : Row(this->State.star, p))
  {
    const Triangle& tri = this->State.surface.triangles[static_cast<std::size_t>(t)];
    const Vec3 a = this->Place(tri[0], r);
    const Vec3 b = this->Place(tri[1], r);
    const Vec3 c = this->Place(tri[2], r);
    if (p == r.a || (tri[0] != r.a && tri[1] != r.a && tri[2] != r.a)) // each triangle once
    {
      growth += Norm(Cross(b - a, c - a)) - Norm(AreaVector2(this->State.surface.points, tri));
    }
    if (!this->Keeps(t, a, b, c))
    {
      return false;
    }
  }
  return true;
}

/// Every two triangles at an edge of t open wider than about 45 degrees, or at least no less than before the
/// move.
bool MoveGuard::KeepsAngles(Id t, const Relaxation& r) const
{
  const auto& points = this->State.surface.points;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Edge edge = this->State.EdgeAcross(t, k);
    const auto direction = [&](Id triangle, bool moved)
    {
      const Triangle& tri = this->State.surface.triangles[static_cast<std::size_t>(triangle)];
      const Id far = tri[0] + tri[1] + tri[2] - edge.a - edge.b;
      const Vec3 a = moved ? this->Place(edge.a, r) : points[static_cast<std::size_t>(edge.a)];
      const Vec3 b = moved ? this->Place(edge.b, r) : points[static_cast<std::size_t>(edge.b)];
      const Vec3 u = Normalized(b - a);
      const Vec3 w = (moved ? this->Place(far, r) : points[static_cast<std::size_t>(far)]) - a;
      return Normalized(w - Dot(w, u) * u);
    };
    bool closes = false;
    const auto look = [&](Id other)
    {
      if (other == t || closes)
      {
        return;
      }
      const double now = Dot(direction(t, true), direction(other, true));
      closes = now > -flattestFold && now > Dot(direction(t, false), direction(other, false));
    };
    this->State.ForTrianglesAt(edge, look);
    if (closes)
    {
      return false;
    }
  }
  return true;
}

bool MoveGuard::Allows(const Relaxation& r) const
{
  double growth = 0; // of twice the area
  for (Id p : { r.a, r.b })
  {
    if (p >= 0 && (!this->StaysNear(p, this->Place(p, r)) || !this->KeepsTriangles(p, r, growth)))
    {
      return false;
    }
  }
  // Drawing the points of a bump together and paying for it in height would make a spike of it: area must not
  // grow by more than the share of a move that is mere tangential smoothing.
  if (growth > leastGrowth * (Norm2(r.moveA) + Norm2(r.moveB)))
  {
    return false;
  }
  for (Id p : { r.a, r.b })
  {
    if (p < 0)
    {
      continue;
    }
    for (Id t : Row(this->State.star, p))
    {
      if (!this->Sharp[static_cast<std::size_t>(t)])
      {
        continue;
      }
      const Triangle& tri = this->State.surface.triangles[static_cast<std::size_t>(t)];
      const bool seen = p == r.b && (tri[0] == r.a || tri[1] == r.a || tri[2] == r.a);
      if (!seen && !this->KeepsAngles(t, r))
      {
        return false;
      }
    }
  }
  return true;
}

} // namespace lamina
