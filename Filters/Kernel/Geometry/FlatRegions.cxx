// SPDX-License-Identifier: BSD-3-Clause
#include "FlatTriangulation.h"

#include <algorithm>
#include <map>
#include <set>

namespace lamina
{
namespace
{

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

/// How far one has to turn clockwise from the way back to a place's other edge: above 0, at most a full turn.
double ClockwiseTurn(const Vec2& at, const Vec2& back, const Vec2& on)
{
  constexpr double full = 6.283185307179586;
  const double turn = std::atan2(back.y - at.y, back.x - at.x) - std::atan2(on.y - at.y, on.x - at.x);
  return turn > 0 ? turn : turn + full;
}

/// Rings along the edges, at each place by the first way to the left.
std::vector<std::vector<Id>> TraceRings(const std::vector<Vec2>& places, const PlaneEdges& edges)
{
  std::multimap<Id, std::size_t> leaving;
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    leaving.emplace(edges[e][0], e);
  }
  std::vector<char> used(edges.size(), 0);
  std::vector<std::vector<Id>> rings;
  for (std::size_t first = 0; first < edges.size(); ++first)
  {
    if (used[first])
    {
      continue;
    }
    rings.emplace_back();
    for (std::size_t e = first;;)
    {
      used[e] = 1;
      rings.back().push_back(edges[e][0]);
      const auto range = leaving.equal_range(edges[e][1]);
      std::size_t next = edges.size();
      double least = 0;
      for (auto at = range.first; at != range.second; ++at)
      {
        const double turn = ClockwiseTurn(places[Index(edges[e][1])], places[Index(edges[e][0])],
                                          places[Index(edges[at->second][1])]);
        if (next == edges.size() || turn < least)
        {
          next = at->second;
          least = turn;
        }
      }
      if (next == first)
      {
        break;
      }
      if (next == edges.size() || used[next])
      {
        return {};
      }
      e = next;
    }
  }
  return rings;
}

bool IsInside(const std::vector<Vec2>& places, const std::vector<Id>& ring, const Vec2& p)
{
  bool inside = false;
  for (std::size_t k = 0; k < ring.size(); ++k)
  {
    const Vec2& a = places[Index(ring[k])];
    const Vec2& b = places[Index(ring[(k + 1) % ring.size()])];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y))
    {
      inside = !inside;
    }
  }
  return inside;
}

} // namespace

double AreaOf(const std::vector<Vec2>& places, const std::vector<Id>& ring)
{
  double twice = 0;
  const Vec2& o = places[Index(ring[0])];
  for (std::size_t k = 1; k + 1 < ring.size(); ++k)
  {
    const Vec2& a = places[Index(ring[k])];
    const Vec2& b = places[Index(ring[k + 1])];
    twice += (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
  }
  return 0.5 * twice;
}

std::vector<FlatRegion> FindFlatRegions(const std::vector<Vec2>& places, const PlaneEdges& edges)
{
  const std::set<std::array<Id, 2>> all(edges.begin(), edges.end());
  const auto runsBothWays = [&](const std::array<Id, 2>& e) { return all.count({ { e[1], e[0] } }) != 0; };
  if (all.size() != edges.size() || std::any_of(edges.begin(), edges.end(), runsBothWays))
  {
    return {};
  }
  std::vector<FlatRegion> regions;
  std::vector<std::vector<Id>> holes;
  for (std::vector<Id>& ring : TraceRings(places, edges))
  {
    if (AreaOf(places, ring) > 0)
    {
      regions.push_back({ std::move(ring), {} });
    }
    else
    {
      holes.push_back(std::move(ring));
    }
  }
  for (std::vector<Id>& hole : holes)
  {
    // The smallest rim around it. A hole may touch the rim in a place of its own, but in no edge.
    const Vec2& a = places[Index(hole[0])];
    const Vec2& b = places[Index(hole[1])];
    const Vec2 middle{ 0.5 * (a.x + b.x), 0.5 * (a.y + b.y) };
    FlatRegion* best = nullptr;
    for (FlatRegion& region : regions)
    {
      if (IsInside(places, region.rim, middle) &&
          (best == nullptr || AreaOf(places, region.rim) < AreaOf(places, best->rim)))
      {
        best = &region;
      }
    }
    if (best == nullptr)
    {
      return {};
    }
    best->holes.push_back(std::move(hole));
  }
  return regions;
}

} // namespace lamina
