// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshEstimate.h"

#include "AlgorithmMonitor.h"
#include "LayerReport.h"
#include "MeshArrayNames.h"
#include "Report.h"
#include "Stage.h"
#include "SurfaceBridge.h"

#include "Base/Text.h"
#include "Mesh/Adjacency.h"
#include "Volume/MeshEstimate.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkMeshEstimate);

namespace
{

constexpr double bytesPerMegabyte = 1024.0 * 1024.0;

void FillTable(const lamina::MeshEstimate& estimate, vtkTable* table)
{
  vtkNew<vtkStringArray> names;
  names->SetName("Stage");
  vtkNew<vtkIdTypeArray> cells;
  cells->SetName("Cells");
  vtkNew<vtkDoubleArray> memory;
  memory->SetName("Memory");
  const auto add = [&](const std::string& name, double count, double bytes)
  {
    names->InsertNextValue(name);
    cells->InsertNextValue(static_cast<vtkIdType>(count));
    memory->InsertNextValue(bytes / bytesPerMegabyte);
  };
  for (const lamina::PlannedStage& stage : estimate.stages)
  {
    add(stage.name, stage.demand.cells, stage.demand.bytes);
  }
  add("all", estimate.cells, estimate.bytes);
  table->AddColumn(names);
  table->AddColumn(cells);
  table->AddColumn(memory);
}

lamina::Report Describe(const lamina::MeshEstimate& estimate, double free)
{
  std::vector<lamina::Report> stages;
  for (const lamina::PlannedStage& stage : estimate.stages)
  {
    stages.emplace_back();
    stages.back()
      .Add("stage", stage.name)
      .Add("cells", static_cast<lamina::Id>(stage.demand.cells))
      .Add("memoryMB", stage.demand.bytes / bytesPerMegabyte);
  }
  return lamina::Report()
    .Add("stages", stages)
    .Add("cells", static_cast<lamina::Id>(estimate.cells))
    .Add("memoryMB", estimate.bytes / bytesPerMegabyte)
    .Add("freeMB", free / bytesPerMegabyte)
    .Add("fits", estimate.bytes <= free)
    .Tell("about " + lamina::Amount(static_cast<lamina::Id>(estimate.cells), "cell") + ", " +
          lamina::MemoryText(estimate.bytes) + " of memory at the peak, " + lamina::MemoryText(free) +
          " free");
}

} // namespace

void vtkMeshEstimate::AddFluidMaterial(int material)
{
  this->FluidMaterials.push_back(material);
  this->Modified();
}

void vtkMeshEstimate::ClearFluidMaterials()
{
  this->FluidMaterials.clear();
  this->Modified();
}

int vtkMeshEstimate::GetFluidMaterial(int index)
{
  const bool known = index >= 0 && index < this->GetNumberOfFluidMaterials();
  return known ? this->FluidMaterials[static_cast<std::size_t>(index)] : -1;
}

int vtkMeshEstimate::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkMeshEstimate::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                 vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkTable* table = vtkTable::GetData(outputs);
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
    if (const auto sized = lamina::RequireTargetEdgeLength(*surface, lamina::names::TargetEdgeLength); !sized)
    {
      return sized;
    }
    lamina::MeshPlan plan;
    const std::vector<int> present = lamina::MaterialsOf(*surface);
    plan.solids = lamina::Without(present, this->FluidMaterials);
    plan.fluids = lamina::Without(present, plan.solids);
    plan.layers = this->Layers;
    plan.prismLayers = this->PrismLayers;
    const lamina::MeshEstimate estimate = lamina::EstimateMesh(*surface, plan);
    const double free = monitor.FreeMemory();
    FillTable(estimate, table);
    lamina::AttachReport(table, "MeshEstimate", Describe(estimate, free));
    if (estimate.bytes > free)
    {
      vtkWarningMacro("the mesh takes about " << lamina::MemoryText(estimate.bytes)
                                              << " of memory at its peak, " << lamina::MemoryText(free)
                                              << " are free");
    }
    return lamina::Done{};
  };
  return lamina::RunStage(this, work);
}

const char* vtkMeshEstimate::GetSummary()
{
  return lamina::SummaryOf(this, "MeshEstimate");
}

void vtkMeshEstimate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FluidMaterials: " << lamina::Listed(this->FluidMaterials) << "\n";
  os << indent << "Layers: " << this->Layers << "\n";
  os << indent << "PrismLayers: " << this->PrismLayers << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
}
