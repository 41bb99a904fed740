// SPDX-License-Identifier: BSD-3-Clause
#include "FacingPairs.h"

#include "../Mesh/EdgeAngles.h"
#include "../Search/Clearance.h"
#include "../Search/Facing.h"
#include "EditCorners.h"

#include <algorithm>
#include <cmath>

namespace lamina
{

namespace
{

/// Of a normal and a connection: 60 degrees. What is promised, of 45, holds after bisections too, which
/// nobody asks about.
constexpr double facingCosine = 0.5;
constexpr double facingTangent2 = 3;
/// Over the distance: a way that still joins two places, by what is promised (shortWay), when edits elsewhere
/// have made it longer.
constexpr double shorterWay = 4;
constexpr double rounding = 1e-9;
/// Of the gaps that edits leave, and of what lay between the places in the input, what corrections may leave.
constexpr double keptGap = 0.97;
constexpr double keptShare = 0.5;

using Places = std::array<Vec3, 3>;

/// False if no connection of the two leaves the first near to its normal: it would have to rise by a share of
/// what it goes aside, but seen along the normal an edge parts the two by more.
bool MayFace(const Places& own, const Vec3& normal, const Places& theirs)
{
  double rise = 0;
  for (const Vec3& x : theirs)
  {
    rise = std::max(rise, std::abs(Dot(x - own[0], normal)));
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vec3 edge = own[(k + 1) % 3] - own[k];
    const Vec3 outwards = Cross(edge, normal);
    double aside = std::min({ Dot(theirs[0] - own[k], outwards), Dot(theirs[1] - own[k], outwards),
                              Dot(theirs[2] - own[k], outwards) });
    if (aside > 0 && aside * aside > (1 + 1e-3) * facingTangent2 * rise * rise * Norm2(edge))
    {
      return false;
    }
  }
  return true;
}

std::vector<Id> Marked(const std::vector<char>& marks)
{
  std::vector<Id> marked;
  for (std::size_t i = 0; i < marks.size(); ++i)
  {
    if (marks[i])
    {
      marked.push_back(static_cast<Id>(i));
    }
  }
  return marked;
}

} // namespace

bool StayApart(const Facet& s, const Facet& t, double leastGap, double share, const InputSurface& input,
               const IsJoined& isJoined)
{
  if (!MayFace(s.corners, s.normal, t.corners) || !MayFace(t.corners, t.normal, s.corners))
  {
    return true;
  }
  const auto isWide = [&](const Vec3& from, const Vec3& to)
  {
    const Vec3 connection = from - to;
    const double gap = Norm(connection);
    const double own = Dot(connection, s.normal);
    const double other = Dot(connection, t.normal);
    return gap >= leastGap || std::abs(own) < facingCosine * gap || std::abs(other) < facingCosine * gap ||
           MaterialTowards(s.pair, -own) != MaterialTowards(t.pair, other) ||
           gap >= (1 - rounding) * share * Norm(input.Origin(s.sheet, from) - input.Origin(t.sheet, to)) ||
           isJoined(from, to, shorterWay * gap);
  };
  return AllOfConnections(s.corners, t.corners, isWide);
}

std::vector<Id> FindNarrow(const TriangleComplex& surface, const Lists& star, const SheetGraph& sheets,
                           const InputSurface& input, Monitor& monitor)
{
  if (!input.KeepsGaps())
  {
    return {};
  }
  const TriangleTree tree(surface.points, surface.triangles);
  const auto facet = [&](Id t)
  {
    const Triangle& c = surface.triangles[U(t)];
    return Facet{ { { surface.points[U(c[0])], surface.points[U(c[1])], surface.points[U(c[2])] } },
                  Normalized(AreaVector2(surface.points, c)),
                  sheets.sheetOfTriangle[U(t)],
                  surface.materials[U(t)] };
  };
  const auto visitRing = [&](Id p, const auto& visit)
  {
    for (const Id t : Row(star, p))
    {
      std::for_each(surface.triangles[U(t)].begin(), surface.triangles[U(t)].end(), visit);
    }
  };
  std::vector<char> isNarrow(surface.triangles.size(), 0);
  const auto look = [&](Id t)
  {
    const Triangle& c = surface.triangles[U(t)];
    const Facet own = facet(t);
    Box box;
    double target = surface.targetEdgeLength[U(c[0])];
    for (std::size_t k = 0; k < 3; ++k)
    {
      box.Add(own.corners[k]);
      target = std::min(target, surface.targetEdgeLength[U(c[k])]);
    }
    const double gap = keptGap * input.LeastGap(target);
    box.Grow(gap);
    tree.ForOverlaps(box,
                     [&](Id other)
                     {
                       const Triangle& d = surface.triangles[U(other)];
                       const auto isJoined = [&](const Vec3& from, const Vec3& to, double most)
                       {
                         return AreJoined(
                           from, c, to, d, most, [&](Id p) { return surface.points[U(p)]; }, visitRing);
                       };
                       isNarrow[U(t)] =
                         !ShareCorner(c, d) && !StayApart(own, facet(other), gap, keptShare, input, isJoined);
                       return !isNarrow[U(t)];
                     });
  };
  monitor.For(static_cast<Id>(isNarrow.size()), 1024,
              [&](Id begin, Id end)
              {
                for (Id t = begin; t < end; ++t)
                {
                  look(t);
                }
              });
  return Marked(isNarrow);
}

std::vector<Id> FindFolds(const TriangleComplex& surface, const std::vector<Vec3>& before,
                          const EdgeTable& edges, Monitor& monitor)
{
  std::vector<char> isFolded(edges.edges.size(), 0);
  const auto look = [&](Id e)
  {
    const Edge& edge = edges.edges[U(e)];
    const ListRow row = Row(edges.triangles, e);
    for (const Id* s = row.first; s != row.last; ++s)
    {
      for (const Id* t = s + 1; t != row.last; ++t)
      {
        const double now = CosineAtEdge(surface.points, surface.triangles, edge, *s, *t);
        isFolded[U(e)] =
          isFolded[U(e)] ||
          (now > foldCosine && now > rounding + CosineAtEdge(before, surface.triangles, edge, *s, *t));
      }
    }
  };
  monitor.For(static_cast<Id>(isFolded.size()), 4096,
              [&](Id begin, Id end)
              {
                for (Id e = begin; e < end; ++e)
                {
                  look(e);
                }
              });
  std::vector<Id> folded;
  for (const Id e : Marked(isFolded))
  {
    const ListRow row = Row(edges.triangles, e);
    folded.insert(folded.end(), row.begin(), row.end());
  }
  std::sort(folded.begin(), folded.end());
  folded.erase(std::unique(folded.begin(), folded.end()), folded.end());
  return folded;
}

} // namespace lamina
