// SPDX-License-Identifier: BSD-3-Clause
// Points put in and taken out; reconnections are in TetCavity.cxx, moves in TetCavityPoints.cxx.
#include "FrontCells.h"
#include "TetCavityShell.h"

#include "../Geometry/Predicates.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamina
{
namespace
{

/// Most tets of a cavity: larger ones are seldom bettered.
constexpr std::size_t LargestCavity = 40;
/// A face with a cone of this quality over it needs no larger cavity.
constexpr double WellSeen = 0.3;
/// A change of the points must pay.
constexpr double LeastGain = 1e-2;

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

bool Has(const TetCavity::Tet& tet, Id point)
{
  return std::find(tet.begin(), tet.end(), point) != tet.end();
}

} // namespace

/// The tet on the other side of a face, of the same group; -1 if there is none or it is not known.
Id TetCavity::Across(const Triangle& face, Id tet) const
{
  for (Id p : face)
  {
    if (!this->IsKnown(p))
    {
      continue;
    }
    for (Id t : this->TetsOf(p))
    {
      const Tet& other = this->Set.tets[Index(t)];
      if (t != tet && Has(other, face[0]) && Has(other, face[1]) && Has(other, face[2]))
      {
        if (this->Watched != nullptr)
        {
          this->Watched->insert(this->Watched->end(), other.begin(), other.end());
        }
        return this->Set.groups[Index(t)] == this->Set.groups[Index(tet)] ? t : -1;
      }
    }
    return -1;
  }
  return -1;
}

/// Grows a cavity from the tet, across the face that sees the place worst, and keeps it at the size at which
/// all faces see it best. False if that is no better than the tet.
bool TetCavity::FindCavity(Id tet, const Vec3& place, Shell& best) const
{
  Shell shell;
  shell.Add(tet, this->Set.tets[Index(tet)]);
  double highest = this->Quality(this->Set.tets[Index(tet)]) + LeastGain;
  std::vector<Triangle> ends; // faces that nothing is known behind
  bool isFound = false;
  while (shell.tets.size() < LargestCavity)
  {
    std::size_t worst = shell.faces.size();
    double leastOfOpen = WellSeen;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f < shell.faces.size(); ++f)
    {
      const Triangle& c = shell.faces[f];
      double& quality = shell.quality[f];
      quality = std::isnan(quality) ? this->QualityFrom(c, place) : quality;
      least = std::min(least, quality);
      if (quality < leastOfOpen && std::find(ends.begin(), ends.end(), c) == ends.end())
      {
        leastOfOpen = quality;
        worst = f;
      }
    }
    if (least > highest && this->KeepsPoints(shell))
    {
      highest = least;
      best = shell;
      isFound = true;
    }
    if (worst == shell.faces.size())
    {
      break;
    }
    const Id next = this->Across(shell.faces[worst], shell.inside[worst]);
    if (next < 0)
    {
      ends.push_back(shell.faces[worst]);
      continue;
    }
    shell.Add(next, this->Set.tets[Index(next)]);
  }
  return isFound;
}

double TetCavity::QualityFrom(const Triangle& face, const Vec3& place) const
{
  const auto& p = this->Set.points;
  const double shape = ShapeOfTet(p[Index(face[0])], p[Index(face[2])], p[Index(face[1])], place);
  return this->Set.front == nullptr || !(shape > 0)
           ? shape
           : std::min(shape, this->Set.front->FitOver(face, p, place));
}

/// Every point of the tets must stay on the shell, or it would be lost.
bool TetCavity::KeepsPoints(const Shell& shell) const
{
  const auto isOnShell = [&](Id p)
  {
    return std::any_of(shell.faces.begin(), shell.faces.end(),
                       [&](const Triangle& f) { return f[0] == p || f[1] == p || f[2] == p; });
  };
  return std::all_of(shell.tets.begin(), shell.tets.end(),
                     [&](Id t)
                     {
                       const Tet& tet = this->Set.tets[Index(t)];
                       return std::all_of(tet.begin(), tet.end(), isOnShell);
                     });
}

