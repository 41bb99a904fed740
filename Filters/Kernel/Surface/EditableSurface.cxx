// SPDX-License-Identifier: BSD-3-Clause
#include "EditableSurface.h"

#include "../Geometry/Quality.h"

#include <algorithm>

namespace lamina
{

namespace
{

std::size_t U(Id i)
{
  return static_cast<std::size_t>(i);
}

bool Has(const Triangle& t, Id p)
{
  return t[0] == p || t[1] == p || t[2] == p;
}

/// The corner after p, and the one after that.
std::array<Id, 2> Others(const Triangle& t, Id p)
{
  const std::size_t at = t[0] == p ? 0 : (t[1] == p ? 1 : 2);
  return { { t[(at + 1) % 3], t[(at + 2) % 3] } };
}

Id Third(const Triangle& t, Id a, Id b)
{
  return t[0] + t[1] + t[2] - a - b;
}

} // namespace

EditableSurface::EditableSurface(const InputSurface& input, double mergeRatio, double splitRatio)
  : Input(input)
  , MergeRatio(mergeRatio)
  , SplitRatio(splitRatio)
  , Points(input.Surface().points)
  , Targets(input.Surface().targetEdgeLength)
  , Classes(Points.size())
  , Stars(Points.size())
  , PairOfSheet(input.Sheets().shellsOfSheet.size(), -1)
  , Grid(2 * input.MeanEdge())
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
    this->Triangles.push_back({ -1, -1, -1 });
    this->Sheets.push_back(sheet);
    this->Insert(static_cast<Id>(t), surface.triangles[t], sheet);
  }
}

double EditableSurface::Quality(Id triangle) const
{
  const Triangle& t = this->Corners(triangle);
  return TriangleQuality(this->Point(t[0]), this->Point(t[1]), this->Point(t[2]));
}

std::vector<Id> EditableSurface::TrianglesAt(Id a, Id b) const
{
  std::vector<Id> found;
  for (Id t : this->Star(a))
  {
    if (Has(this->Corners(t), b))
    {
      found.push_back(t);
    }
  }
  return found;
}

bool EditableSurface::IsFeature(const std::vector<Id>& triangles) const
{
  return triangles.size() != 2 || this->Sheets[U(triangles[0])] != this->Sheets[U(triangles[1])];
}

Box EditableSurface::BoxOf(const Triangle& t) const
{
  Box box;
  for (Id p : t)
  {
    box.Add(this->Point(p));
  }
  return box;
}

void EditableSurface::Insert(Id id, const Triangle& corners, int sheet)
{
  this->Triangles[U(id)] = corners;
  this->Sheets[U(id)] = sheet;
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

/// New triangles take the ids of those they replace. The coordinates of points must be those of the time when
/// the removed triangles were put in.
void EditableSurface::Commit(const Edit& edit)
{
  std::size_t reused = 0;
  for (const Added& added : edit.added)
  {
    Id id = static_cast<Id>(this->Triangles.size());
    if (reused < edit.removed.size())
    {
      id = edit.removed[reused++];
    }
    else
    {
      this->Triangles.push_back({ -1, -1, -1 });
      this->Sheets.push_back(added.sheet);
    }
    this->Insert(id, added.corners, added.sheet);
  }
}

EditableSurface::Edit EditableSurface::RemovalOf(std::vector<Id> triangles) const
{
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  Edit edit;
  edit.removed = std::move(triangles);
  return edit;
}

Id EditableSurface::Split(Id a, Id b)
{
  const std::vector<Id> shared = this->TrianglesAt(a, b);
  const Id middle = this->PointCount();
  this->Points.push_back(0.5 * (this->Point(a) + this->Point(b)));
  this->Targets.push_back(std::sqrt(this->Target(a) * this->Target(b)));
  this->Classes.push_back(this->IsFeature(shared) ? OnCurve : OnSheet);
  this->Stars.emplace_back();
  Edit edit = this->RemovalOf(shared);
  for (Id t : edit.removed)
  {
    for (Id end : { a, b })
    {
      Triangle half = this->Corners(t);
      std::replace(half.begin(), half.end(), end, middle);
      edit.added.push_back({ half, this->Sheets[U(t)], {} });
    }
  }
  for (Id t : edit.removed)
  {
    this->Remove(t);
  }
  this->Commit(edit);
  return middle;
}

/// The link condition: the ends share no neighbour but the far corners of the edge's triangles, and no
/// triangle would come to lie on another.
bool EditableSurface::LinkAllows(Id gone, Id kept, const std::vector<Id>& shared) const
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
Vec3 EditableSurface::MergedPlace(Id gone, Id kept, const std::vector<Id>& shared) const
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
  const std::vector<Id> shared = this->TrianglesAt(a, b);
  if (shared.empty())
  {
    return false;
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
    return false;
  }
  const Vec3 end = this->Point(b);
  Vec3 place = end;
  if (ca == cb)
  {
    place = ca == OnSheet ? this->MergedPlace(a, b, shared) : 0.5 * (this->Point(a) + end);
  }
  if (this->MergeInto(a, b, shared, place, anyLength))
  {
    return true;
  }
  return ca == cb && (this->MergeInto(a, b, shared, end, anyLength) ||
                      this->MergeInto(b, a, shared, this->Point(a), anyLength));
}

