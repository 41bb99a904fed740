// SPDX-License-Identifier: BSD-3-Clause
#include "EditableSurface.h"

#include "../Geometry/Quality.h"
#include "../Search/Facing.h"
#include "EditCorners.h"

#include <algorithm>

namespace lamina
{

namespace
{

/// About one and a half edges of what is to come, unless the triangles that are there are far smaller or
/// larger.
double GridCell(const InputSurface& input)
{
  const TriangleComplex& surface = input.Surface();
  double triangles = 0;
  double edges = 0;
  double longest = 0;
  for (const Triangle& t : surface.triangles)
  {
    const double h = (1.0 / 3) * (surface.targetEdgeLength[U(t[0])] + surface.targetEdgeLength[U(t[1])] +
                                  surface.targetEdgeLength[U(t[2])]);
    const double count = Norm(AreaVector2(surface.points, t)) / (h * h);
    triangles += count;
    edges += count * h;
    for (std::size_t k = 0; k < 3; ++k)
    {
      longest = std::max(longest, Norm(surface.points[U(t[k])] - surface.points[U(t[(k + 1) % 3])]));
    }
  }
  constexpr double mostCellsAcross = 48; // of one triangle
  const double aim = triangles > 0 ? edges / triangles : input.MeanEdge();
  const double cell = 1.5 * std::min(std::clamp(input.MeanEdge(), 0.5 * aim, aim), 4 * input.MeanEdge());
  return std::max(cell, longest / mostCellsAcross);
}

} // namespace

EditableSurface::EditableSurface(const InputSurface& input, double mergeRatio, double splitRatio)
  : Input(input)
  , MergeRatio(mergeRatio)
  , SplitRatio(splitRatio)
  , Points(input.Surface().points)
  , Targets(input.Surface().targetEdgeLength)
  , Stretches(input.Stretches())
  , Classes(Points.size())
  , Stars(Points.size())
  , Relaxed(Points.size(), -1)
  , Samples(input)
  , PairOfSheet(input.Sheets().shellsOfSheet.size(), -1)
  , Grid(GridCell(input))
{
  const TriangleComplex& surface = input.Surface();
  for (std::size_t p = 0; p < this->Points.size(); ++p)
  {
    const int kind = surface.junctionKind[p] & 3;
    this->Classes[p] = kind == JunctionSheet ? OnSheet : (kind == JunctionCurve ? OnCurve : AtCorner);
  }
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const int sheet = input.TriangleSheet(static_cast<Id>(t));
    this->PairOfSheet[static_cast<std::size_t>(sheet)] = static_cast<Id>(t);
    this->AddTriangle();
    this->Insert(static_cast<Id>(t), surface.triangles[t], sheet,
                 Normalized(AreaVector2(this->Points, surface.triangles[t])), static_cast<Id>(t));
  }
}

Id EditableSurface::AddTriangle()
{
  this->Triangles.push_back({ -1, -1, -1 });
  this->Sheets.push_back(-1);
  this->Normals.emplace_back();
  this->Hints.push_back(-1);
  this->Changed.push_back(0);
  this->Samples.Grow(std::max(this->Triangles.size(), this->Input.Surface().triangles.size()));
  return this->TriangleCount() - 1;
}

double EditableSurface::Quality(const Triangle& t) const
{
  const Vec3& a = this->Point(t[0]);
  const Vec3& b = this->Point(t[1]);
  const Vec3& c = this->Point(t[2]);
  if (this->Stretches.empty())
  {
    return TriangleQuality(a, b, c);
  }
  const Stretch stretch =
    MeanStretch(this->Stretches[U(t[0])], this->Stretches[U(t[1])], this->Stretches[U(t[2])]);
  return TriangleQuality({}, Unstretched(b - a, stretch), Unstretched(c - a, stretch));
}

EdgeTriangles EditableSurface::TrianglesAt(Id a, Id b) const
{
  EdgeTriangles found;
  for (Id t : this->Star(a))
  {
    if (Has(this->Corners(t), b))
    {
      found.push_back(t);
    }
  }
  return found;
}

Id EditableSurface::ChangedAround(Id p) const
{
  Id last = 0;
  for (Id t : this->Star(p))
  {
    for (Id q : this->Corners(t))
    {
      for (Id s : this->Star(q))
      {
        last = std::max(last, this->ChangedAt(s));
      }
    }
  }
  return last;
}

bool EditableSurface::IsFeature(const EdgeTriangles& triangles) const
{
  return triangles.size() != 2 || this->Sheets[U(triangles[0])] != this->Sheets[U(triangles[1])];
}

void EditableSurface::Insert(Id id, const Triangle& corners, int sheet, const Vec3& normal, Id hint)
{
  this->Triangles[U(id)] = corners;
  this->Sheets[U(id)] = sheet;
  this->Normals[U(id)] = normal;
  this->Hints[U(id)] = hint;
  this->Changed[U(id)] = this->Changes;
  for (Id p : corners)
  {
    this->Stars[U(p)].push_back(id);
  }
  this->Grid.Insert(id, this->BoxOf(corners));
}

