// SPDX-License-Identifier: BSD-3-Clause
// Edits that would bring sheets near to each other, or fold triangles onto their neighbours.
#include "../Mesh/EdgeAngles.h"
#include "../Search/Clearance.h"
#include "EditCorners.h"
#include "EditableSurface.h"
#include "GapFloors.h"

#include <algorithm>
#include <cmath>

namespace lamina
{

namespace
{

constexpr double facingCosine = 0.7071; ///< of a normal and a connection: 45 degrees
constexpr double rounding = 1e-9;
constexpr double degree = 3.141592653589793 / 180;

using Places = std::array<Vec3, 3>;

/// False if no connection of the two leaves the first within 45 degrees of its normal: it would have to rise
/// at least as much as it goes aside, but seen along the normal an edge parts the two by more than they rise.
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
    if (aside > 0 && aside * aside > (1 + 1e-3) * rise * rise * Norm2(edge))
    {
      return false;
    }
  }
  return true;
}

} // namespace

/// The triangles, which share no corner, do not face each other nearer than sheets may come there.
bool EditableSurface::StaysApart(const Added& added, Id other) const
{
  const Triangle& c = added.corners;
  const Triangle& d = this->Corners(other);
  const Places own{ { this->Point(c[0]), this->Point(c[1]), this->Point(c[2]) } };
  const Places theirs{ { this->Point(d[0]), this->Point(d[1]), this->Point(d[2]) } };
  const Vec3& normal = this->Normals[U(other)];
  if (!MayFace(own, added.normal, theirs) || !MayFace(theirs, normal, own))
  {
    return true;
  }
  const auto floorAt = [&](int sheet, const Vec3& place)
  { return this->Input.GapFloor(this->Input.ClosestOnSheet(sheet, place, this->Input.WidestTolerance())); };
  const double widest = this->Input.WidestGapFloor();
  return AllOfConnections(own, theirs,
                          [&](const Vec3& from, const Vec3& to)
                          {
                            const Vec3 connection = from - to;
                            const double gap = Norm(connection);
                            const auto leaves = [&](const Vec3& n)
                            { return std::abs(Dot(connection, n)) >= facingCosine * gap; };
                            return gap >= widest || !leaves(added.normal) || !leaves(normal) ||
                                   gap >= (1 - rounding) * std::min(floorAt(added.sheet, from),
                                                                    floorAt(this->Sheets[U(other)], to));
                          });
}

/// The greatest cosine of the angles that a triangle forms at its edges with `others`, seen with the points
/// where `at` says. `all`: also at edges within a sheet.
template<typename At>
double EditableSurface::GreatestCosine(const Triangle& corners, const std::vector<Triangle>& others, bool all,
                                       At&& at) const
{
  double greatest = -1;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Id a = corners[k];
    const Id b = corners[(k + 1) % 3];
    if (!all && (this->Classes[U(a)] == OnSheet || this->Classes[U(b)] == OnSheet))
    {
      continue;
    }
    const Vec3 own = DirectionFromEdge(at(a), at(b), at(corners[(k + 2) % 3]));
    for (const Triangle& other : others)
    {
      if (Has(other, a) && Has(other, b) && !Has(other, corners[(k + 2) % 3]))
      {
        greatest = std::max(greatest, Dot(own, DirectionFromEdge(at(a), at(b), at(Third(other, a, b)))));
      }
    }
  }
  return greatest;
}

/// No two triangles come to stand at a sharper angle than they may, or than some stood before. Within a sheet
/// a direction that sees all faces at an end of the edge keeps them apart anyway.
bool EditableSurface::OpensWide(const Edit& edit, bool allVisible) const
{
  const auto isOnCurve = [&](const Added& t)
  {
    return std::count_if(t.corners.begin(), t.corners.end(),
                         [&](Id p) { return this->Classes[U(p)] != OnSheet; }) > 1;
  };
  if (allVisible && std::none_of(edit.added.begin(), edit.added.end(), isOnCurve))
  {
    return true;
  }
  std::vector<Triangle> added;
  std::vector<Triangle> removed;
  std::vector<Triangle> around;
  for (const Added& t : edit.added)
  {
    added.push_back(t.corners);
  }
  for (Id t : edit.removed)
  {
    removed.push_back(this->Corners(t));
    for (Id p : this->Corners(t))
    {
      for (Id s : this->Star(p))
      {
        if (!std::binary_search(edit.removed.begin(), edit.removed.end(), s))
        {
          around.push_back(this->Corners(s));
        }
      }
    }
  }
  const auto greatest = [&](std::vector<Triangle>& triangles, const auto& at)
  {
    double cosine = -1;
    const std::size_t own = triangles.size();
    triangles.insert(triangles.end(), around.begin(), around.end());
    for (std::size_t i = 0; i < own; ++i)
    {
      cosine = std::max(cosine, this->GreatestCosine(triangles[i], triangles, !allVisible, at));
    }
    return cosine;
  };
  const double now = greatest(added, [&](Id p) { return this->Point(p); });
  return now <= std::cos(LeastFold * degree) ||
         now <= greatest(removed, [&](Id p) { return p == edit.moved ? edit.from : this->Point(p); });
}

} // namespace lamina
