// SPDX-License-Identifier: BSD-3-Clause
#include "PatchBridge.h"

#include "Arrays.h"
#include "MeshArrayNames.h"

#include "Mesh/CellFaces.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>

namespace lamina
{

namespace
{

constexpr int FaceParts = 5;

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

/// The field data's arrays that hold the patches; null where one is missing or misshapen.
struct PatchArrays
{
  vtkStringArray* names;
  vtkDataArray* kinds;
  vtkDataArray* pairs;
  vtkDataArray* faces;
  vtkDataArray* cells;
  vtkStringArray* materials;
  vtkDataArray* named;

  explicit PatchArrays(vtkFieldData* field)
    : names(vtkStringArray::SafeDownCast(field->GetAbstractArray(names::PatchNames)))
    , kinds(field->GetArray(names::PatchKinds))
    , pairs(field->GetArray(names::PatchMaterials))
    , faces(field->GetArray(names::PatchFaces))
    , cells(field->GetArray(names::PatchedCells))
    , materials(vtkStringArray::SafeDownCast(field->GetAbstractArray(names::MaterialNames)))
    , named(field->GetArray(names::NamedMaterials))
  {
  }
  bool AreThere() const { return this->names && this->kinds && this->pairs && this->faces && this->cells; }
  bool AreSound() const
  {
    const vtkIdType count = this->names->GetNumberOfValues();
    return this->kinds->GetNumberOfTuples() == count && this->pairs->GetNumberOfTuples() == count &&
           this->kinds->GetNumberOfComponents() == 1 && this->pairs->GetNumberOfComponents() == 2 &&
           this->faces->GetNumberOfComponents() == FaceParts && this->cells->GetNumberOfTuples() == 1;
  }
};

/// Patches and faces from sound arrays, untested.
void TakeRows(const PatchArrays& arrays, MeshPatches& read)
{
  for (vtkIdType p = 0; p < arrays.names->GetNumberOfValues(); ++p)
  {
    MeshPatch patch;
    patch.name = arrays.names->GetValue(p);
    patch.kind = static_cast<PatchKind>(static_cast<int>(arrays.kinds->GetComponent(p, 0)));
    patch.pair = { static_cast<int>(arrays.pairs->GetComponent(p, 0)),
                   static_cast<int>(arrays.pairs->GetComponent(p, 1)) };
    read.patches.push_back(patch);
  }
  for (vtkIdType f = 0; f < arrays.faces->GetNumberOfTuples(); ++f)
  {
    const auto part = [&](int k) { return static_cast<Id>(arrays.faces->GetComponent(f, k)); };
    read.faces.push_back(
      { part(0), static_cast<int>(part(1)), static_cast<int>(part(2)), part(3), static_cast<int>(part(4)) });
  }
}

bool IsFaceOf(const VolumeMesh& mesh, Id cell, int face, int material)
{
  return cell >= 0 && cell < mesh.CellCount() && face >= 0 && face < FaceCount(mesh.types[Index(cell)]) &&
         mesh.materials[Index(cell)] == material;
}

/// True if the face lies where the patch says.
bool Fits(const VolumeMesh& mesh, const PatchFace& face, const MeshPatch& patch)
{
  if (!IsFaceOf(mesh, face.cell, face.face, patch.pair.first))
  {
    return false;
  }
  if (patch.kind != PatchKind::Interface)
  {
    return true;
  }
  if (!IsFaceOf(mesh, face.otherCell, face.otherFace, patch.pair.second))
  {
    return false;
  }
  // The same place, by nodes that may be twins.
  const CellFace a = FaceOf(mesh, face.cell, face.face);
  const CellFace b = FaceOf(mesh, face.otherCell, face.otherFace);
  const std::size_t n = a.IsQuad() ? 4 : 3;
  bool fits = a.IsQuad() == b.IsQuad();
  for (std::size_t i = 0; i < n && fits; ++i)
  {
    bool isThere = false;
    for (std::size_t j = 0; j < n; ++j)
    {
      isThere = isThere || mesh.points[Index(a.corners[i])] == mesh.points[Index(b.corners[j])];
    }
    fits = isThere;
  }
  return fits;
}

} // namespace

const char* KindName(PatchKind kind)
{
  switch (kind)
  {
    case PatchKind::Interface:
      return "interface";
    case PatchKind::Border:
      return "border";
    case PatchKind::Opening:
      return "opening";
    default:
      return "wall";
  }
}

void WritePatches(const MeshPatches& patches, vtkUnstructuredGrid* grid)
{
  std::vector<std::string> patchNames;
  std::vector<int> kinds;
  std::vector<int> pairs;
  for (const MeshPatch& patch : patches.patches)
  {
    patchNames.push_back(patch.name);
    kinds.push_back(static_cast<int>(patch.kind));
    pairs.push_back(patch.pair.first);
    pairs.push_back(patch.pair.second);
  }
  std::vector<Id> faces;
  faces.reserve(FaceParts * patches.faces.size());
  for (const PatchFace& face : patches.faces)
  {
    faces.insert(faces.end(), { face.cell, face.face, face.patch, face.otherCell, face.otherFace });
  }
  std::vector<int> named;
  std::vector<std::string> materialNames;
  for (const auto& [material, name] : patches.materialNames)
  {
    named.push_back(material);
    materialNames.push_back(name);
  }
  vtkFieldData* field = grid->GetFieldData();
  if (patches.faces.empty())
  {
    for (const char* name : { names::PatchNames, names::PatchKinds, names::PatchMaterials, names::PatchFaces,
                              names::PatchedCells })
    {
      field->RemoveArray(name);
    }
    return;
  }
  field->AddArray(MakeStrings(names::PatchNames, patchNames));
  field->AddArray(MakeArray<vtkIntArray>(names::PatchKinds, kinds));
  field->AddArray(MakeArray<vtkIntArray>(names::PatchMaterials, pairs, 2));
  field->AddArray(MakeArray<vtkIdTypeArray>(names::PatchFaces, faces, FaceParts));
  field->AddArray(
    MakeArray<vtkIdTypeArray>(names::PatchedCells, std::vector<Id>{ grid->GetNumberOfCells() }));
  if (!named.empty())
  {
    field->AddArray(MakeStrings(names::MaterialNames, materialNames));
    field->AddArray(MakeArray<vtkIntArray>(names::NamedMaterials, named));
    const auto ids =
      ReadValues<int>(grid->GetCellData(), names::MaterialIds, grid->GetNumberOfCells(), 1, "cells");
    AttachMaterialList(grid, ids ? DistinctValues(*ids) : named, patches.materialNames);
  }
}

MeshPatches ReadPatches(vtkUnstructuredGrid* grid, const VolumeMesh& mesh, bool& isStale)
{
  const PatchArrays arrays(grid->GetFieldData());
  MeshPatches read;
  if (arrays.materials && arrays.named &&
      arrays.materials->GetNumberOfValues() == arrays.named->GetNumberOfTuples())
  {
    for (vtkIdType m = 0; m < arrays.materials->GetNumberOfValues(); ++m)
    {
      read.materialNames[static_cast<int>(arrays.named->GetComponent(m, 0))] = arrays.materials->GetValue(m);
    }
  }
  isStale = false;
  if (!arrays.AreThere())
  {
    return read;
  }
  const MeshPatches none{ {}, {}, read.materialNames };
  isStale = !arrays.AreSound() || static_cast<Id>(arrays.cells->GetComponent(0, 0)) != mesh.CellCount();
  if (!isStale)
  {
    TakeRows(arrays, read);
  }
  for (std::size_t f = 0; f < read.faces.size() && !isStale; ++f)
  {
    const PatchFace& face = read.faces[f];
    isStale = face.patch < 0 || Index(face.patch) >= read.patches.size() ||
              !Fits(mesh, face, read.patches[Index(face.patch)]);
    if (!isStale)
    {
      AddToPatch(mesh, FaceOf(mesh, face.cell, face.face).corners, read.patches[Index(face.patch)]);
    }
  }
  for (MeshPatch& patch : read.patches)
  {
    patch.centre *= patch.area > 0 ? 1 / patch.area : 0;
  }
  return isStale ? none : read;
}

Result<MeshPatches> RequirePatches(vtkUnstructuredGrid* grid, const VolumeMesh& mesh)
{
  bool isStale = false;
  MeshPatches patches = ReadPatches(grid, mesh, isStale);
  if (patches.patches.empty())
  {
    return InvalidInput("the mesh has no patches, or lost cells since they were named: run Fluid-Solid Mesh, "
                        "and this filter right after it");
  }
  return patches;
}

bool ReadRawPatches(vtkUnstructuredGrid* grid, MeshPatches& patches)
{
  const PatchArrays arrays(grid->GetFieldData());
  patches = {};
  if (!arrays.AreThere() || !arrays.AreSound())
  {
    return false;
  }
  TakeRows(arrays, patches);
  return true;
}

} // namespace lamina
