// SPDX-License-Identifier: BSD-3-Clause
#include "FacingPairs.h"

#include "../Search/Clearance.h"
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

} // namespace

bool StayApart(const Facet& s, const Facet& t, double leastGap, double share, const InputSurface& input)
{
  if (!MayFace(s.corners, s.normal, t.corners) || !MayFace(t.corners, t.normal, s.corners))
  {
    return true;
  }
  const auto isWide = [&](const Vec3& from, const Vec3& to)
  {
    const Vec3 connection = from - to;
    const double gap = Norm(connection);
    const auto leaves = [&](const Vec3& n) { return std::abs(Dot(connection, n)) >= facingCosine * gap; };
    return gap >= leastGap || !leaves(s.normal) || !leaves(t.normal) ||
           gap >= (1 - rounding) * share * Norm(input.Origin(s.sheet, from) - input.Origin(t.sheet, to));
  };
  return AllOfConnections(s.corners, t.corners, isWide);
}

std::vector<Id> FindNarrow(const TriangleComplex& surface, const SheetGraph& sheets,
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
                  sheets.sheetOfTriangle[U(t)] };
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
                       isNarrow[U(t)] = !Has(d, c[0]) && !Has(d, c[1]) && !Has(d, c[2]) &&
                                        !StayApart(own, facet(other), gap, keptShare, input);
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
  std::vector<Id> narrow;
  for (std::size_t t = 0; t < isNarrow.size(); ++t)
  {
    if (isNarrow[t])
    {
      narrow.push_back(static_cast<Id>(t));
    }
  }
  return narrow;
}

} // namespace lamina
