// SPDX-License-Identifier: BSD-3-Clause
// An edited surface in the order of space: after many edits neighbours lie all over the memory.
#include "../Geometry/SpatialOrder.h"
#include "EditCorners.h"
#include "EditableSurface.h"

#include <algorithm>

namespace lamina
{

namespace
{

template<typename Field>
void Pick(Field& field, const std::vector<Id>& order)
{
  if (field.empty())
  {
    return;
  }
  Field picked;
  picked.reserve(order.size());
  for (Id i : order)
  {
    picked.push_back(std::move(field[U(i)]));
  }
  field = std::move(picked);
}

} // namespace

void EditableSurface::Renumber()
{
  std::vector<Id> points;
  std::vector<Id> number(this->Points.size(), -1);
  for (Id p : SpatialOrder(this->Points))
  {
    if (!this->Star(p).empty())
    {
      number[U(p)] = static_cast<Id>(points.size());
      points.push_back(p);
    }
  }
  std::vector<std::pair<Id, Id>> keys; // of a triangle: its first point in the new order
  for (Id t = 0; t < this->TriangleCount(); ++t)
  {
    if (this->IsAlive(t))
    {
      Triangle& c = this->Triangles[U(t)];
      c = { { number[U(c[0])], number[U(c[1])], number[U(c[2])] } };
      keys.push_back({ std::min({ c[0], c[1], c[2] }), t });
    }
  }
  std::sort(keys.begin(), keys.end());
  std::vector<Id> triangles;
  triangles.reserve(keys.size());
  for (const auto& key : keys)
  {
    triangles.push_back(key.second);
  }
  Pick(this->Points, points);
  Pick(this->Targets, points);
  Pick(this->Stretches, points);
  Pick(this->Classes, points);
  Pick(this->Relaxed, points);
  Pick(this->Triangles, triangles);
  Pick(this->Sheets, triangles);
  Pick(this->Normals, triangles);
  Pick(this->Hints, triangles);
  Pick(this->Changed, triangles);
  this->Samples.Renumber(triangles);
  this->Grid = TriangleGrid(this->Grid.CellSize());
  this->Stars.assign(points.size(), {});
  for (Id t = 0; t < this->TriangleCount(); ++t)
  {
    for (Id p : this->Corners(t))
    {
      this->Stars[U(p)].push_back(t);
    }
    this->Grid.Insert(t, this->BoxOf(this->Corners(t)));
  }
}

} // namespace lamina
