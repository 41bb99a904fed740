// SPDX-License-Identifier: BSD-3-Clause
// From an edited surface back to a complex.
#include "EditCorners.h"
#include "EditableSurface.h"

namespace lamina
{

void EditableSurface::Write(TriangleComplex& surface, Monitor& monitor) const
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
  this->WriteFields(surface, sheetOfPoint, monitor);
  ClassifyJunctions(surface);
}

/// The fields of the input at the new points.
void EditableSurface::WriteFields(TriangleComplex& surface, const std::vector<int>& sheetOfPoint,
                                  Monitor& monitor) const
{
  const TriangleComplex& from = this->Input.Surface();
  const std::size_t count = surface.points.size();
  const std::size_t columns = from.sizedMaterials.size();
  const auto widen = [&](auto& field, const auto& source, std::size_t stride)
  { field.resize(source.empty() ? 0 : stride * count); };
  widen(surface.targetEdgeLength, from.targetEdgeLength, 1);
  widen(surface.featureSize, from.featureSize, 1);
  widen(surface.thickness, from.thickness, columns);
  widen(surface.maximumCurvature, from.maximumCurvature, 1);
  widen(surface.minimumCurvature, from.minimumCurvature, 1);
  widen(surface.maximumCurvatureDirection, from.maximumCurvatureDirection, 1);
  monitor.For(static_cast<Id>(count), 1024,
              [&](Id begin, Id end)
              {
                for (Id i = begin; i < end; ++i)
                {
                  const std::size_t p = U(i);
                  const auto place = this->Input.ClosestOnSheet(sheetOfPoint[p], surface.points[p], 1e300);
                  const auto take = [&](auto& field, const auto& source, std::size_t stride)
                  {
                    for (std::size_t m = 0; m < stride && !field.empty(); ++m)
                    {
                      field[stride * p + m] = this->Input.Interpolate(source, place, stride, m);
                    }
                  };
                  take(surface.targetEdgeLength, from.targetEdgeLength, 1);
                  take(surface.featureSize, from.featureSize, 1);
                  take(surface.thickness, from.thickness, columns);
                  take(surface.maximumCurvature, from.maximumCurvature, 1);
                  take(surface.minimumCurvature, from.minimumCurvature, 1);
                  if (!surface.maximumCurvatureDirection.empty())
                  {
                    surface.maximumCurvatureDirection[p] =
                      Normalized(this->Input.InterpolateAxis(from.maximumCurvatureDirection, place));
                  }
                }
              });
}

std::vector<Stretch> EditableSurface::WrittenStretches() const
{
  std::vector<Stretch> stretches;
  std::vector<char> isWritten(this->Points.size(), 0);
  for (Id t = 0; t < this->TriangleCount() && !this->Stretches.empty(); ++t)
  {
    if (!this->IsAlive(t))
    {
      continue;
    }
    for (Id p : this->Corners(t))
    {
      if (!isWritten[U(p)])
      {
        isWritten[U(p)] = 1;
        stretches.push_back(this->Stretches[U(p)]);
      }
    }
  }
  return stretches;
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