void EditableSurface::Remove(Id id)
{
  const Triangle corners = this->Triangles[U(id)];
  for (Id p : corners)
  {
    std::vector<Id>& star = this->Stars[U(p)];
    star.erase(std::find(star.begin(), star.end(), id));
  }
  this->Grid.Erase(id, this->BoxOf(corners));
  this->Triangles[U(id)] = { -1, -1, -1 };
}

/// New triangles take the ids of those they replace.
void EditableSurface::Commit(const Edit& edit, Id moved, const Vec3& place)
{
  for (Id t : edit.removed)
  {
    this->Remove(t);
    this->Samples.Clear(t);
  }
  if (moved >= 0)
  {
    this->Points[U(moved)] = place;
  }
  ++this->Changes;
  std::vector<Id>& ids = this->NewIds;
  ids.clear();
  for (const Added& added : edit.added)
  {
    ids.push_back(ids.size() < edit.removed.size() ? edit.removed[ids.size()] : this->AddTriangle());
    this->Insert(ids.back(), added.corners, added.sheet, added.normal, added.hint);
  }
  for (const SampleOwner& owner : edit.owners)
  {
    this->Samples.Put(owner.sample, ids[static_cast<std::size_t>(owner.added)]);
  }
}

bool EditableSurface::CarryOut(const EditPlan& plan)
{
  if (!plan.isSound)
  {
    return false;
  }
  const Id p = plan.edit.moved;
  this->Commit(plan.edit, p, plan.place);
  this->Targets[U(p)] = plan.target;
  if (!this->Stretches.empty())
  {
    this->Stretches[U(p)] = plan.stretch;
  }
  if (plan.gone >= 0)
  {
    this->Classes[U(plan.gone)] = Removed;
    ++this->Done.merges;
  }
  return true;
}

EditRegion EditableSurface::RegionOf(Id a, Id b) const
{
  EditRegion region;
  double farthest = 0;
  double target = 0;
  for (Id p : { a, b })
  {
    for (Id t : p >= 0 ? this->Star(p) : std::vector<Id>())
    {
      for (Id q : this->Corners(t))
      {
        region.writes.Add(this->Point(q));
        farthest = std::max(farthest, Norm2(this->Point(q) - this->Point(p)));
        target = std::max(target, this->Target(q));
      }
    }
  }
  // Wherever the point moves that is no farther than its neighbours are.
  for (Id p : { a, b })
  {
    if (p >= 0)
    {
      Box ball;
      ball.Add(this->Point(p));
      ball.Grow(std::sqrt(farthest));
      region.writes.Add(ball);
    }
  }
  region.reads = region.writes;
  constexpr double roundingOfGrid = 1e-6;
  const double size = std::max(Norm(region.reads.low), Norm(region.reads.high));
  region.reads.Grow((1 + shortWay) * this->Input.LeastGap(target) + roundingOfGrid * size);
  return region;
}

void EditableSurface::RemoveTriangles(Edit& edit, const EdgeTriangles& triangles) const
{
  edit.removed.assign(triangles.begin(), triangles.end());
  std::sort(edit.removed.begin(), edit.removed.end());
  edit.added.clear();
  edit.owners.clear();
  edit.leastQuality = 0;
  edit.centre = -1;
  edit.moved = -1;
}

void EditableSurface::RemoveStars(Edit& edit, Id p, Id q) const
{
  this->RemoveTriangles(edit, {});
  edit.removed = this->Star(p);
  if (q >= 0)
  {
    edit.removed.insert(edit.removed.end(), this->Star(q).begin(), this->Star(q).end());
  }
  std::sort(edit.removed.begin(), edit.removed.end());
  edit.removed.erase(std::unique(edit.removed.begin(), edit.removed.end()), edit.removed.end());
}

void EditableSurface::Add(Edit& edit, const Triangle& corners, Id replaced) const
{
  edit.added.push_back(
    { corners, this->Sheets[U(replaced)], this->Normals[U(replaced)], this->Hints[U(replaced)], {} });
}

Id EditableSurface::Split(Id a, Id b)
{
  const EdgeTriangles shared = this->TrianglesAt(a, b);
  const Id middle = this->PointCount();
  this->Points.push_back(0.5 * (this->Point(a) + this->Point(b)));
  this->Targets.push_back(std::sqrt(this->Target(a) * this->Target(b)));
  this->Classes.push_back(this->IsFeature(shared) ? OnCurve : OnSheet);
  this->Relaxed.push_back(-1);
  if (!this->Stretches.empty())
  {
    const Stretch& s = this->Stretches[U(a)];
    const Stretch& t = this->Stretches[U(b)];
    this->Stretches.push_back(0.5 * (Dot(s, t) < 0 ? s - t : s + t));
  }
  this->Stars.emplace_back();
  Edit& edit = this->Work.edit;
  this->RemoveTriangles(edit, shared);
  for (Id t : edit.removed)
  {
    for (Id end : { a, b })
    {
      Triangle half = this->Corners(t);
      std::replace(half.begin(), half.end(), end, middle);
      this->Add(edit, half, t);
      edit.added.back().normal = this->Normals[U(t)];
    }
  }
  edit.boxes.clear();
  for (const Added& t : edit.added)
  {
    edit.boxes.push_back(this->BoxOf(t.corners));
  }
  this->PlaceSamples(edit);
  this->Commit(edit);
  ++this->Done.splits;
  return middle;
}

} // namespace lamina
