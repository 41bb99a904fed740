// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFluidSolidMesh.h"

#include "AlgorithmMonitor.h"
#include "GridBridge.h"
#include "Report.h"
#include "Stage.h"

#include "Volume/AssembleMesh.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
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

lamina::Report Describe(const lamina::AssembleMeshReport& report)
{
  return lamina::Report()
    .Add("points", report.points)
    .Add("cells", report.cells)
    .Add("mergedPoints", report.mergedPoints);
}

} // namespace

int vtkFluidSolidMesh::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return 1;
}

int vtkFluidSolidMesh::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                   vtkInformationVector* outputs)
{
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputs);
  lamina::AlgorithmMonitor monitor(this);
  const auto work = [&]() -> lamina::Status
  {
    std::vector<lamina::VolumeMesh> parts;
    for (int i = 0; i < inputs[0]->GetNumberOfInformationObjects(); ++i)
    {
      vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputs[0], i);
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
    if (!(this->Scale > 0))
    {
      return lamina::InvalidOption("Scale must be above 0");
    }
    if (parts.empty())
    {
      return lamina::Done{};
    }
    std::vector<const lamina::VolumeMesh*> list;
    for (const lamina::VolumeMesh& part : parts)
    {
      list.push_back(&part);
    }
    lamina::VolumeMesh mesh;
    const auto report = lamina::AssembleMesh(list, { this->Scale }, mesh, monitor);
    if (!report)
    {
      return report.GetError();
    }
    lamina::WriteGrid(mesh, output);
    lamina::AttachReport(output, "FluidSolidMesh", Describe(*report));
    return lamina::Done{};
  };
  return lamina::RunStage(this, work);
}

void vtkFluidSolidMesh::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scale: " << this->Scale << "\n";
}