bool EditableSurface::MergeInto(Id gone, Id kept, const std::vector<Id>& shared, const Vec3& place,
                                bool anyLength)
{
  std::vector<Id> touched = this->Star(gone);
  const bool moves = !(place == this->Point(kept));
  if (moves)
  {
    touched.insert(touched.end(), this->Star(kept).begin(), this->Star(kept).end());
  }
  Edit edit = this->RemovalOf(touched);
  double worst = 1;
  for (Id t : edit.removed)
  {
    worst = std::min(worst, this->Quality(t));
    if (std::find(shared.begin(), shared.end(), t) != shared.end())
    {
      continue;
    }
    Triangle corners = this->Corners(t);
    const Vec3 normal = Normalized(AreaVector2(this->Points, corners));
    std::replace(corners.begin(), corners.end(), gone, kept);
    edit.added.push_back({ corners, this->Sheets[U(t)], normal });
  }
  edit.leastQuality = std::min(0.3, worst + (anyLength ? 1e-6 : 0));
  edit.centre = moves ? kept : -1;
  const Vec3 before = this->Point(kept);
  const double target = this->Target(kept);
  this->Points[U(kept)] = place;
  this->Targets[U(kept)] = std::min(target, this->Target(gone));
  bool sound = true;
  for (const Added& t : edit.added)
  {
    for (Id p : Others(t.corners, kept))
    {
      sound = sound && (anyLength || this->RelativeLength(kept, p) <= this->SplitRatio);
    }
  }
  sound = sound && this->IsSound(edit);
  this->Points[U(kept)] = before;
  if (!sound)
  {
    this->Targets[U(kept)] = target;
    return false;
  }
  for (Id t : edit.removed)
  {
    this->Remove(t);
  }
  this->Points[U(kept)] = place;
  this->Commit(edit);
  this->Classes[U(gone)] = Removed;
  return true;
}

bool EditableSurface::Swap(Id a, Id b)
{
  const std::vector<Id> shared = this->TrianglesAt(a, b);
  if (this->IsFeature(shared))
  {
    return false;
  }
  // Let the first triangle run a -> b.
  const Triangle first = this->Corners(shared[0]);
  if (Others(first, a)[0] != b)
  {
    std::swap(a, b);
  }
  const Id c = Third(first, a, b);
  const Id d = Third(this->Corners(shared[1]), a, b);
  if (c == d || !this->TrianglesAt(c, d).empty())
  {
    return false;
  }
  const double worst = std::min(this->Quality(shared[0]), this->Quality(shared[1]));
  Edit edit = this->RemovalOf(shared);
  const Vec3 normal =
    Normalized(AreaVector2(this->Points, first) + AreaVector2(this->Points, this->Corners(shared[1])));
  const int sheet = this->Sheets[U(shared[0])];
  edit.added.push_back({ { a, d, c }, sheet, normal });
  edit.added.push_back({ { d, b, c }, sheet, normal });
  edit.leastQuality = this->Mending ? std::min(0.3, worst) : worst * 1.01;
  const double q = std::min(TriangleQuality(this->Point(a), this->Point(d), this->Point(c)),
                            TriangleQuality(this->Point(d), this->Point(b), this->Point(c)));
  if (q < edit.leastQuality || !this->IsSound(edit))
  {
    return false;
  }
  for (Id t : edit.removed)
  {
    this->Remove(t);
  }
  this->Commit(edit);
  return true;
}

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

