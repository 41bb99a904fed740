// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLayeredTetrahedra.h"

#include "AlgorithmMonitor.h"
#include "GridBridge.h"
#include "LayerReport.h"
#include "MeshArrayNames.h"
#include "Programs.h"
#include "Report.h"
#include "Stage.h"
#include "SurfaceBridge.h"

#include "Mesh/Adjacency.h"
#include "Volume/LayeredTets.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

vtkStandardNewMacro(vtkLayeredTetrahedra);

vtkLayeredTetrahedra::vtkLayeredTetrahedra()
{
  this->SetNumberOfOutputPorts(2);
}

void vtkLayeredTetrahedra::AddSolidMaterial(int material)
{
  this->SolidMaterials.push_back(material);
  this->Modified();
}

void vtkLayeredTetrahedra::ClearSolidMaterials()
{
  this->SolidMaterials.clear();
  this->Modified();
}

int vtkLayeredTetrahedra::GetSolidMaterial(int index)
{
  const bool known = index >= 0 && index < this->GetNumberOfSolidMaterials();
  return known ? this->SolidMaterials[static_cast<std::size_t>(index)] : -1;
}

void vtkLayeredTetrahedra::AddFluidMaterial(int material)
{
  this->FluidMaterials.push_back(material);
  this->Modified();
}

void vtkLayeredTetrahedra::ClearFluidMaterials()
{
  this->FluidMaterials.clear();
  this->Modified();
}

int vtkLayeredTetrahedra::GetFluidMaterial(int index)
{
  const bool known = index >= 0 && index < this->GetNumberOfFluidMaterials();
  return known ? this->FluidMaterials[static_cast<std::size_t>(index)] : -1;
}

int vtkLayeredTetrahedra::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkLayeredTetrahedra::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  return 1;
}

int vtkLayeredTetrahedra::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                      vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkUnstructuredGrid* tets = vtkUnstructuredGrid::GetData(outputs, 0);
  vtkPolyData* walls = vtkPolyData::GetData(outputs, 1);
  if (lamina::IsEmpty(input))
  {
    return 1;
  }
  lamina::AlgorithmMonitor monitor(this);
  monitor.LimitMemory(this->MemoryLimit);
  const auto work = [&]() -> lamina::Status
  {
    const auto surface = lamina::ReadSurface(input, monitor);
    if (!surface)
    {
      return surface.GetError();
    }
    const std::vector<int> present = lamina::MaterialsOf(*surface);
    if (const auto known = lamina::CheckMaterials(this->SolidMaterials, present, "SolidMaterials"); !known)
    {
      return known;
    }
    lamina::LayeredTetsOptions options;
    options.materials =
      this->SolidMaterials.empty() ? lamina::Without(present, this->FluidMaterials) : this->SolidMaterials;
    options.layers = this->Layers;
    options.anisotropy = this->Anisotropy;
    options.growth = this->Growth;
    options.core = { lamina::FindProgram("lamina-tetgen"), this->RadiusEdgeRatio, this->SizeFactor,
                     this->MaximumEdge };
    walls->ShallowCopy(input);
    lamina::WriteSurface(*surface, walls);
    if (options.materials.empty())
    {
      vtkWarningMacro("no solid among the materials " << lamina::Listed(present)
                                                      << ": this part of the mesh is empty");
      return lamina::Done{};
    }
    if (const auto sized = lamina::RequireThickness(*surface); !sized)
    {
      return sized;
    }
    lamina::VolumeMesh mesh;
    lamina::LayersOnSurface layers;
    const auto report = lamina::MeshLayeredTets(*surface, options, mesh, layers, monitor);
    if (!report)
    {
      return report.GetError();
    }
    lamina::WriteGrid(mesh, tets);
    tets->GetCellData()->SetActiveScalars(lamina::names::LayerIds);
    lamina::WriteLayers(layers.achieved, layers.fraction, walls);
    lamina::AttachReport(tets, "LayeredTetrahedra", lamina::DescribeLayers(*report));
    lamina::WarnOfStoppedColumns(this, *report);
    return lamina::Done{};
  };
  return lamina::RunStage(this, work);
}

const char* vtkLayeredTetrahedra::GetSummary()
{
  return lamina::SummaryOf(this, "LayeredTetrahedra");
}

void vtkLayeredTetrahedra::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SolidMaterials: " << lamina::Listed(this->SolidMaterials) << "\n";
  os << indent << "FluidMaterials: " << lamina::Listed(this->FluidMaterials) << "\n";
  os << indent << "Layers: " << this->Layers << "\n";
  os << indent << "Anisotropy: " << this->Anisotropy << "\n";
  os << indent << "Growth: " << this->Growth << "\n";
  os << indent << "RadiusEdgeRatio: " << this->RadiusEdgeRatio << "\n";
  os << indent << "SizeFactor: " << this->SizeFactor << "\n";
  os << indent << "MaximumEdge: " << this->MaximumEdge << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
}
