// SPDX-License-Identifier: BSD-3-Clause
// Between a mesh's patches in the kernel and in VTK: field data that travels with the grid, a surface, a
// table.
#pragma once

#include "Stage.h"

#include "Mesh/MeshPatches.h"

class vtkPolyData;
class vtkTable;
class vtkUnstructuredGrid;

namespace lamina
{

/// Put the patches' names and faces on the grid's field data; if there are none, take away those that are
/// there.
void WritePatches(const MeshPatches& patches, vtkUnstructuredGrid* grid);

/// Read them back. Empty if the grid has none, or if its cells are no longer those that the patches were
/// found on (it was cut or joined since); `isStale` then tells.
MeshPatches ReadPatches(vtkUnstructuredGrid* grid, const VolumeMesh& mesh, bool& isStale);

/// Read them back, or say that there are none.
Result<MeshPatches> RequirePatches(vtkUnstructuredGrid* grid, const VolumeMesh& mesh);

/// Read them as they are, for the audit: faces may be wrong, only the arrays' shapes are tested. False if
/// there are none.
bool ReadRawPatches(vtkUnstructuredGrid* grid, MeshPatches& patches);

/// The patches as a surface: triangles and quads with PatchIds and BoundaryLabels, points with GlobalNodeIds
/// and InterfaceNodeIds. With `only` one patch.
void WriteBoundary(const VolumeMesh& mesh, const MeshPatches& patches, vtkPolyData* output, int only = -1);

/// A row a patch: Name, Kind, MaterialA, MaterialB, Faces, Area, X, Y, Z.
void WritePatchTable(const MeshPatches& patches, vtkTable* table);

/// "interface", "wall", "border" or "opening".
const char* KindName(PatchKind kind);

} // namespace lamina
