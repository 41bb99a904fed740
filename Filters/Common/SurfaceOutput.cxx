// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceBridge.h"

#include "Arrays.h"
#include "MeshArrayNames.h"

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

namespace lamina
{

namespace
{

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
  output->GetFieldData()->AddArray(MakeStrings(names::PatchNames, surface.patchNames));
}

} // namespace

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
  std::vector<double> missing;
  for (const auto& both : surface.missing)
  {
    missing.insert(missing.end(), both.begin(), both.end());
  }
  SetOrRemove<vtkDoubleArray>(cells, names::MissingVolume, missing, 2);
  vtkPointData* points = output->GetPointData();
  SetOrRemove<vtkUnsignedCharArray>(points, names::JunctionOrder, surface.junctionOrder);
  SetOrRemove<vtkUnsignedCharArray>(points, names::JunctionKind, surface.junctionKind);
  SetOrRemove<vtkDoubleArray>(points, names::FeatureSize, surface.featureSize);
  SetOrRemove<vtkDoubleArray>(points, names::TargetEdgeLength, surface.targetEdgeLength);
  SetOrRemove<vtkDoubleArray>(points, names::LayerHeight, surface.layerHeight);
  SetOrRemoveVectors(points, names::LayerSide, surface.layerSide);
  WriteCurvatures(surface, points);
  WriteThickness(surface, output);
  WritePatchNames(surface, output);
  AttachMaterialList(output, DistinctValues(labels));
  cells->SetActiveScalars(names::BoundaryLabels);
  points->SetActiveScalars(surface.featureSize.empty() ? nullptr : names::FeatureSize);
}

void WriteLayers(const std::vector<int>& achieved, const std::vector<double>& fraction, vtkPolyData* output)
{
  SetOrRemove<vtkIntArray>(output->GetCellData(), names::LayersAchieved, achieved);
  SetOrRemove<vtkDoubleArray>(output->GetCellData(), names::LayerFraction, fraction);
}

} // namespace lamina
