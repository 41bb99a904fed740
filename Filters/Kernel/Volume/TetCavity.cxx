// SPDX-License-Identifier: BSD-3-Clause
#include "TetCavity.h"

#include "../Geometry/Predicates.h"
#include "../Geometry/Quality.h"
#include "../Mesh/TetFaces.h"

#include <algorithm>
#include <limits>

namespace lamina
{
namespace
{

/// Longest ring of tets round an edge that is looked at: longer ones are seldom bettered.
constexpr std::size_t LongestRing = 8;
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

TetCavity::TetCavity(TetSet& set, const std::vector<Id>& around)
  : Set(set)
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
  const auto& p = this->Set.points;
  return ShapeOfTet(p[Index(c[0])], p[Index(c[1])], p[Index(c[2])], p[Index(c[3])]);
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

void TetCavity::FlipFace(Id tet, std::size_t opposite, Change& best) const
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
    if (change.quality > std::max(best.quality, this->LeastOf(change.out) + LeastGain) &&
        this->IsSound(change.in))
    {
      best = std::move(change);
    }
    return;
  }
}

bool TetCavity::FindRing(Id a, Id b, int group, std::vector<Id>& out, std::vector<Id>& ring) const
{
  // Each tet on the edge a-b gives a step x -> y of the ring such that (a, b, x, y) is positive.
  std::vector<std::array<Id, 2>> steps;
  for (Id t : this->TetsOf(a))
  {
    const Tet& tet = this->Set.tets[Index(t)];
    if (!Has(tet, b))
    {
      continue;
    }
    if (this->Set.groups[Index(t)] != group || steps.size() == LongestRing)
    {
      return false;
    }
    const std::size_t i = Index(std::find(tet.begin(), tet.end(), a) - tet.begin());
    const Triangle face = TetFace(tet, i); // turns clockwise seen from a
    const std::size_t k = face[0] == b ? 0 : (face[1] == b ? 1 : 2);
    steps.push_back({ { face[(k + 1) % 3], face[(k + 2) % 3] } });
    out.push_back(t);
  }
  ring.assign(1, steps.front()[0]);
  while (ring.size() <= steps.size())
  {
    const auto step =
      std::find_if(steps.begin(), steps.end(), [&](const auto& s) { return s[0] == ring.back(); });
    if (step == steps.end())
    {
      return false; // the edge lies on the boundary
    }
    if ((*step)[1] == ring.front())
    {
      return ring.size() == steps.size();
    }
    ring.push_back((*step)[1]);
  }
  return false;
}

double TetCavity::Triangulate(const std::vector<Id>& ring, Id a, Id b, double floor,
                              std::vector<Tet>& in) const
{
  // least[i][j] is the best that the polygon from i to j of the ring can have, each of its triangles carrying
  // a tet to either end of the edge.
  const std::size_t n = ring.size();
  std::array<std::array<double, LongestRing>, LongestRing> least;
  std::array<std::array<std::size_t, LongestRing>, LongestRing> middle{};
  const auto tetsOn = [&](std::size_t i, std::size_t k, std::size_t j)
  {
    return std::array<Tet, 2>{ { { { ring[i], ring[k], ring[j], b } },
                                 { { ring[j], ring[k], ring[i], a } } } };
  };
  for (std::size_t span = 1; span < n; ++span)
  {
    for (std::size_t i = 0; i + span < n; ++i)
    {
      const std::size_t j = i + span;
      const bool isNew = span > 1 && span < n - 1;
      const bool isAllowed = !isNew || this->Allows(ring[i], ring[j]);
      least[i][j] = span == 1 ? 1 : -1;
      for (std::size_t k = i + 1; k < j && isAllowed; ++k)
      {
        const double below = std::min(least[i][k], least[k][j]);
        if (below <= std::max(floor, least[i][j]))
        {
          continue;
        }
        const auto pair = tetsOn(i, k, j);
        const double quality = std::min({ below, this->Quality(pair[0]), this->Quality(pair[1]) });
        if (quality > least[i][j])
        {
          least[i][j] = quality;
          middle[i][j] = k;
        }
      }
    }
  }
  std::vector<std::array<std::size_t, 2>> open{ { { 0, n - 1 } } };
  while (!open.empty() && least[0][n - 1] > floor)
  {
    const auto [i, j] = open.back();
    open.pop_back();
    if (j - i > 1)
    {
      const std::size_t k = middle[i][j];
      const auto pair = tetsOn(i, k, j);
      in.insert(in.end(), pair.begin(), pair.end());
      open.push_back({ { i, k } });
      open.push_back({ { k, j } });
    }
  }
  return least[0][n - 1];
}

void TetCavity::RemoveEdge(Id tet, Id a, Id b, Change& best) const
{
  Change change;
  std::vector<Id> ring;
  if (!this->IsKnown(a) || !this->FindRing(a, b, this->Set.groups[Index(tet)], change.out, ring) ||
      ring.size() < 3)
  {
    return;
  }
  const double floor = std::max(best.quality, this->LeastOf(change.out) + LeastGain);
  change.quality = this->Triangulate(ring, a, b, floor, change.in);
  if (change.quality > floor && this->IsSound(change.in))
  {
    change.kind = Done::EdgeRemoved;
    best = std::move(change);
  }
}

} // namespace lamina
