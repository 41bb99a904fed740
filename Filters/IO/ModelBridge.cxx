// SPDX-License-Identifier: BSD-3-Clause
#include "ModelBridge.h"

#include "Arrays.h"
#include "GridBridge.h"
#include "MeshArrayNames.h"
#include "PatchBridge.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

namespace lamina
{
namespace
{

/// The linear type and the number of corners of a quadratic cell; 0 for another.
int LinearType(int type)
{
  switch (type)
  {
    case VTK_QUADRATIC_TETRA:
      return VTK_TETRA;
    case VTK_QUADRATIC_WEDGE:
      return VTK_WEDGE;
    case VTK_QUADRATIC_PYRAMID:
      return VTK_PYRAMID;
    default:
      return 0;
  }
}

/// The corners of quadratic cells as a linear grid over the same points; middle nodes go to the model.
Status SplitQuadratic(vtkUnstructuredGrid* grid, vtkUnstructuredGrid* linear, MeshModel& model)
{
  linear->SetPoints(grid->GetPoints());
  linear->GetCellData()->ShallowCopy(grid->GetCellData());
  linear->GetPointData()->ShallowCopy(grid->GetPointData());
  linear->GetFieldData()->ShallowCopy(grid->GetFieldData());
  linear->AllocateEstimate(grid->GetNumberOfCells(), 6);
  model.middleOffsets = { 0 };
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    grid->GetCells()->GetCellAtId(c, size, ids);
    const int type = LinearType(grid->GetCellType(c));
    if (type == 0)
    {
      return InvalidInput("cell " + std::to_string(c) + " is of VTK's type " +
                          std::to_string(grid->GetCellType(c)) +
                          ": the cells of a mesh must be all linear or all quadratic");
    }
    const int corners = NodeCount(static_cast<CellType>(type));
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (ids[i] < 0 || ids[i] >= grid->GetNumberOfPoints())
      {
        return InvalidInput("cell " + std::to_string(c) + " refers to a point that does not exist");
      }
    }
    linear->InsertNextCell(type, corners, ids);
    model.middles.insert(model.middles.end(), ids + corners, ids + size);
    model.middleOffsets.push_back(static_cast<Id>(model.middles.size()));
  }
  return Done{};
}

Status ReadFibers(vtkUnstructuredGrid* grid, MeshModel& model)
{
  const auto values =
    ReadValues<double>(grid->GetCellData(), names::Fibers, grid->GetNumberOfCells(), 3, "cells");
  if (!values)
  {
    return values.GetError();
  }
  for (std::size_t i = 0; i + 2 < values->size(); i += 3)
  {
    model.fibers.push_back({ (*values)[i], (*values)[i + 1], (*values)[i + 2] });
  }
  return Done{};
}

} // namespace

Result<MeshModel> ReadModel(vtkUnstructuredGrid* grid, bool& isFoundAnew, Monitor& monitor)
{
  MeshModel model;
  vtkNew<vtkUnstructuredGrid> corners;
  vtkUnstructuredGrid* linear = grid;
  if (grid->GetNumberOfCells() > 0 && LinearType(grid->GetCellType(0)) != 0)
  {
    const Status split = SplitQuadratic(grid, corners, model);
    if (!split)
    {
      return split.GetError();
    }
    linear = corners;
  }
  auto mesh = ReadGrid(linear, WithoutMaterials::TakeAsOne);
  if (!mesh)
  {
    return mesh.GetError();
  }
  model.mesh = std::move(*mesh);
  bool isStale = false;
  model.patches = ReadPatches(linear, model.mesh, isStale);
  isFoundAnew = isStale || !grid->GetFieldData()->HasArray(names::PatchFaces);
  if (isFoundAnew)
  {
    const auto materialNames = model.patches.materialNames;
    FindPatchesOptions options;
    for (const auto& [material, name] : materialNames)
    {
      options.names[std::to_string(material)] = name;
    }
    const auto found = FindPatches(model.mesh, nullptr, options, model.patches, monitor);
    if (!found)
    {
      return found.GetError();
    }
  }
  auto twins =
    ReadValues<Id>(grid->GetPointData(), names::TwinNodeIds, grid->GetNumberOfPoints(), 1, "points");
  if (!twins)
  {
    return twins.GetError();
  }
  model.twins = std::move(*twins);
  auto* unit = vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray(names::LengthUnit));
  model.unit = unit && unit->GetNumberOfValues() == 1 ? std::string(unit->GetValue(0)) : "";
  const Status fibers = ReadFibers(grid, model);
  return fibers ? Result<MeshModel>(std::move(model)) : Result<MeshModel>(fibers.GetError());
}

} // namespace lamina
