// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWallDepth.h"

#include "AlgorithmMonitor.h"
#include "Arrays.h"
#include "GridBridge.h"
#include "MeshArrayNames.h"
#include "NameList.h"
#include "PatchBridge.h"
#include "Report.h"
#include "Stage.h"

#include "Base/Text.h"
#include "Volume/WallDepth.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkWallDepth);

void vtkWallDepth::AddWallMaterial(int material)
{
  this->WallMaterials.push_back(material);
  this->Modified();
}

void vtkWallDepth::ClearWallMaterials()
{
  this->WallMaterials.clear();
  this->Modified();
}

int vtkWallDepth::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputs[0]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputs);
  if (lamina::IsEmpty(input))
  {
    return 1;
  }
  lamina::AlgorithmMonitor monitor(this);
  const auto work = [&]() -> lamina::Status
  {
    const auto mesh = lamina::ReadGrid(input);
    if (!mesh)
    {
      return mesh.GetError();
    }
    const lamina::Status known =
      lamina::CheckMaterials(this->WallMaterials, mesh->materials, "WallMaterials");
    if (!known)
    {
      return known;
    }
    const auto patches = lamina::RequirePatches(input, *mesh);
    if (!patches)
    {
      return patches.GetError();
    }
    lamina::WallDepthOptions options;
    options.materials = this->WallMaterials;
    options.inner = lamina::SplitNames(this->InnerWalls);
    options.outer = lamina::SplitNames(this->OuterWalls);
    lamina::WallDepthField field;
    const auto report = lamina::ComputeWallDepth(*mesh, *patches, options, field, monitor);
    if (!report)
    {
      return report.GetError();
    }
    output->ShallowCopy(input);
    lamina::SetOrRemove<vtkDoubleArray>(output->GetPointData(), lamina::names::WallDepth, field.points);
    lamina::SetOrRemove<vtkDoubleArray>(output->GetCellData(), lamina::names::WallDepth, field.cells);
    lamina::SetOrRemoveVectors(output->GetCellData(), lamina::names::LayerNormals, field.normals);
    lamina::AttachReport(output, "WallDepth",
                         lamina::Report()
                           .Add("cells", report->cells)
                           .Add("oneSided", report->oneSided)
                           .Add("contestedNodes", report->contestedNodes)
                           .Add("iterations", report->iterations)
                           .Tell(lamina::Amount(report->cells, "cell") + " with a depth, " +
                                 lamina::Amount(report->oneSided, "cell") + " without a second wall"));
    return lamina::Done{};
  };
  return lamina::RunStage(this, work);
}

const char* vtkWallDepth::GetSummary()
{
  return lamina::SummaryOf(this, lamina::names::WallDepth);
}

void vtkWallDepth::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "WallMaterials: " << lamina::Listed(this->WallMaterials) << "\n";
  os << indent << "InnerWalls: " << this->InnerWalls << "\n";
  os << indent << "OuterWalls: " << this->OuterWalls << "\n";
}
