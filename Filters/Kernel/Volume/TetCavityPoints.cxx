// SPDX-License-Identifier: BSD-3-Clause
// The moves of points; reconnections are in TetCavity.cxx.
#include "TetCavity.h"

#include "../Mesh/TetFaces.h"

#include <algorithm>
#include <limits>

namespace lamina
{
namespace
{

/// A move must be worth its while.
constexpr double LeastGain = 1e-6;

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

} // namespace

Id TetCavity::MovePoints(Id tet)
{
  Id moved = 0;
  const Tet own = this->Set.tets[Index(tet)];
  for (Id p : own)
  {
    if (this->Set.fixed[Index(p)] == 0 && this->IsKnown(p) && this->IsInterior(p))
    {
      moved += this->MovePoint(p);
    }
  }
  return moved;
}

bool TetCavity::IsInterior(Id point) const
{
  // All round it one group, and the faces away from it close: each of their edges runs both ways.
  std::vector<std::array<Id, 2>> edges;
  const auto& star = this->TetsOf(point);
  for (Id t : star)
  {
    const Tet& tet = this->Set.tets[Index(t)];
    if (this->Set.groups[Index(t)] != this->Set.groups[Index(star.front())])
    {
      return false;
    }
    const Triangle face = TetFace(tet, Index(std::find(tet.begin(), tet.end(), point) - tet.begin()));
    for (std::size_t k = 0; k < 3; ++k)
    {
      edges.push_back({ { face[k], face[(k + 1) % 3] } });
    }
  }
  std::sort(edges.begin(), edges.end());
  return std::all_of(
    edges.begin(), edges.end(),
    [&](const auto& e) {
      return std::binary_search(edges.begin(), edges.end(), std::array<Id, 2>{ { e[1], e[0] } });
    });
}

bool TetCavity::MovePoint(Id point)
{
  const auto& star = this->TetsOf(point);
  Vec3& place = this->Set.points[Index(point)];
  const Vec3 start = place;
  double edge = std::numeric_limits<double>::infinity();
  Vec3 centre;
  for (Id t : star)
  {
    for (Id p : this->Set.tets[Index(t)])
    {
      centre += this->Set.points[Index(p)];
      edge = p == point ? edge : std::min(edge, Norm(this->Set.points[Index(p)] - start));
    }
  }
  centre = centre * (1.0 / (4.0 * static_cast<double>(star.size())));
  const double before = this->LeastOf(star);
  double least = before;
  const auto attempt = [&](const Vec3& to)
  {
    const Vec3 from = place;
    place = to;
    const double now = this->LeastOf(star);
    if (now > least + LeastGain)
    {
      least = now;
      return true;
    }
    place = from;
    return false;
  };
  attempt(centre) || attempt(0.5 * (start + centre));
  // A pattern search: the least quality of a star is not smooth, so slopes tell little.
  double step = 0.3 * edge;
  for (int halvings = 0; halvings < 7;)
  {
    bool isBetter = false;
    for (int k = 0; k < 6; ++k)
    {
      Vec3 to = place;
      to[k / 2] += k % 2 == 0 ? step : -step;
      isBetter = attempt(to) || isBetter;
    }
    halvings += isBetter ? 0 : 1;
    step *= isBetter ? 1 : 0.5;
  }
  std::vector<Tet> tets;
  for (Id t : star)
  {
    tets.push_back(this->Set.tets[Index(t)]);
  }
  if (!(place == start) && this->IsSound(tets))
  {
    return true;
  }
  place = start;
  return false;
}

} // namespace lamina
