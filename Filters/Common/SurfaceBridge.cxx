// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceBridge.h"

#include "Arrays.h"
#include "MeshArrayNames.h"
#include "PlainSurface.h"

#include "Mesh/Closedness.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cstdlib>

namespace lamina
{

namespace
{

Status CheckCells(vtkPolyData* input)
{
  const vtkIdType others = input->GetNumberOfVerts() + input->GetNumberOfLines() + input->GetNumberOfStrips();
  if (others > 0)
  {
    return InvalidInput("the surface has " + std::to_string(others) +
                        " vertices, lines or strips: only triangles are allowed, run Triangulate (without "
                        "passing verts and lines) first");
  }
  return Done{};
}

Status ReadTriangles(vtkPolyData* input, TriangleComplex& surface)
{
  vtkCellArray* polys = input->GetPolys();
  const vtkIdType count = polys->GetNumberOfCells();
  const vtkIdType points = input->GetNumberOfPoints();
  surface.triangles.resize(static_cast<std::size_t>(count));
  for (vtkIdType t = 0; t < count; ++t)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    polys->GetCellAtId(t, size, ids);
    if (size != 3)
    {
      return InvalidInput("cell " + std::to_string(t) + " has " + std::to_string(size) +
                          " points: only triangles are allowed, run Triangulate first");
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      if (ids[i] < 0 || ids[i] >= points)
      {
        return InvalidInput("triangle " + std::to_string(t) + " refers to point " + std::to_string(ids[i]) +
                            ", which does not exist");
      }
      surface.triangles[static_cast<std::size_t>(t)][i] = ids[i];
    }
    if (ids[0] == ids[1] || ids[1] == ids[2] || ids[2] == ids[0])
    {
      return InvalidInput("triangle " + std::to_string(t) + " has a point twice: run Clean first",
                          { surface.points[static_cast<std::size_t>(ids[0])] });
    }
  }
  return Done{};
}

/// The convention puts background second and else the lower id first: other pairs are swapped, with the
/// triangle turned.
Status TakeLabels(const std::vector<int>& labels, TriangleComplex& surface)
{
  surface.materials.resize(surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    MaterialPair pair{ labels[2 * t], labels[2 * t + 1] };
    Triangle& triangle = surface.triangles[t];
    if (pair.first == pair.second || pair.first < 0 || pair.second < 0)
    {
      return InvalidInput(std::string(names::BoundaryLabels) + " of triangle " + std::to_string(t) + " are " +
                            std::to_string(pair.first) + " and " + std::to_string(pair.second) +
                            ": two different materials are needed, none negative",
                          { surface.points[static_cast<std::size_t>(triangle[0])] });
    }
    if (pair.first == 0 || (pair.second != 0 && pair.second < pair.first))
    {
      std::swap(pair.first, pair.second);
      std::swap(triangle[1], triangle[2]);
    }
    surface.materials[t] = pair;
  }
  return Done{};
}

template<typename T>
Status Take(Result<std::vector<T>> values, std::vector<T>& into)
{
  if (!values)
  {
    return values.GetError();
  }
  into = std::move(*values);
  return Done{};
}

Status ReadPatches(vtkPolyData* input, TriangleComplex& surface)
{
  auto status =
    Take(ReadValues<int>(input->GetCellData(), names::PatchIds, input->GetNumberOfCells(), 1, "triangles"),
         surface.patches);
  auto* patchNames = vtkStringArray::SafeDownCast(input->GetFieldData()->GetAbstractArray(names::PatchNames));
  for (vtkIdType i = 0; status && patchNames && i < patchNames->GetNumberOfValues(); ++i)
  {
    surface.patchNames.push_back(patchNames->GetValue(i));
  }
  return status;
}

/// MaterialFeatureSize: the names of its components are material ids.
Status ReadThickness(vtkPolyData* input, TriangleComplex& surface)
{
  vtkDataArray* array = input->GetPointData()->GetArray(names::MaterialFeatureSize);
  if (!array)
  {
    return Done{};
  }
  const int columns = array->GetNumberOfComponents();
  for (int c = 0; c < columns; ++c)
  {
    const char* name = array->GetComponentName(c);
    char* end = nullptr;
    const long id = name ? std::strtol(name, &end, 10) : -1;
    if (!name || end == name || *end != '\0' || id < 0)
    {
      return InvalidInput(std::string("component ") + std::to_string(c) + " of " +
                          names::MaterialFeatureSize +
                          " is not named after a material id: run Feature Size again");
    }
    surface.sizedMaterials.push_back(static_cast<int>(id));
  }
  return Take(ReadValues<double>(input->GetPointData(), names::MaterialFeatureSize,
                                 input->GetNumberOfPoints(), columns, "points"),
              surface.thickness);
}

Status ReadCurvatures(vtkPointData* data, vtkIdType count, TriangleComplex& surface)
{
  auto status =
    Take(ReadValues<double>(data, names::MaximumCurvature, count, 1, "points"), surface.maximumCurvature);
  status = status ? Take(ReadValues<double>(data, names::MinimumCurvature, count, 1, "points"),
                         surface.minimumCurvature)
                  : status;
  std::vector<double> direction;
  status = status
             ? Take(ReadValues<double>(data, names::MaximumCurvatureDirection, count, 3, "points"), direction)
             : status;
  for (std::size_t i = 0; status && i + 2 < direction.size(); i += 3)
  {
    surface.maximumCurvatureDirection.push_back({ direction[i], direction[i + 1], direction[i + 2] });
  }
  return status;
}

Status ReadPointArrays(vtkPolyData* input, TriangleComplex& surface)
{
  vtkPointData* data = input->GetPointData();
  const vtkIdType count = input->GetNumberOfPoints();
  using Bytes = unsigned char;
  auto status =
    Take(ReadValues<Bytes>(data, names::JunctionOrder, count, 1, "points"), surface.junctionOrder);
  status = status
             ? Take(ReadValues<Bytes>(data, names::JunctionKind, count, 1, "points"), surface.junctionKind)
             : status;
  status = status
             ? Take(ReadValues<double>(data, names::FeatureSize, count, 1, "points"), surface.featureSize)
             : status;
  status = status ? Take(ReadValues<double>(data, names::TargetEdgeLength, count, 1, "points"),
                         surface.targetEdgeLength)
                  : status;
  status = status ? ReadCurvatures(data, count, surface) : status;
  return status ? ReadThickness(input, surface) : status;
}

void WriteThickness(const TriangleComplex& surface, vtkPolyData* output)
{
  const int columns = static_cast<int>(surface.sizedMaterials.size());
  if (columns == 0 || surface.thickness.empty())
  {
    output->GetPointData()->RemoveArray(names::MaterialFeatureSize);
    return;
  }
  auto array = MakeArray<vtkDoubleArray>(names::MaterialFeatureSize, surface.thickness, columns);
  for (int c = 0; c < columns; ++c)
  {
    array->SetComponentName(c, std::to_string(surface.sizedMaterials[static_cast<std::size_t>(c)]).c_str());
  }
  output->GetPointData()->AddArray(array);
}

void WriteCurvatures(const TriangleComplex& surface, vtkPointData* points)
{
  SetOrRemove<vtkDoubleArray>(points, names::MaximumCurvature, surface.maximumCurvature);
  SetOrRemove<vtkDoubleArray>(points, names::MinimumCurvature, surface.minimumCurvature);
  std::vector<double> direction;
  direction.reserve(3 * surface.maximumCurvatureDirection.size());
  for (const Vec3& d : surface.maximumCurvatureDirection)
  {
    direction.insert(direction.end(), { d.x, d.y, d.z });
  }
  SetOrRemove<vtkDoubleArray>(points, names::MaximumCurvatureDirection, direction, 3);
}

void WritePatchNames(const TriangleComplex& surface, vtkPolyData* output)
{
  output->GetFieldData()->RemoveArray(names::PatchNames);
  if (surface.patchNames.empty())
  {
    return;
  }
  auto array = vtkSmartPointer<vtkStringArray>::New();
  array->SetName(names::PatchNames);
  for (const std::string& name : surface.patchNames)
  {
    array->InsertNextValue(name);
  }
  output->GetFieldData()->AddArray(array);
}

} // namespace

