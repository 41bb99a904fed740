// SPDX-License-Identifier: BSD-3-Clause
// The removal of edges; the rest of the reconnections is in TetCavity.cxx.
#include "TetCavity.h"

#include "../Mesh/TetFaces.h"

#include <algorithm>

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

void TetCavity::RemoveEdge(Id tet, Id a, Id b, Change& best, double enough) const
{
  Change change;
  std::vector<Id> ring;
  if (!this->IsKnown(a) || !this->FindRing(a, b, this->Set.groups[Index(tet)], change.out, ring) ||
      ring.size() < 3)
  {
    return;
  }
  const double floor = std::max(best.quality, std::min(enough, this->LeastOf(change.out) + LeastGain));
  change.quality = this->Triangulate(ring, a, b, floor, change.in);
  if (change.quality > floor && this->IsSound(change.in))
  {
    change.kind = Done::EdgeRemoved;
    best = std::move(change);
  }
}

} // namespace lamina
