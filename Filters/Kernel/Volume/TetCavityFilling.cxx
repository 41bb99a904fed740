// SPDX-License-Identifier: BSD-3-Clause
// Cavities that are filled anew with the points they have.
#include "TetCavityShell.h"

#include "../Geometry/SmallPolyhedron.h"

#include <algorithm>
#include <limits>

namespace lamina
{
namespace
{

/// Cavities of so many points are tried: fewer are what removing edges and flipping faces does, more take too
/// long.
constexpr std::size_t FewestPoints = 6;
constexpr std::size_t MostPoints = 16;
/// Steps of the search in one cavity.
constexpr int Steps = 1500;
constexpr double LeastGain = 1e-3;

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

bool Has(const std::vector<Id>& points, Id point)
{
  return std::find(points.begin(), points.end(), point) != points.end();
}

} // namespace

/// The tet beside the shell that is to join next: one that brings no point, the worst of them; else the worst
/// of all. -1 if there is none.
Id TetCavity::Next(const Shell& shell, const std::vector<Id>& points) const
{
  Id best = -1;
  bool isBestOurs = false;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < shell.faces.size(); ++f)
  {
    const Id t = this->Across(shell.faces[f], shell.inside[f]);
    if (t < 0)
    {
      continue;
    }
    const Tet& tet = this->Set.tets[Index(t)];
    const bool isOurs = std::all_of(tet.begin(), tet.end(), [&](Id p) { return Has(points, p); });
    const double quality = this->Quality(tet);
    if ((isOurs && !isBestOurs) || (isOurs == isBestOurs && quality < least))
    {
      best = t;
      isBestOurs = isOurs;
      least = quality;
    }
  }
  return best;
}

/// The best filling of the shell, of kind Nothing if there is none better than what fills it.
TetCavity::Change TetCavity::Filled(const Shell& shell, const std::vector<Id>& points) const
{
  SmallPolyhedron polyhedron;
  const auto numberOf = [&](Id p)
  { return static_cast<int>(std::find(points.begin(), points.end(), p) - points.begin()); };
  for (const Id p : points)
  {
    polyhedron.points.push_back(this->Set.points[Index(p)]);
    polyhedron.mayGo.push_back(this->Set.fixed[Index(p)] == 0 && this->LayerOf(p) < 0 ? 1 : 0);
  }
  for (const Triangle& f : shell.faces)
  {
    polyhedron.faces.push_back({ { numberOf(f[0]), numberOf(f[1]), numberOf(f[2]) } });
  }
  polyhedron.allows = [&](int a, int b)
  { return this->Allows(points[static_cast<std::size_t>(a)], points[static_cast<std::size_t>(b)]); };
  Change change;
  change.quality = this->LeastOf(shell.tets) + LeastGain;
  const auto tetOf = [&](const std::array<int, 4>& c)
  {
    const auto at = [&](std::size_t k) { return points[static_cast<std::size_t>(c[k])]; };
    return Tet{ { at(0), at(1), at(2), at(3) } };
  };
  const auto tets = FillPolyhedron(
    polyhedron, [&](const std::array<int, 4>& c) { return this->Quality(tetOf(c)); }, change.quality, Steps);
  std::transform(tets.begin(), tets.end(), std::back_inserter(change.in), tetOf);
  change.kind = tets.empty() ? Done::Nothing : Done::CavityFilled;
  change.out = shell.tets;
  return change;
}

TetCavity::Done TetCavity::Refill(Id tet)
{
  const Tet own = this->Set.tets[Index(tet)];
  Shell shell;
  shell.Add(tet, own);
  std::vector<Id> points(own.begin(), own.end());
  std::size_t tried = 0;
  for (;;)
  {
    const Id next = this->Next(shell, points);
    const Tet none{ { -1, -1, -1, -1 } };
    const Tet& joins = next < 0 ? none : this->Set.tets[Index(next)];
    const bool isFull = std::any_of(joins.begin(), joins.end(), [&](Id p) { return !Has(points, p); });
    if (isFull && points.size() >= FewestPoints && points.size() > tried + 1)
    {
      tried = points.size();
      const Change change = this->Filled(shell, points);
      if (change.kind != Done::Nothing)
      {
        this->Apply(change);
        return change.kind;
      }
    }
    if (next < 0 || points.size() >= MostPoints)
    {
      return Done::Nothing;
    }
    shell.Add(next, joins);
    std::copy_if(joins.begin(), joins.end(), std::back_inserter(points),
                 [&](Id p) { return !Has(points, p); });
  }
}

} // namespace lamina
