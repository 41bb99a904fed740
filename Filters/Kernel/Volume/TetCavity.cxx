// SPDX-License-Identifier: BSD-3-Clause
#include "TetCavity.h"

#include "FrontCells.h"

#include "../Geometry/Predicates.h"
#include "../Geometry/Quality.h"
#include "../Mesh/TetFaces.h"

#include <algorithm>
#include <limits>

namespace lamina
{
namespace
{

/// A change must be worth its while: this keeps rounding from driving it round in circles.
constexpr double LeastGain = 1e-6;

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

bool Has(const TetCavity::Tet& tet, Id point)
{
  return std::find(tet.begin(), tet.end(), point) != tet.end();
}

} // namespace

double ShapeOfTet(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  constexpr double sineWeight = 1.44;
  return std::min(TetQuality(a, b, c, d), sineWeight * TetLeastSine(a, b, c, d));
}

double WorthOfTet(const TetSet& set, const std::array<Id, 4>& c)
{
  const auto& p = set.points;
  const double shape = ShapeOfTet(p[Index(c[0])], p[Index(c[1])], p[Index(c[2])], p[Index(c[3])]);
  return set.front == nullptr || !(shape > 0) ? shape : std::min(shape, set.front->FitOf(c, p));
}

void DropReplaced(TetSet& set)
{
  std::size_t to = 0;
  for (std::size_t from = 0; from < set.tets.size(); ++from)
  {
    if (set.tets[from][0] >= 0)
    {
      set.tets[to] = set.tets[from];
      set.groups[to] = set.groups[from];
      ++to;
    }
  }
  set.tets.resize(to);
  set.groups.resize(to);
}

TetCavity::TetCavity(TetSet& set, const std::vector<Id>& around, ChangeClock* clock)
  : Set(set)
  , Clock(clock)
  , Slot(set.points.size(), -1)
{
  for (Id t : around)
  {
    for (Id p : set.tets[Index(t)])
    {
      if (this->Slot[Index(p)] < 0)
      {
        this->Slot[Index(p)] = static_cast<Id>(this->Stars.size());
        this->Stars.emplace_back();
      }
    }
  }
  for (std::size_t t = 0; t < set.tets.size(); ++t)
  {
    for (Id p : set.tets[t])
    {
      if (this->IsKnown(p))
      {
        this->Stars[Index(this->Slot[Index(p)])].push_back(static_cast<Id>(t));
      }
    }
  }
}

bool TetCavity::IsKnown(Id point) const
{
  return this->Slot[Index(point)] >= 0;
}

const std::vector<Id>& TetCavity::TetsOf(Id point) const
{
  return this->Stars[Index(this->Slot[Index(point)])];
}

double TetCavity::Quality(const Tet& c) const
{
  return WorthOfTet(this->Set, c);
}

double TetCavity::LeastOf(const std::vector<Id>& tets) const
{
  double least = std::numeric_limits<double>::infinity();
  for (Id t : tets)
  {
    least = std::min(least, this->Quality(this->Set.tets[Index(t)]));
  }
  return least;
}

double TetCavity::LeastOf(std::vector<Id>& tets, double enough) const
{
  double least = std::numeric_limits<double>::infinity();
  for (Id& t : tets)
  {
    least = std::min(least, this->Quality(this->Set.tets[Index(t)]));
    if (least <= enough)
    {
      std::swap(t, tets.front());
      break;
    }
  }
  return least;
}

bool TetCavity::IsSound(const std::vector<Tet>& tets) const
{
  const auto& p = this->Set.points;
  return std::all_of(tets.begin(), tets.end(),
                     [&](const Tet& c) {
                       return Orientation(p[Index(c[0])], p[Index(c[1])], p[Index(c[2])], p[Index(c[3])]) > 0;
                     });
}

bool TetCavity::Allows(Id a, Id b) const
{
  if (this->Set.layerIndex.empty())
  {
    return true;
  }
  const int i = this->Set.layerIndex[Index(a)];
  const int j = this->Set.layerIndex[Index(b)];
  return i < 0 || j < 0 || std::abs(i - j) <= 1;
}

TetCavity::Done TetCavity::Reconnect(Id tet)
{
  const Tet own = this->Set.tets[Index(tet)];
  Change best;
  for (std::size_t i = 0; i < 4; ++i)
  {
    for (std::size_t j = i + 1; j < 4; ++j)
    {
      this->RemoveEdge(tet, own[i], own[j], best);
    }
    this->FlipFace(tet, i, best);
  }
  if (best.kind != Done::Nothing)
  {
    this->Apply(best);
  }
  return best.kind;
}

void TetCavity::Apply(const Change& change)
{
  const int group = this->Set.groups[Index(change.out.front())];
  if (change.kind == Done::PointAdded)
  {
    this->Set.points.push_back(change.place);
    this->Set.fixed.push_back(0);
    if (!this->Set.layerIndex.empty())
    {
      this->Set.layerIndex.push_back(-1);
    }
    this->Slot.push_back(static_cast<Id>(this->Stars.size()));
    this->Stars.emplace_back();
  }
  for (Id t : change.out)
  {
    if (this->Clock != nullptr)
    {
      this->Clock->Mark(this->Set.tets[Index(t)]);
    }
    for (Id p : this->Set.tets[Index(t)])
    {
      if (this->IsKnown(p))
      {
        auto& star = this->Stars[Index(this->Slot[Index(p)])];
        star.erase(std::find(star.begin(), star.end(), t));
      }
    }
    this->Set.tets[Index(t)][0] = -1;
  }
  for (const Tet& tet : change.in)
  {
    if (this->Clock != nullptr)
    {
      this->Clock->Mark(tet);
    }
    for (Id p : tet)
    {
      if (this->IsKnown(p))
      {
        this->Stars[Index(this->Slot[Index(p)])].push_back(static_cast<Id>(this->Set.tets.size()));
      }
    }
    this->Set.tets.push_back(tet);
    this->Set.groups.push_back(group);
  }
}

void TetCavity::FlipFace(Id tet, std::size_t opposite, Change& best, double enough) const
{
  // Two tets on a face (a, b, c) with apices d and e become three round the edge (d, e).
  const Tet& own = this->Set.tets[Index(tet)];
  const Triangle face = TetFace(own, opposite);
  const Id d = own[opposite];
  if (!this->IsKnown(face[0]))
  {
    return;
  }
  for (Id t : this->TetsOf(face[0]))
  {
    const Tet& other = this->Set.tets[Index(t)];
    if (t == tet || !Has(other, face[1]) || !Has(other, face[2]))
    {
      continue;
    }
    const Id e = *std::find_if(other.begin(), other.end(),
                               [&](Id p) { return p != face[0] && p != face[1] && p != face[2]; });
    if (this->Set.groups[Index(t)] != this->Set.groups[Index(tet)] || !this->Allows(d, e))
    {
      return;
    }
    Change change{ { tet, t }, {}, std::numeric_limits<double>::infinity(), Done::FaceFlipped, {} };
    for (std::size_t k = 0; k < 3; ++k)
    {
      // The face turns counter-clockwise seen from e.
      change.in.push_back({ { face[(k + 1) % 3], face[k], e, d } });
      change.quality = std::min(change.quality, this->Quality(change.in.back()));
    }
    const double asked = std::min(enough, this->LeastOf(change.out) + LeastGain);
    if (change.quality > std::max(best.quality, asked) && this->IsSound(change.in))
    {
      best = std::move(change);
    }
    return;
  }
}

} // namespace lamina