bool EditableSurface::TryMove(Id p, const Vec3& place, double leastQuality)
{
  Edit edit = this->RemovalOf(this->Star(p));
  for (Id t : edit.removed)
  {
    edit.added.push_back(
      { this->Corners(t), this->Sheets[U(t)], Normalized(AreaVector2(this->Points, this->Corners(t))) });
  }
  edit.leastQuality = leastQuality;
  edit.centre = p;
  const Vec3 before = this->Point(p);
  this->Points[U(p)] = place;
  const bool sound = this->IsSound(edit);
  this->Points[U(p)] = before;
  if (!sound)
  {
    return false;
  }
  for (Id t : edit.removed)
  {
    this->Remove(t);
  }
  this->Points[U(p)] = place;
  this->Commit(edit);
  return true;
}

bool EditableSurface::Relax(Id p)
{
  if (this->Classes[U(p)] >= AtCorner || this->Star(p).empty())
  {
    return false;
  }
  const Vec3& x = this->Point(p);
  double worst = 1;
  Vec3 move;
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
  }
  else
  {
    Vec3 gradient;
    double weights = 0;
    for (Id t : this->Star(p))
    {
      const Triangle& c = this->Corners(t);
      const Vec3 area = AreaVector2(this->Points, c);
      const double h = this->Target(c[0]) + this->Target(c[1]) + this->Target(c[2]);
      const double weight = Norm(area) / (h * h);
      gradient += area;
      move += weight * ((1.0 / 3) * (this->Point(c[0]) + this->Point(c[1]) + this->Point(c[2])) - x);
      weights += weight;
    }
    if (weights == 0 || Norm2(gradient) == 0)
    {
      return false;
    }
    move *= 1 / weights;
    move -= (Dot(move, gradient) / Norm2(gradient)) * gradient;
  }
  for (Id t : this->Star(p))
  {
    worst = std::min(worst, this->Quality(t));
  }
  if (Norm(move) < 0.03 * this->Target(p))
  {
    return false;
  }
  for (double step : { 1.0, 0.4 })
  {
    if (this->TryMove(p, x + step * move, std::min(worst, 0.5)))
    {
      const int sheet = this->Sheets[U(this->Star(p)[0])];
      const auto place = this->Input.ClosestOnSheet(sheet, this->Point(p), this->Input.MeanEdge());
      if (place.triangle >= 0)
      {
        this->Targets[U(p)] = this->Input.TargetAt(place);
      }
      return true;
    }
  }
  return false;
}

void EditableSurface::Write(TriangleComplex& surface) const
{
  const TriangleComplex& from = this->Input.Surface();
  surface = TriangleComplex{};
  surface.patchNames = from.patchNames;
  surface.sizedMaterials = from.sizedMaterials;
  std::vector<Id> number(this->Points.size(), -1);
  std::vector<int> sheetOfPoint;
  for (Id t = 0; t < this->TriangleCount(); ++t)
  {
    if (!this->IsAlive(t))
    {
      continue;
    }
    Triangle corners = this->Corners(t);
    for (Id& p : corners)
    {
      if (number[U(p)] < 0)
      {
        number[U(p)] = static_cast<Id>(surface.points.size());
        surface.points.push_back(this->Point(p));
        sheetOfPoint.push_back(this->Sheets[U(t)]);
      }
      p = number[U(p)];
    }
    const Id model = this->PairOfSheet[static_cast<std::size_t>(this->Sheets[U(t)])];
    surface.triangles.push_back(corners);
    surface.materials.push_back(from.materials[U(model)]);
    if (!from.patches.empty())
    {
      surface.patches.push_back(from.Patch(model));
    }
  }
  const std::size_t columns = from.sizedMaterials.size();
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    TriangleTree::Closest place = this->Input.ClosestOnSheet(sheetOfPoint[p], surface.points[p], 1e300);
    surface.targetEdgeLength.push_back(this->Input.TargetAt(place));
    if (!from.featureSize.empty())
    {
      surface.featureSize.push_back(this->Input.Interpolate(from.featureSize, place));
    }
    for (std::size_t m = 0; m < columns; ++m)
    {
      surface.thickness.push_back(this->Input.Interpolate(from.thickness, place, columns, m));
    }
  }
  ClassifyJunctions(surface);
}

SheetGraph EditableSurface::WrittenSheets() const
{
  SheetGraph graph = this->Input.Sheets();
  graph.sheetOfTriangle.clear();
  for (Id t = 0; t < this->TriangleCount(); ++t)
  {
    if (this->IsAlive(t))
    {
      graph.sheetOfTriangle.push_back(this->Sheets[U(t)]);
    }
  }
  return graph;
}

} // namespace lamina
