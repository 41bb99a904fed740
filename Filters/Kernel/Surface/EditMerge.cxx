// SPDX-License-Identifier: BSD-3-Clause
// Merging the ends of an edge.
#include "EditCorners.h"
#include "EditableSurface.h"

#include <algorithm>

namespace lamina
{

/// The link condition: the ends share no neighbour but the far corners of the edge's triangles, and no
/// triangle would come to lie on another.
bool EditableSurface::LinkAllows(Id gone, Id kept, const EdgeTriangles& shared) const
{
  std::vector<Id> ringOfKept;
  for (Id t : this->Star(kept))
  {
    for (Id p : this->Corners(t))
    {
      ringOfKept.push_back(p);
    }
  }
  std::sort(ringOfKept.begin(), ringOfKept.end());
  for (Id t : this->Star(gone))
  {
    const std::array<Id, 2> others = Others(this->Corners(t), gone);
    for (Id p : others)
    {
      if (p == kept || !std::binary_search(ringOfKept.begin(), ringOfKept.end(), p))
      {
        continue;
      }
      if (std::none_of(shared.begin(), shared.end(), [&](Id s) { return Has(this->Corners(s), p); }))
      {
        return false;
      }
    }
    if (!Has(this->Corners(t), kept))
    {
      for (Id s : this->Star(kept))
      {
        if (Has(this->Corners(s), others[0]) && Has(this->Corners(s), others[1]))
        {
          return false;
        }
      }
    }
  }
  return true;
}

/// The middle of the edge, moved along the fan's gradient so that the volume on either side stays what it
/// was.
Vec3 EditableSurface::MergedPlace(Id gone, Id kept, const EdgeTriangles& shared) const
{
  const Vec3 origin = this->Point(kept);
  const Vec3 middle = 0.5 * (this->Point(gone) - origin);
  Vec3 gradient;
  double six = 0;
  const auto add = [&](Id t, Id p)
  {
    const std::array<Id, 2> o = Others(this->Corners(t), p);
    const Vec3 area = Cross(this->Point(o[0]) - origin, this->Point(o[1]) - origin);
    six += Dot(this->Point(p) - origin, area);
    if (std::find(shared.begin(), shared.end(), t) == shared.end())
    {
      gradient += area;
    }
  };
  for (Id t : this->Star(gone))
  {
    add(t, gone);
  }
  for (Id t : this->Star(kept))
  {
    if (!Has(this->Corners(t), gone))
    {
      add(t, kept);
    }
  }
  const double g2 = Norm2(gradient);
  if (g2 > 0)
  {
    const Vec3 correction = ((six - Dot(middle, gradient)) / g2) * gradient;
    if (Norm2(correction) < Norm2(middle))
    {
      return origin + middle + correction;
    }
  }
  return origin + middle;
}

bool EditableSurface::Merge(Id a, Id b, bool anyLength)
{
  this->PlanMerge(a, b, anyLength, this->Work);
  return this->CarryOut(this->Work);
}

void EditableSurface::PlanMerge(Id a, Id b, bool anyLength, EditPlan& plan)
{
  plan.isSound = false;
  const EdgeTriangles shared = this->TrianglesAt(a, b);
  if (shared.empty())
  {
    return;
  }
  Class ca = this->Classes[U(a)];
  Class cb = this->Classes[U(b)];
  if (ca > cb || (ca == cb && a < b))
  {
    std::swap(a, b); // a goes, b stays: the one with less freedom, among equals the older
    std::swap(ca, cb);
  }
  const bool feature = this->IsFeature(shared);
  if (ca == AtCorner || (ca == OnCurve && !feature) || !this->LinkAllows(a, b, shared))
  {
    return;
  }
  const Vec3 end = this->Point(b);
  Vec3 place = end;
  if (ca == cb)
  {
    place = ca == OnSheet ? this->MergedPlace(a, b, shared) : 0.5 * (this->Point(a) + end);
  }
  this->PlanMergeInto(a, b, shared, place, anyLength, plan);
  if (ca == cb && !plan.isSound)
  {
    this->PlanMergeInto(a, b, shared, end, anyLength, plan);
  }
  if (ca == cb && !plan.isSound)
  {
    this->PlanMergeInto(b, a, shared, this->Point(a), anyLength, plan);
  }
}

void EditableSurface::PlanMergeInto(Id gone, Id kept, const EdgeTriangles& shared, const Vec3& place,
                                    bool anyLength, EditPlan& plan)
{
  const bool moves = !(place == this->Point(kept));
  Edit& edit = plan.edit;
  this->RemoveStars(edit, gone, moves ? kept : -1);
  double worst = 1;
  for (Id t : edit.removed)
  {
    worst = std::min(worst, this->Quality(t));
    if (std::find(shared.begin(), shared.end(), t) == shared.end())
    {
      Triangle corners = this->Corners(t);
      std::replace(corners.begin(), corners.end(), gone, kept);
      this->Add(edit, corners, t);
    }
  }
  edit.leastQuality = std::min(0.3, worst + (anyLength ? 1e-6 : 0));
  edit.centre = moves ? kept : -1;
  const Vec3 before = this->Point(kept);
  edit.moved = kept;
  edit.from = before;
  const double target = this->Target(kept);
  plan.gone = gone;
  plan.place = place;
  plan.target = std::min(target, this->Target(gone));
  plan.stretch = this->Stretches.empty() ? Stretch{} : this->Stretches[U(kept)];
  this->Points[U(kept)] = place;
  this->Targets[U(kept)] = plan.target;
  plan.isSound = true;
  for (const Added& t : edit.added)
  {
    for (Id p : Others(t.corners, kept))
    {
      plan.isSound = plan.isSound && (anyLength || this->RelativeLength(kept, p) <= this->SplitRatio);
    }
  }
  plan.isSound = plan.isSound && this->IsSound(edit);
  this->Points[U(kept)] = before;
  this->Targets[U(kept)] = target;
}

} // namespace lamina
