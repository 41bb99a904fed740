// SPDX-License-Identifier: BSD-3-Clause
#include "GridBridge.h"

#include "Arrays.h"
#include "MeshArrayNames.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <numeric>

namespace lamina
{

namespace
{

bool IsKnown(int type)
{
  return type == VTK_TETRA || type == VTK_WEDGE || type == VTK_PYRAMID;
}

Status ReadCells(vtkUnstructuredGrid* input, VolumeMesh& mesh)
{
  vtkCellArray* cells = input->GetCells();
  const vtkIdType points = input->GetNumberOfPoints();
  const auto count = static_cast<std::size_t>(input->GetNumberOfCells());
  mesh.types.reserve(count);
  mesh.offsets.reserve(count + 1);
  mesh.connectivity.reserve(static_cast<std::size_t>(cells->GetNumberOfConnectivityIds()));
  for (vtkIdType c = 0; c < input->GetNumberOfCells(); ++c)
  {
    const int type = input->GetCellType(c);
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCellAtId(c, size, ids);
    if (!IsKnown(type) || size != NodeCount(static_cast<CellType>(type)))
    {
      return InvalidInput("cell " + std::to_string(c) + " is of VTK's type " + std::to_string(type) +
                          " with " + std::to_string(size) +
                          " points: only tetrahedra, wedges and pyramids are allowed");
    }
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (ids[i] < 0 || ids[i] >= points)
      {
        return InvalidInput("cell " + std::to_string(c) + " refers to point " + std::to_string(ids[i]) +
                            ", which does not exist");
      }
    }
    mesh.types.push_back(static_cast<CellType>(type));
    mesh.connectivity.insert(mesh.connectivity.end(), ids, ids + size);
    mesh.offsets.push_back(static_cast<Id>(mesh.connectivity.size()));
  }
  return Done{};
}

/// Values of an array, or `otherwise` for each if it is missing.
template<typename T>
Status TakeOr(vtkDataSetAttributes* data, const char* name, vtkIdType count, const char* where, T otherwise,
              std::vector<T>& into)
{
  auto values = ReadValues<T>(data, name, count, 1, where);
  if (!values)
  {
    return values.GetError();
  }
  into = std::move(*values);
  if (into.empty())
  {
    into.assign(static_cast<std::size_t>(count), otherwise);
  }
  return Done{};
}

} // namespace

Result<VolumeMesh> ReadGrid(vtkUnstructuredGrid* input, WithoutMaterials without)
{
  if (without == WithoutMaterials::Refuse && !input->GetCellData()->GetArray(names::MaterialIds))
  {
    return MissingArray(names::MaterialIds, "cells", "Layered Tetrahedra, Prism Layer or Core Tetrahedra");
  }
  VolumeMesh mesh;
  auto points = ReadPoints(input->GetPoints());
  if (!points)
  {
    return points.GetError();
  }
  mesh.points = std::move(*points);
  const vtkIdType cells = input->GetNumberOfCells();
  const vtkIdType nodes = input->GetNumberOfPoints();
  vtkCellData* onCells = input->GetCellData();
  vtkPointData* onPoints = input->GetPointData();
  auto status = ReadCells(input, mesh);
  status = status ? TakeOr(onCells, names::MaterialIds, cells, "cells", 1, mesh.materials) : status;
  status = status ? TakeOr(onCells, names::LayerIds, cells, "cells", 0, mesh.layers) : status;
  status = status ? TakeOr(onPoints, names::LayerIndex, nodes, "points", -1, mesh.layerIndex) : status;
  status = status ? TakeOr(onPoints, names::InterfaceNodeIds, nodes, "points", Id(-1), mesh.interfaceNodeIds)
                  : status;
  if (!status)
  {
    return status.GetError();
  }
  return mesh;
}

void WriteGrid(const VolumeMesh& mesh, vtkUnstructuredGrid* output)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(MakeArray<vtkIdTypeArray>("", mesh.offsets),
                 MakeArray<vtkIdTypeArray>("", mesh.connectivity));
  auto types = MakeArray<vtkUnsignedCharArray>("", mesh.types);
  output->SetPoints(MakePoints(mesh.points));
  output->SetCells(types, cells);
  SetOrRemove<vtkIntArray>(output->GetCellData(), names::MaterialIds, mesh.materials);
  SetOrRemove<vtkIntArray>(output->GetCellData(), names::LayerIds, mesh.layers);
  SetOrRemove<vtkIntArray>(output->GetPointData(), names::LayerIndex, mesh.layerIndex);
  SetOrRemove<vtkIdTypeArray>(output->GetPointData(), names::InterfaceNodeIds, mesh.interfaceNodeIds);
  output->GetCellData()->SetActiveScalars(names::MaterialIds);
  AttachMaterialList(output, DistinctValues(mesh.materials));
}

void WriteNodeIds(vtkUnstructuredGrid* output)
{
  std::vector<Id> ids(static_cast<std::size_t>(output->GetNumberOfPoints()));
  std::iota(ids.begin(), ids.end(), Id{ 0 });
  output->GetPointData()->AddArray(MakeArray<vtkIdTypeArray>(names::GlobalNodeIds, ids));
}

} // namespace lamina
