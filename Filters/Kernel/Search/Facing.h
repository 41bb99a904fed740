// SPDX-License-Identifier: BSD-3-Clause
// When two triangles that come near bound a gap, and when they only meet around a corner.
#pragma once

#include "../Mesh/TriangleComplex.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

namespace lamina
{

/// The material on the side of a triangle that a connection leaves by. `along`: what the connection goes in
/// the direction of the normal. Two triangles that see each other through one material have the same one on
/// these sides; where they differ, another sheet lies between, and the gaps are those to it.
inline int MaterialTowards(const MaterialPair& pair, double along)
{
  return along > 0 ? pair.second : pair.first;
}

/// Sheets that meet at a curve come arbitrarily near to each other there, and what is watched is their angle.
/// A way along the surface of at most so many of their distances joins their places if they meet at 20
/// degrees or more. What bounds a gap of a quarter voxel is no nearer by way: a slot only one voxel deep
/// makes it nine.
constexpr double shortWay = 6;

/// Whether a way along edges of the surface, of at most `most`, leads from a place on triangle s to a place
/// on triangle t. `at(p)`: where point p is; `visitRing(p, visit)` calls visit(q) for the points around p.
template<typename At, typename VisitRing>
bool AreJoined(const Vec3& from, const Triangle& s, const Vec3& to, const Triangle& t, double most, At&& at,
               VisitRing&& visitRing)
{
  // The shortest way, counted with what is left as the crow flies: few points are looked at.
  using Reached = std::pair<double, Id>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> reached;
  std::unordered_map<Id, double> ways;
  const auto reach = [&](Id p, double way)
  {
    const double whole = way + Norm(at(p) - to);
    if (whole > most)
    {
      return;
    }
    const auto known = ways.emplace(p, way);
    if (known.second || way < known.first->second)
    {
      known.first->second = way;
      reached.push({ whole, p });
    }
  };
  for (Id p : s)
  {
    reach(p, Norm(at(p) - from));
  }
  while (!reached.empty())
  {
    const Id p = reached.top().second;
    reached.pop();
    if (std::find(t.begin(), t.end(), p) != t.end())
    {
      return true;
    }
    const double way = ways.at(p);
    visitRing(p, [&](Id q) { reach(q, way + Norm(at(q) - at(p))); });
  }
  return false;
}

} // namespace lamina
