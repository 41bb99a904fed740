// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPrismLayer.h"

#include "AlgorithmMonitor.h"
#include "GridBridge.h"
#include "LayerReport.h"
#include "MeshArrayNames.h"
#include "Report.h"
#include "Stage.h"
#include "SurfaceBridge.h"

#include "Mesh/Adjacency.h"
#include "Volume/PrismLayers.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkPrismLayer);

vtkPrismLayer::vtkPrismLayer()
{
  this->SetNumberOfOutputPorts(3);
}

void vtkPrismLayer::AddFluidMaterial(int material)
{
  this->FluidMaterials.push_back(material);
  this->Modified();
}

void vtkPrismLayer::ClearFluidMaterials()
{
  this->FluidMaterials.clear();
  this->Modified();
}

int vtkPrismLayer::GetFluidMaterial(int index)
{
  const bool known = index >= 0 && index < this->GetNumberOfFluidMaterials();
  return known ? this->FluidMaterials[static_cast<std::size_t>(index)] : -1;
}

void vtkPrismLayer::AddNeighbourMaterial(int material)
{
  this->NeighbourMaterials.push_back(material);
  this->Modified();
}

void vtkPrismLayer::ClearNeighbourMaterials()
{
  this->NeighbourMaterials.clear();
  this->Modified();
}

int vtkPrismLayer::GetNeighbourMaterial(int index)
{
  const bool known = index >= 0 && index < this->GetNumberOfNeighbourMaterials();
  return known ? this->NeighbourMaterials[static_cast<std::size_t>(index)] : -1;
}

void vtkPrismLayer::AddWallPatchId(int patch)
{
  this->WallPatchIds.push_back(patch);
  this->Modified();
}

void vtkPrismLayer::ClearWallPatchIds()
{
  this->WallPatchIds.clear();
  this->Modified();
}

int vtkPrismLayer::GetWallPatchId(int index)
{
  const bool known = index >= 0 && index < this->GetNumberOfWallPatchIds();
  return known ? this->WallPatchIds[static_cast<std::size_t>(index)] : -1;
}

int vtkPrismLayer::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkPrismLayer::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  return 1;
}

int vtkPrismLayer::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkUnstructuredGrid* prisms = vtkUnstructuredGrid::GetData(outputs, 0);
  vtkPolyData* inner = vtkPolyData::GetData(outputs, 1);
  vtkPolyData* walls = vtkPolyData::GetData(outputs, 2);
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
    const auto known = lamina::CheckMaterials(this->FluidMaterials, present, "FluidMaterials");
    const bool asDefault = this->FluidMaterials == std::vector<int>{ 2 };
    if (!known && !asDefault)
    {
      return known;
    }
    walls->ShallowCopy(input);
    lamina::WriteSurface(*surface, walls);
    if (!known || this->FluidMaterials.empty())
    {
      vtkWarningMacro("no fluid among the materials " << lamina::Listed(present)
                                                      << ": this part of the mesh is empty");
      return lamina::Done{};
    }
    if (const auto sized = lamina::RequireThickness(*surface); !sized)
    {
      return sized;
    }
    const lamina::PrismLayersOptions options{ this->FluidMaterials,     this->Layers,
                                              this->GrowthRatio,        this->Thickness,
                                              this->TotalThickness,     this->FirstHeight,
                                              this->LeastQuality,       this->EndColumns,
                                              this->NeighbourMaterials, this->WallPatchIds };
    lamina::VolumeMesh mesh;
    lamina::TriangleComplex front;
    lamina::LayersOnSurface layers;
    const auto report = lamina::GrowPrismLayers(*surface, options, mesh, front, layers, monitor);
    if (!report)
    {
      return report.GetError();
    }
    lamina::WriteGrid(mesh, prisms);
    prisms->GetCellData()->SetActiveScalars(lamina::names::LayerIds);
    lamina::WriteSurface(front, inner);
    lamina::WriteLayers(layers.achieved, layers.fraction, walls);
    lamina::AttachReport(prisms, "PrismLayer", lamina::DescribeLayers(*report));
    lamina::WarnOfStoppedColumns(this, *report);
    return lamina::Done{};
  };
  return lamina::RunStage(this, work);
}

const char* vtkPrismLayer::GetSummary()
{
  return lamina::SummaryOf(this, "PrismLayer");
}

void vtkPrismLayer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FluidMaterials: " << lamina::Listed(this->FluidMaterials) << "\n";
  os << indent << "Layers: " << this->Layers << "\n";
  os << indent << "GrowthRatio: " << this->GrowthRatio << "\n";
  os << indent << "Thickness: " << this->Thickness << "\n";
  os << indent << "TotalThickness: " << this->TotalThickness << "\n";
  os << indent << "FirstHeight: " << this->FirstHeight << "\n";
  os << indent << "LeastQuality: " << this->LeastQuality << "\n";
  os << indent << "EndColumns: " << this->EndColumns << "\n";
  os << indent << "NeighbourMaterials: " << lamina::Listed(this->NeighbourMaterials) << "\n";
  os << indent << "WallPatchIds: " << lamina::Listed(this->WallPatchIds) << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
}
