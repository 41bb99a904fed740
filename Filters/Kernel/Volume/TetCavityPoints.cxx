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

Vec3 SearchBest(const Vec3& start, double step, const PlaceScore& score)
{
  // A pattern search: the least quality of a star is not smooth, so slopes tell little.
  Vec3 best = start;
  double highest = score(start, -std::numeric_limits<double>::infinity());
  for (int halvings = 0; halvings < 7;)
  {
    bool isBetter = false;
    for (int k = 0; k < 6; ++k)
    {
      Vec3 to = best;
      to[k / 2] += k % 2 == 0 ? step : -step;
      const double now = score(to, highest + LeastGain);
      if (now > highest + LeastGain)
      {
        highest = now;
        best = to;
        isBetter = true;
      }
    }
    halvings += isBetter ? 0 : 1;
    step *= isBetter ? 1 : 0.5;
  }
  return best;
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
  std::vector<Id> order = star;
  const auto score = [&](const Vec3& to, double enough)
  {
    place = to;
    return this->LeastOf(order, enough);
  };
  const double before = score(start, -std::numeric_limits<double>::infinity());
  Vec3 first = start;
  for (const Vec3& to : { centre, 0.5 * (start + centre) })
  {
    if (score(to, before + LeastGain) > before + LeastGain)
    {
      first = to;
      break;
    }
  }
  place = SearchBest(first, 0.3 * edge, score);
  std::vector<Tet> tets;
  for (Id t : star)
  {
    tets.push_back(this->Set.tets[Index(t)]);
  }
  if (!(place == start) && this->IsSound(tets))
  {
    for (const Tet& tet : tets)
    {
      if (this->Clock != nullptr)
      {
        this->Clock->Mark(tet);
      }
    }
    return true;
  }
  place = start;
  return false;
}

} // namespace lamina
