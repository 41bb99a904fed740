// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRuleBasedFibers.h"

#include "AlgorithmMonitor.h"
#include "Arrays.h"
#include "GridBridge.h"
#include "MeshArrayNames.h"
#include "NameList.h"
#include "PatchBridge.h"
#include "Report.h"
#include "Stage.h"

#include "Volume/RuleBasedFibers.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkRuleBasedFibers);

void vtkRuleBasedFibers::AddMuscleMaterial(int material)
{
  this->MuscleMaterials.push_back(material);
  this->Modified();
}

void vtkRuleBasedFibers::ClearMuscleMaterials()
{
  this->MuscleMaterials.clear();
  this->Modified();
}

namespace
{

/// Vectors as an array of three components.
void SetVectors(vtkCellData* cells, const char* name, const std::vector<lamina::Vec3>& vectors)
{
  std::vector<double> values;
  values.reserve(3 * vectors.size());
  for (const lamina::Vec3& v : vectors)
  {
    values.insert(values.end(), { v.x, v.y, v.z });
  }
  lamina::SetOrRemove<vtkDoubleArray>(cells, name, values, 3);
}

} // namespace

int vtkRuleBasedFibers::RequestData(vtkInformation*, vtkInformationVector** inputs,
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
    const auto mesh = lamina::ReadGrid(input);
    if (!mesh)
    {
      return mesh.GetError();
    }
    const lamina::Status known =
      lamina::CheckMaterials(this->MuscleMaterials, mesh->materials, "MuscleMaterials");
    if (!known)
    {
      return known;
    }
    bool isStale = false;
    const lamina::MeshPatches patches = lamina::ReadPatches(input, *mesh, isStale);
    if (patches.patches.empty())
    {
      return lamina::InvalidInput(
        "the mesh has no patches, or lost cells since they were named: run Fluid-Solid "
        "Mesh, and this filter right after it");
    }
    lamina::FiberOptions options;
    options.materials = this->MuscleMaterials;
    options.endocardium = lamina::SplitNames(this->Endocardium);
    options.epicardium = lamina::SplitNames(this->Epicardium);
    options.helixEndo = this->EndocardialHelixAngle;
    options.helixEpi = this->EpicardialHelixAngle;
    options.transverse = this->TransverseAngle;
    options.axis = { this->Axis[0], this->Axis[1], this->Axis[2] };
    lamina::FiberField field;
    const auto report = lamina::ComputeFibers(*mesh, patches, options, field, monitor);
    if (!report)
    {
      return report.GetError();
    }
    output->ShallowCopy(input);
    SetVectors(output->GetCellData(), lamina::names::Fibers, field.fibers);
    SetVectors(output->GetCellData(), lamina::names::Sheets, field.sheets);
    lamina::SetOrRemove<vtkDoubleArray>(output->GetCellData(), lamina::names::WallDepth, field.depth);
    output->GetCellData()->SetActiveScalars(lamina::names::WallDepth);
    lamina::AttachReport(
      output, "RuleBasedFibers",
      lamina::Report()
        .Add("cells", report->cells)
        .Add("undecided", report->undecided)
        .Add("axis", std::vector<double>{ report->axis.x, report->axis.y, report->axis.z }));
    return lamina::Done{};
  };
  return lamina::RunStage(this, work);
}

void vtkRuleBasedFibers::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MuscleMaterials: " << lamina::Listed(this->MuscleMaterials) << "\n";
  os << indent << "Endocardium: " << this->Endocardium << "\n";
  os << indent << "Epicardium: " << this->Epicardium << "\n";
  os << indent << "EndocardialHelixAngle: " << this->EndocardialHelixAngle << "\n";
  os << indent << "EpicardialHelixAngle: " << this->EpicardialHelixAngle << "\n";
  os << indent << "TransverseAngle: " << this->TransverseAngle << "\n";
  os << indent << "Axis: " << this->Axis[0] << " " << this->Axis[1] << " " << this->Axis[2] << "\n";
}
