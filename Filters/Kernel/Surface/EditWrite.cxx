// SPDX-License-Identifier: BSD-3-Clause
// From an edited surface back to a complex.
#include "EditCorners.h"
#include "EditableSurface.h"

namespace lamina
{

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