/// Places to try: the tet's middle, those of its edges and of its neighbours.
std::vector<Vec3> TetCavity::PlacesIn(Id tet) const
{
  const auto& p = this->Set.points;
  const auto middleOf = [&](const Tet& c)
  { return (p[Index(c[0])] + p[Index(c[1])] + p[Index(c[2])] + p[Index(c[3])]) * 0.25; };
  const Tet& own = this->Set.tets[Index(tet)];
  const Vec3 middle = middleOf(own);
  std::vector<Vec3> places{ middle };
  for (std::size_t i = 0; i < 4; ++i)
  {
    for (std::size_t j = i + 1; j < 4; ++j)
    {
      // A little inside the tet: on its edge some faces would be flat.
      places.push_back(0.4 * (p[Index(own[i])] + p[Index(own[j])]) + 0.2 * middle);
    }
    const Id other = this->Across(TetFace(own, i), tet);
    if (other >= 0)
    {
      places.push_back(middleOf(this->Set.tets[Index(other)]));
    }
  }
  return places;
}

TetCavity::Done TetCavity::Insert(Id tet)
{
  const Tet own = this->Set.tets[Index(tet)];
  const auto& p = this->Set.points;
  Change best;
  double gained = LeastGain;
  const Id added = static_cast<Id>(p.size());
  for (const Vec3& start : this->PlacesIn(tet))
  {
    Shell shell;
    if (!this->FindCavity(tet, start, shell))
    {
      continue;
    }
    std::vector<Triangle> order = shell.faces;
    const auto leastAt = [&](const Vec3& place, double enough)
    {
      double least = std::numeric_limits<double>::infinity();
      for (Triangle& f : order)
      {
        least = std::min(least, this->QualityFrom(f, place));
        if (least <= enough)
        {
          std::swap(f, order.front()); // it will often decide again
          break;
        }
      }
      return least;
    };
    Change change;
    change.kind = Done::PointAdded;
    change.place = SearchBest(start, 0.3 * Norm(p[Index(own[0])] - p[Index(own[1])]), leastAt);
    change.quality = leastAt(change.place, -std::numeric_limits<double>::infinity());
    const double gain = change.quality - this->LeastOf(shell.tets);
    const auto isSeen = [&](const Triangle& f)
    { return Orientation(p[Index(f[0])], p[Index(f[2])], p[Index(f[1])], change.place) > 0; };
    if (gain > gained && std::all_of(shell.faces.begin(), shell.faces.end(), isSeen))
    {
      gained = gain;
      for (const Triangle& f : shell.faces)
      {
        change.in.push_back({ { f[0], f[2], f[1], added } });
      }
      change.out = shell.tets;
      best = std::move(change);
    }
  }
  if (best.kind != Done::Nothing)
  {
    this->Apply(best);
  }
  return best.kind;
}

bool TetCavity::MayRemove(Id point, Id into, bool acrossLayers) const
{
  const int layer = this->LayerOf(point);
  return this->Set.fixed[Index(point)] == 0 && this->IsKnown(point) &&
         (acrossLayers || layer < 0 || layer == this->LayerOf(into));
}

TetCavity::Done TetCavity::Collapse(Id tet, bool acrossLayers, std::vector<Id>& taken)
{
  const Tet own = this->Set.tets[Index(tet)];
  Change best;
  double gained = LeastGain;
  Id lost = -1; // a point of a layer
  for (Id from : own)
  {
    for (Id into : own)
    {
      if (from == into || !this->MayRemove(from, into, acrossLayers) || !this->IsInterior(from))
      {
        continue;
      }
      Change change;
      change.kind = Done::PointRemoved;
      change.out = this->TetsOf(from);
      const double before = this->LeastOf(change.out);
      change.quality = std::numeric_limits<double>::infinity();
      for (Id t : change.out)
      {
        Tet moved = this->Set.tets[Index(t)];
        if (Has(moved, into))
        {
          continue;
        }
        std::replace(moved.begin(), moved.end(), from, into);
        const bool isAllowed =
          std::all_of(moved.begin(), moved.end(), [&](Id p) { return this->Allows(p, into); });
        change.quality = isAllowed ? std::min(change.quality, this->Quality(moved)) : -1;
        change.in.push_back(moved);
        if (change.quality <= before + gained)
        {
          break;
        }
      }
      if (change.quality - before > gained && this->IsSound(change.in))
      {
        gained = change.quality - before;
        best = std::move(change);
        lost = this->LayerOf(from) >= 0 && this->LayerOf(from) != this->LayerOf(into) ? from : -1;
      }
    }
  }
  if (best.kind != Done::Nothing)
  {
    this->Apply(best);
    taken.insert(taken.end(), lost >= 0 ? 1 : 0, lost);
  }
  return best.kind;
}

} // namespace lamina
