// SPDX-License-Identifier: BSD-3-Clause
#include "EditableSurface.h"

#include "../Geometry/Quality.h"
#include "EditCorners.h"

#include <algorithm>

namespace lamina
{

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

} // namespace lamina