Result<TriangleComplex> ReadSurface(vtkPolyData* input, Monitor& monitor)
{
  TriangleComplex surface;
  auto status = CheckCells(input);
  status = status ? Take(ReadPoints(input->GetPoints()), surface.points) : status;
  status = status ? ReadTriangles(input, surface) : status;
  std::vector<int> labels;
  status = status ? Take(ReadValues<int>(input->GetCellData(), names::BoundaryLabels,
                                         input->GetNumberOfCells(), 2, "triangles"),
                         labels)
                  : status;
  status =
    status ? (labels.empty() ? LabelPlainSurface(surface, monitor) : TakeLabels(labels, surface)) : status;
  status = status ? ReadPatches(input, surface) : status;
  status = status ? ReadPointArrays(input, surface) : status;
  if (!status)
  {
    return status.GetError();
  }
  return surface;
}

void WriteSurface(const TriangleComplex& surface, vtkPolyData* output)
{
  const vtkIdType count = static_cast<vtkIdType>(surface.triangles.size());
  auto connectivity = vtkSmartPointer<vtkIdTypeArray>::New();
  connectivity->SetNumberOfValues(3 * count);
  std::vector<int> labels;
  labels.reserve(2 * surface.materials.size());
  for (vtkIdType t = 0; t < count; ++t)
  {
    const Triangle& triangle = surface.triangles[static_cast<std::size_t>(t)];
    std::copy(triangle.begin(), triangle.end(), connectivity->GetPointer(3 * t));
  }
  for (const MaterialPair& pair : surface.materials)
  {
    labels.insert(labels.end(), { pair.first, pair.second });
  }
  auto polys = vtkSmartPointer<vtkCellArray>::New();
  polys->SetData(3, connectivity);
  output->SetPoints(MakePoints(surface.points));
  output->SetPolys(polys);

  vtkCellData* cells = output->GetCellData();
  SetOrRemove<vtkIntArray>(cells, names::BoundaryLabels, labels, 2);
  SetOrRemove<vtkIntArray>(cells, names::PatchIds, surface.patches);
  vtkPointData* points = output->GetPointData();
  SetOrRemove<vtkUnsignedCharArray>(points, names::JunctionOrder, surface.junctionOrder);
  SetOrRemove<vtkUnsignedCharArray>(points, names::JunctionKind, surface.junctionKind);
  SetOrRemove<vtkDoubleArray>(points, names::FeatureSize, surface.featureSize);
  SetOrRemove<vtkDoubleArray>(points, names::TargetEdgeLength, surface.targetEdgeLength);
  WriteCurvatures(surface, points);
  WriteThickness(surface, output);
  WritePatchNames(surface, output);
  cells->SetActiveScalars(names::BoundaryLabels);
  points->SetActiveScalars(surface.featureSize.empty() ? nullptr : names::FeatureSize);
}

void WriteLayers(const std::vector<int>& achieved, const std::vector<double>& fraction, vtkPolyData* output)
{
  SetOrRemove<vtkIntArray>(output->GetCellData(), names::LayersAchieved, achieved);
  SetOrRemove<vtkDoubleArray>(output->GetCellData(), names::LayerFraction, fraction);
}

Status RequireTargetEdgeLength(const TriangleComplex& surface, const char* name)
{
  if (surface.targetEdgeLength.empty())
  {
    return MissingArray(name, "points", "Feature Size");
  }
  for (std::size_t i = 0; i < surface.points.size(); ++i)
  {
    if (!(surface.targetEdgeLength[i] > 0) || !std::isfinite(surface.targetEdgeLength[i]))
    {
      return InvalidInput(std::string(name) + " of point " + std::to_string(i) + " is not a positive number",
                          { surface.points[i] });
    }
  }
  return Done{};
}

Status RequireThickness(const TriangleComplex& surface)
{
  if (surface.thickness.empty())
  {
    return MissingArray(names::MaterialFeatureSize, "points", "Feature Size");
  }
  return Done{};
}

} // namespace lamina
