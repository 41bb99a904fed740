// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPrismsToTetrahedra.h"

#include "AlgorithmMonitor.h"
#include "Arrays.h"
#include "GridBridge.h"
#include "MeshArrayNames.h"
#include "PatchBridge.h"
#include "Report.h"
#include "Stage.h"

#include "Base/Text.h"
#include "Mesh/SplitPrisms.h"

#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkPrismsToTetrahedra);

int vtkPrismsToTetrahedra::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                       vtkInformationVector* outputs)
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
    const auto mesh = lamina::ReadGrid(input, lamina::WithoutMaterials::TakeAsOne);
    if (!mesh)
    {
      return mesh.GetError();
    }
    bool isStale = false;
    lamina::MeshPatches patches = lamina::ReadPatches(input, *mesh, isStale);
    if (isStale)
    {
      vtkWarningMacro("the patches in the field data are not those of these cells, and are left out");
    }
    lamina::VolumeMesh tets;
    const auto report = lamina::SplitPrisms(*mesh, tets, &patches, monitor);
    if (!report)
    {
      return report.GetError();
    }
    lamina::WriteGrid(tets, output);
    output->GetFieldData()->ShallowCopy(input->GetFieldData());
    lamina::WritePatches(patches, output);
    lamina::WriteNodeIds(output);
    // Points in the middle of cells have no twin.
    auto twins = lamina::ReadValues<lamina::Id>(input->GetPointData(), lamina::names::TwinNodeIds,
                                                input->GetNumberOfPoints(), 1, "points");
    if (!twins)
    {
      return twins.GetError();
    }
    twins->resize(twins->empty() ? 0 : tets.points.size(), -1);
    lamina::SetOrRemove<vtkIdTypeArray>(output->GetPointData(), lamina::names::TwinNodeIds, *twins);
    lamina::AttachReport(output, "PrismsToTetrahedra",
                         lamina::Report()
                           .Add("splitCells", report->splitCells)
                           .Add("addedPoints", report->addedPoints)
                           .Add("turnedQuads", report->turnedQuads)
                           .Add("cells", tets.CellCount())
                           .Tell(lamina::Amount(report->splitCells, "cell") + " split, " +
                                 lamina::Amount(tets.CellCount(), "tetrahedron", "tetrahedra") + " in all"));
    return lamina::Done{};
  };
  return lamina::RunStage(this, work);
}

const char* vtkPrismsToTetrahedra::GetSummary()
{
  return lamina::SummaryOf(this, "PrismsToTetrahedra");
}
