// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFluidSolidMesh.h"

#include "AlgorithmMonitor.h"
#include "Arrays.h"
#include "GridBridge.h"
#include "MeshArrayNames.h"
#include "NameList.h"
#include "NamedParts.h"
#include "PatchBridge.h"
#include "Report.h"
#include "Stage.h"
#include "SurfaceBridge.h"

#include "Base/Text.h"
#include "Mesh/SplitInterfaces.h"
#include "Volume/AssembleMesh.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkFluidSolidMesh);

namespace
{

/// Add the field data of a part that `output` does not have yet.
void KeepFieldData(vtkUnstructuredGrid* part, vtkUnstructuredGrid* output)
{
  vtkFieldData* from = part->GetFieldData();
  vtkFieldData* to = output->GetFieldData();
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = from->GetAbstractArray(a);
    if (array && array->GetName() && !to->GetAbstractArray(array->GetName()))
    {
      to->AddArray(array);
    }
  }
}

lamina::Report Describe(const lamina::AssembleMeshReport& report, const lamina::MeshPatches& patches,
                        lamina::Id twins)
{
  std::vector<lamina::Report> rows;
  for (const lamina::MeshPatch& patch : patches.patches)
  {
    rows.emplace_back();
    rows.back().Add("name", patch.name).Add("kind", lamina::KindName(patch.kind));
    rows.back().Add("materials", std::vector<int>{ patch.pair.first, patch.pair.second });
    rows.back().Add("faces", patch.faces).Add("area", patch.area);
    rows.back().Add("centre", std::vector<double>{ patch.centre.x, patch.centre.y, patch.centre.z });
  }
  return lamina::Report()
    .Add("points", report.points + twins)
    .Add("cells", report.cells)
    .Add("mergedPoints", report.mergedPoints)
    .Add("doubledNodes", twins)
    .Add("patches", rows)
    .Tell(lamina::Amount(report.cells, "cell") + ", " + lamina::Amount(report.points + twins, "point") +
          ", " + lamina::Amount(static_cast<lamina::Id>(rows.size()), "patch", "patches"));
}

/// The inputs as the kernel's meshes; their field data goes to `output`.
lamina::Result<std::vector<lamina::VolumeMesh>> ReadParts(vtkInformationVector* inputs,
                                                          vtkUnstructuredGrid* output)
{
  std::vector<lamina::VolumeMesh> parts;
  for (int i = 0; i < inputs->GetNumberOfInformationObjects(); ++i)
  {
    vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputs, i);
    if (lamina::IsEmpty(input))
    {
      continue;
    }
    auto part = lamina::ReadGrid(input);
    if (!part)
    {
      return lamina::InvalidInput("part " + std::to_string(i + 1) + ": " + part.GetError().message);
    }
    parts.push_back(std::move(*part));
    KeepFieldData(input, output);
  }
  return parts;
}

/// Scale and unit, for whoever writes the mesh.
void WriteLengths(vtkUnstructuredGrid* output, double scale, const std::string& unit)
{
  output->GetFieldData()->AddArray(
    lamina::MakeArray<vtkDoubleArray>(lamina::names::LengthScale, std::vector<double>{ scale }));
  if (!unit.empty())
  {
    vtkNew<vtkStringArray> text;
    text->SetName(lamina::names::LengthUnit);
    text->InsertNextValue(unit);
    output->GetFieldData()->AddArray(text);
  }
}

} // namespace

vtkFluidSolidMesh::vtkFluidSolidMesh()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(4);
}

void vtkFluidSolidMesh::AddFluidMaterial(int material)
{
  this->FluidMaterials.push_back(material);
  this->Modified();
}

void vtkFluidSolidMesh::ClearFluidMaterials()
{
  this->FluidMaterials.clear();
  this->Modified();
}

int vtkFluidSolidMesh::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    return 1;
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return 1;
}

int vtkFluidSolidMesh::FillOutputPortInformation(int port, vtkInformation* info)
{
  const char* const types[] = { "vtkUnstructuredGrid", "vtkPolyData", "vtkTable",
                                "vtkPartitionedDataSetCollection" };
  info->Set(vtkDataObject::DATA_TYPE_NAME(), types[port]);
  return 1;
}

int vtkFluidSolidMesh::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                   vtkInformationVector* outputs)
{
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputs);
  lamina::AlgorithmMonitor monitor(this);
  const auto work = [&]() -> lamina::Status
  {
    auto parts = ReadParts(inputs[0], output);
    if (!parts)
    {
      return parts.GetError();
    }
    const auto names = lamina::ParseNames(this->Names);
    if (!names)
    {
      return names.GetError();
    }
    if (!(this->Scale > 0))
    {
      return lamina::InvalidOption("Scale must be above 0");
    }
    if (parts->empty())
    {
      return lamina::Done{};
    }
    const auto surface = lamina::ReadSideSurface(vtkPolyData::GetData(inputs[1]), monitor);
    if (!surface)
    {
      return surface.GetError();
    }
    const lamina::TriangleComplex* withSurface = surface->triangles.empty() ? nullptr : &*surface;
    std::vector<const lamina::VolumeMesh*> list;
    for (const lamina::VolumeMesh& part : *parts)
    {
      list.push_back(&part);
    }
    lamina::VolumeMesh mesh;
    lamina::SubMonitor joining(monitor, 0, 0.4);
    const auto joined = lamina::AssembleMesh(list, { this->Scale }, mesh, joining);
    if (!joined)
    {
      return joined.GetError();
    }
    parts->clear();
    lamina::MeshPatches patches;
    lamina::SubMonitor naming(monitor, 0.4, 0.9);
    const auto found = lamina::FindPatches(mesh, withSurface, { this->Scale, *names }, patches, naming);
    if (!found)
    {
      return found.GetError();
    }
    for (const std::string& name : found->unusedNames)
    {
      vtkWarningMacro("Names: there is neither a material nor a patch " << name
                                                                        << "; see the table of patches");
    }
    lamina::Id doubled = 0;
    std::vector<lamina::Id> twins;
    if (this->InterfaceNodes == DOUBLED)
    {
      const auto split = lamina::SplitInterfaces(mesh, this->FluidMaterials, twins, monitor);
      if (!split)
      {
        return split.GetError();
      }
      doubled = split->twins;
    }
    lamina::WriteGrid(mesh, output);
    lamina::WriteNodeIds(output);
    lamina::SetOrRemove<vtkIdTypeArray>(output->GetPointData(), lamina::names::TwinNodeIds, twins);
    lamina::WritePatches(patches, output);
    WriteLengths(output, this->Scale, this->Unit);
    lamina::WriteBoundary(mesh, patches, vtkPolyData::GetData(outputs, 1));
    lamina::WritePatchTable(patches, vtkTable::GetData(outputs, 2));
    if (this->NamedParts)
    {
      lamina::WriteNamedParts(mesh, patches, vtkPartitionedDataSetCollection::GetData(outputs, 3));
    }
    lamina::AttachReport(output, "FluidSolidMesh", Describe(*joined, patches, doubled));
    return lamina::Done{};
  };
  return lamina::RunStage(this, work);
}

const char* vtkFluidSolidMesh::GetSummary()
{
  return lamina::SummaryOf(this, "FluidSolidMesh");
}

void vtkFluidSolidMesh::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "Unit: " << this->Unit << "\n";
  os << indent << "Names: " << this->Names << "\n";
  os << indent << "InterfaceNodes: " << this->InterfaceNodes << "\n";
  os << indent << "FluidMaterials: " << lamina::Listed(this->FluidMaterials) << "\n";
  os << indent << "NamedParts: " << this->NamedParts << "\n";
}
