// SPDX-License-Identifier: BSD-3-Clause
// A mesh as a collection of named parts: materials, interfaces, walls, borders, openings.
#pragma once

#include "Mesh/MeshPatches.h"

class vtkPartitionedDataSetCollection;

namespace lamina
{

/// One vtkUnstructuredGrid a material and one vtkPolyData a patch, each with GlobalNodeIds (ids of `mesh`),
/// under the nodes of an assembly: Materials, Interfaces, Walls, Borders, Openings.
void WriteNamedParts(const VolumeMesh& mesh, const MeshPatches& patches,
                     vtkPartitionedDataSetCollection* output);

} // namespace lamina
