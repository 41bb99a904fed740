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
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

namespace lamina
{

namespace
{

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

} // namespace

void WriteBoundary(const VolumeMesh& mesh, const MeshPatches& patches, vtkPolyData* output, int only)
{
  std::vector<Id> numberOf(mesh.points.size(), -1);
  std::vector<Id> nodes;
  std::vector<Vec3> points;
  std::vector<Id> interfaceNodes;
  std::vector<Id> connectivity;
  std::vector<Id> offsets{ 0 };
  std::vector<int> ids;
  std::vector<int> labels;
  for (const PatchFace& face : patches.faces)
  {
    if (only >= 0 && face.patch != only)
    {
      continue;
    }
    const CellFace corners = FaceOf(mesh, face.cell, face.face);
    for (std::size_t k = 0; k < (corners.IsQuad() ? 4u : 3u); ++k)
    {
      Id& number = numberOf[Index(corners.corners[k])];
      if (number < 0)
      {
        number = static_cast<Id>(nodes.size());
        nodes.push_back(corners.corners[k]);
        points.push_back(mesh.points[Index(nodes.back())]);
        interfaceNodes.push_back(mesh.interfaceNodeIds.empty() ? -1
                                                               : mesh.interfaceNodeIds[Index(nodes.back())]);
      }
      connectivity.push_back(number);
    }
    offsets.push_back(static_cast<Id>(connectivity.size()));
    ids.push_back(face.patch);
    const MaterialPair& pair = patches.patches[Index(face.patch)].pair;
    labels.insert(labels.end(), { pair.first, pair.second });
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(MakeArray<vtkIdTypeArray>("", offsets), MakeArray<vtkIdTypeArray>("", connectivity));
  output->SetPoints(MakePoints(points));
  output->SetPolys(cells);
  output->GetCellData()->AddArray(MakeArray<vtkIntArray>(names::PatchIds, ids));
  output->GetCellData()->AddArray(MakeArray<vtkIntArray>(names::BoundaryLabels, labels, 2));
  output->GetPointData()->AddArray(MakeArray<vtkIdTypeArray>(names::GlobalNodeIds, nodes));
  output->GetPointData()->AddArray(MakeArray<vtkIdTypeArray>(names::InterfaceNodeIds, interfaceNodes));
  std::vector<std::string> patchNames;
  for (const MeshPatch& patch : patches.patches)
  {
    patchNames.push_back(patch.name);
  }
  output->GetFieldData()->AddArray(MakeStrings(names::PatchNames, patchNames));
}

void WritePatchTable(const MeshPatches& patches, vtkTable* table)
{
  std::vector<std::string> patchNames;
  std::vector<std::string> kinds;
  std::vector<int> first;
  std::vector<int> second;
  std::vector<Id> faces;
  std::array<std::vector<double>, 4> figures;
  for (const MeshPatch& patch : patches.patches)
  {
    patchNames.push_back(patch.name);
    kinds.emplace_back(KindName(patch.kind));
    first.push_back(patch.pair.first);
    second.push_back(patch.pair.second);
    faces.push_back(patch.faces);
    figures[0].push_back(patch.area);
    for (int k = 0; k < 3; ++k)
    {
      figures[static_cast<std::size_t>(k) + 1].push_back(patch.centre[k]);
    }
  }
  table->AddColumn(MakeStrings("Name", patchNames));
  table->AddColumn(MakeStrings("Kind", kinds));
  table->AddColumn(MakeArray<vtkIntArray>("MaterialA", first));
  table->AddColumn(MakeArray<vtkIntArray>("MaterialB", second));
  table->AddColumn(MakeArray<vtkIdTypeArray>("Faces", faces));
  const char* const columns[] = { "Area", "X", "Y", "Z" };
  for (std::size_t k = 0; k < 4; ++k)
  {
    table->AddColumn(MakeArray<vtkDoubleArray>(columns[k], figures[k]));
  }
}

} // namespace lamina
