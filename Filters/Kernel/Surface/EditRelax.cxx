// SPDX-License-Identifier: BSD-3-Clause
// Moving a point along the surface.
#include "../Geometry/Quality.h"
#include "EditCorners.h"
#include "EditableSurface.h"

#include <algorithm>

namespace lamina
{

bool EditableSurface::CurveNeighbours(Id p, Id& before, Id& after) const
{
  before = after = -1;
  for (Id t : this->Star(p))
  {
    for (Id q : Others(this->Corners(t), p))
    {
      if (q != before && q != after && this->IsFeature(this->TrianglesAt(p, q)))
      {
        (before < 0 ? before : after) = q;
      }
    }
  }
  return after >= 0;
}

void EditableSurface::PlanMove(Id p, const Vec3& place, double leastQuality, EditPlan& plan)
{
  Edit& edit = plan.edit;
  this->RemoveStars(edit, p);
  for (Id t : edit.removed)
  {
    this->Add(edit, this->Corners(t), t);
  }
  edit.leastQuality = leastQuality;
  edit.centre = p;
  const Vec3 before = this->Point(p);
  edit.moved = p;
  edit.from = before;
  plan.gone = -1;
  plan.place = place;
  plan.target = this->Target(p);
  plan.stretch = this->Stretches.empty() ? Stretch{} : this->Stretches[U(p)];
  this->Points[U(p)] = place;
  plan.isSound = this->IsSound(edit);
  this->Points[U(p)] = before;
}

bool EditableSurface::TryMove(Id p, const Vec3& place, double leastQuality)
{
  this->PlanMove(p, place, leastQuality, this->Work);
  return this->CarryOut(this->Work);
}

namespace
{

constexpr double leastMove = 0.05;   ///< in targets: less is not worth its checks
constexpr double betterShape = 1.02; ///< what a search for a better shape must gain
constexpr double muchBetter = 1.5;   ///< what a split for a better shape must gain
constexpr double leastSplit = 1;     ///< relative length: the halves are not too short

} // namespace

bool EditableSurface::MayRelax(Id p) const
{
  return this->Classes[U(p)] < AtCorner &&
         std::any_of(this->Star(p).begin(), this->Star(p).end(),
                     [&](Id t) { return this->Changed[U(t)] > this->Relaxed[U(p)]; });
}

bool EditableSurface::Relax(Id p)
{
  if (!this->MayRelax(p))
  {
    return false;
  }
  this->PlanRelax(p, this->Work);
  return this->CarryOut(this->Work);
}

/// Towards the middle of the neighbours on a curve, or the weighted middle of the triangles on a sheet, and
/// there without a change of volume. False if there is no such move.
bool EditableSurface::RelaxingMove(Id p, Vec3& move) const
{
  const Vec3& x = this->Point(p);
  if (this->Classes[U(p)] == OnCurve)
  {
    Id before;
    Id after;
    if (!this->CurveNeighbours(p, before, after))
    {
      return false;
    }
    const Vec3 along = Normalized(this->Point(after) - this->Point(before));
    move = Dot(0.5 * (this->Point(after) + this->Point(before)) - x, along) * along;
    return true;
  }
  const Vec3 gradient = this->VolumeGradient(p);
  double weights = 0;
  for (Id t : this->Star(p))
  {
    const Triangle& c = this->Corners(t);
    const Vec3 area = AreaVector2(this->Points, c);
    const double h = this->Target(c[0]) + this->Target(c[1]) + this->Target(c[2]);
    const double weight = Norm(area) / (h * h);
    move += weight * ((1.0 / 3) * (this->Point(c[0]) + this->Point(c[1]) + this->Point(c[2])) - x);
    weights += weight;
  }
  if (weights == 0 || Norm2(gradient) == 0)
  {
    return false;
  }
  move *= 1 / weights;
  move -= (Dot(move, gradient) / Norm2(gradient)) * gradient;
  return true;
}

void EditableSurface::PlanRelax(Id p, EditPlan& plan)
{
  this->Relaxed[U(p)] = this->Changes;
  plan.isSound = false;
  Vec3 move;
  if (!this->RelaxingMove(p, move) || Norm(move) < leastMove * this->Target(p))
  {
    return;
  }
  const Vec3 x = this->Point(p);
  const double worst = this->WorstQuality(p);
  for (double step : { 1.0, 0.4 })
  {
    this->PlanMove(p, x + step * move, std::min(worst, 0.5), plan);
    if (plan.isSound)
    {
      const auto place =
        this->Input.ClosestOnSheet(plan.edit.added[0].sheet, plan.place, this->Input.MeanEdge());
      if (place.triangle >= 0)
      {
        plan.target = this->Input.TargetAt(place);
        plan.stretch = this->Stretches.empty() ? Stretch{} : this->Input.StretchAt(place);
      }
      return;
    }
  }
}

double EditableSurface::WorstQuality(Id p) const
{
  double worst = 1;
  for (Id t : this->Star(p))
  {
    worst = std::min(worst, this->Quality(t));
  }
  return worst;
}

/// What moves of p must be square to so that no volume changes.
Vec3 EditableSurface::VolumeGradient(Id p) const
{
  Vec3 gradient;
  for (Id t : this->Star(p))
  {
    gradient += AreaVector2(this->Points, this->Corners(t));
  }
  return gradient;
}

/// Move p by up to a length, towards a corner, an edge or a side of a cube around it; `along`: without change
/// of volume.
bool EditableSurface::TryAround(Id p, double length, double leastQuality, bool along)
{
  if (this->IsOnPatch(p))
  {
    return false; // points of a border plane or an opening must stay in it
  }
  const Vec3 normal = along ? Normalized(this->VolumeGradient(p)) : Vec3{};
  for (int i = 0; i < 27; ++i)
  {
    Vec3 way = Normalized({ i % 3 - 1.0, i / 3 % 3 - 1.0, i / 9 - 1.0 });
    way -= Dot(way, normal) * normal;
    if (Norm2(way) > 0.1 && this->TryMove(p, this->Point(p) + length * way, leastQuality))
    {
      return true;
    }
  }
  return false;
}

/// Move p along its curve by up to a length, either way.
bool EditableSurface::TryAlongCurve(Id p, double length, double leastQuality)
{
  Id before;
  Id after;
  if (!this->CurveNeighbours(p, before, after))
  {
    return false;
  }
  const Vec3 x = this->Point(p);
  return this->TryMove(p, x + length * Normalized(this->Point(after) - x), leastQuality) ||
         this->TryMove(p, x + length * Normalized(this->Point(before) - x), leastQuality);
}

bool EditableSurface::Reshape(Id p)
{
  const Class kind = this->Classes[U(p)];
  if (kind >= AtCorner || this->Star(p).empty())
  {
    return false;
  }
  const double least = betterShape * this->WorstQuality(p);
  return std::any_of(std::begin(searchSteps), std::end(searchSteps),
                     [&](double step)
                     {
                       const double length = step * this->Target(p);
                       return kind == OnCurve ? this->TryAlongCurve(p, length, least)
                                              : this->TryAround(p, length, least, true);
                     });
}

double EditableSurface::QualityOfHalves(Id a, Id b) const
{
  const Vec3 middle = 0.5 * (this->Point(a) + this->Point(b));
  double least = 1;
  for (Id t : this->TrianglesAt(a, b))
  {
    const Vec3& far = this->Point(Third(this->Corners(t), a, b));
    least = std::min(
      { least, TriangleQuality(this->Point(a), middle, far), TriangleQuality(this->Point(b), middle, far) });
  }
  return least;
}

bool EditableSurface::SplitFlat(Id triangle)
{
  const Triangle corners = this->Corners(triangle);
  std::size_t longest = 0;
  for (std::size_t k = 1; k < 3; ++k)
  {
    longest = this->Length(corners[k], corners[(k + 1) % 3]) >
                  this->Length(corners[longest], corners[(longest + 1) % 3])
                ? k
                : longest;
  }
  const Id a = corners[longest];
  const Id b = corners[(longest + 1) % 3];
  double before = 1;
  for (Id t : this->TrianglesAt(a, b))
  {
    before = std::min(before, this->Quality(t));
  }
  const double after = this->QualityOfHalves(a, b);
  if (!this->Stretches.empty() || after < muchBetter * before || this->RelativeLength(a, b) < leastSplit)
  {
    return false; // stretched triangles are meant to be flat
  }
  this->Split(a, b);
  return true;
}

} // namespace lamina
