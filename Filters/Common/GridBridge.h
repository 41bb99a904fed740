// SPDX-License-Identifier: BSD-3-Clause
// Between vtkUnstructuredGrid and the kernel's VolumeMesh.
#pragma once

#include "Stage.h"

#include "Mesh/VolumeMesh.h"

class vtkUnstructuredGrid;

namespace lamina
{

/// What to make of a grid without MaterialIds.
enum class WithoutMaterials
{
  Refuse,
  TakeAsOne ///< all cells are of material 1
};

/// Read tetrahedra, wedges and pyramids; other cells are refused. Missing LayerIds become 0, missing
/// LayerIndex and InterfaceNodeIds -1.
Result<VolumeMesh> ReadGrid(vtkUnstructuredGrid* input, WithoutMaterials without = WithoutMaterials::Refuse);

/// Give `output` the mesh's points, cells and arrays. MaterialIds become the active scalars, which ParaView
/// shows.
void WriteGrid(const VolumeMesh& mesh, vtkUnstructuredGrid* output);
/// Number the points of a grid from 0 as GlobalNodeIds.
void WriteNodeIds(vtkUnstructuredGrid* output);

} // namespace lamina
