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

#include "Base/Text.h"
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
    const auto patches = lamina::RequirePatches(input, *mesh);
    if (!patches)
    {
      return patches.GetError();
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
    const auto report = lamina::ComputeFibers(*mesh, *patches, options, field, monitor);
    if (!report)
    {
      return report.GetError();
    }
    output->ShallowCopy(input);
    lamina::SetOrRemoveVectors(output->GetCellData(), lamina::names::Fibers, field.fibers);
    lamina::SetOrRemoveVectors(output->GetCellData(), lamina::names::Sheets, field.sheets);
    lamina::SetOrRemove<vtkDoubleArray>(output->GetCellData(), lamina::names::WallDepth, field.depth);
    output->GetCellData()->SetActiveScalars(lamina::names::WallDepth);
    lamina::AttachReport(output, "RuleBasedFibers",
                         lamina::Report()
                           .Add("cells", report->cells)
                           .Add("undecided", report->undecided)
                           .Add("axis", std::vector<double>{ report->axis.x, report->axis.y, report->axis.z })
                           .Tell(lamina::Amount(report->cells, "cell") + " with a fibre, " +
                                 lamina::Amount(report->undecided, "cell") +
                                 " by the rule of their neighbours"));
    return lamina::Done{};
  };
  return lamina::RunStage(this, work);
}

const char* vtkRuleBasedFibers::GetSummary()
{
  return lamina::SummaryOf(this, "RuleBasedFibers");
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
