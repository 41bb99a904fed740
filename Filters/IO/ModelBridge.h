// SPDX-License-Identifier: BSD-3-Clause
// From vtkUnstructuredGrid to the kernel's MeshModel.
#pragma once

#include "Stage.h"

#include "Base/Monitor.h"
#include "Mesh/MeshModel.h"

class vtkUnstructuredGrid;

namespace lamina
{

/// Read linear or quadratic cells (all of one order), materials, layers, patches, fibres and the unit.
/// `isFoundAnew` tells that the grid's own patches were missing or no longer fit.
Result<MeshModel> ReadModel(vtkUnstructuredGrid* grid, bool& isFoundAnew, Monitor& monitor);

} // namespace lamina
