// SPDX-License-Identifier: BSD-3-Clause
// Edits that would bring sheets near to each other, or fold triangles onto their neighbours.
#include "../Mesh/EdgeAngles.h"
#include "../Search/Facing.h"
#include "EditCorners.h"
#include "EditableSurface.h"
#include "FacingPairs.h"

#include <algorithm>

namespace lamina
{

/// The triangles, which share no corner, do not face each other too near.
bool EditableSurface::StaysApart(const Added& added, Id other, double leastGap) const
{
  const auto facet = [this](const Triangle& c, const Vec3& normal, int sheet)
  {
    return Facet{ { { this->Point(c[0]), this->Point(c[1]), this->Point(c[2]) } },
                  normal,
                  sheet,
                  this->Input.Surface().materials[U(this->PairOfSheet[U(sheet)])] };
  };
  const auto visitRing = [this](Id p, const auto& visit)
  {
    for (const Id t : this->Star(p))
    {
      std::for_each(this->Corners(t).begin(), this->Corners(t).end(), visit);
    }
  };
  const auto isJoined = [&](const Vec3& from, const Vec3& to, double most)
  {
    return AreJoined(
      from, added.corners, to, this->Corners(other), most, [this](Id p) { return this->Point(p); },
      visitRing);
  };
  return StayApart(facet(added.corners, added.normal, added.sheet),
                   facet(this->Corners(other), this->Normals[U(other)], this->Sheets[U(other)]), leastGap,
                   InputSurface::ShareOfGap, this->Input, isJoined);
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
  return now <= foldCosine ||
         now <= greatest(removed, [&](Id p) { return p == edit.moved ? edit.from : this->Point(p); });
}

} // namespace lamina
