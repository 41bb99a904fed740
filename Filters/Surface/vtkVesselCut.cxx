// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVesselCut.h"

#include "AlgorithmMonitor.h"
#include "Report.h"
#include "Stage.h"
#include "SurfaceBridge.h"
#include "SurfaceFigures.h"

#include "Base/Text.h"
#include "Surface/CutVessel.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkVesselCut);

namespace
{

/// Beyond this share the normal is likely to look the wrong way.
constexpr double MuchOfAll = 0.5;

lamina::Report Describe(const lamina::CutVesselReport& report)
{
  return lamina::Report()
    .Add("sections", report.sections)
    .Add("area", report.area)
    .Add("cutShare", report.cutShare)
    .Add("cutTriangles", report.cutTriangles)
    .Add("endTriangles", report.endTriangles)
    .Add("patches", report.patches)
    .Tell(lamina::Amount(report.sections, "section") + " of area " + lamina::Short(report.area) + ", " +
          lamina::Short(100 * report.cutShare) + " % of the volume cut off");
}

} // namespace

void vtkVesselCut::AddOpenMaterial(int material)
{
  this->OpenMaterials.push_back(material);
  this->Modified();
}

void vtkVesselCut::ClearOpenMaterials()
{
  this->OpenMaterials.clear();
  this->Modified();
}

int vtkVesselCut::GetOpenMaterial(int index) const
{
  return index >= 0 && index < this->GetNumberOfOpenMaterials()
           ? this->OpenMaterials[static_cast<std::size_t>(index)]
           : -1;
}

int vtkVesselCut::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (lamina::IsEmpty(input))
  {
    return 1;
  }
  lamina::AlgorithmMonitor monitor(this);
  const auto work = [&]() -> lamina::Status
  {
    auto surface = lamina::ReadSurface(input, monitor);
    if (!surface)
    {
      return surface.GetError();
    }
    lamina::CutVesselOptions options;
    options.origin = { this->Origin[0], this->Origin[1], this->Origin[2] };
    options.normal = { this->Normal[0], this->Normal[1], this->Normal[2] };
    options.openMaterials = this->OpenMaterials;
    options.name = this->Name;
    const auto report = lamina::CutVessel(*surface, options, monitor);
    if (!report)
    {
      return report.GetError();
    }
    if (report->cutShare > MuchOfAll)
    {
      vtkWarningMacro("the cut took away "
                      << 100 * report->cutShare
                      << " % of the volume: turn Normal over if the other part was meant");
    }
    output->GetFieldData()->ShallowCopy(input->GetFieldData());
    lamina::DropSurfaceFigures(output);
    lamina::WriteSurface(*surface, output);
    lamina::AttachReport(output, "VesselCut", Describe(*report));
    return lamina::Done{};
  };
  return lamina::RunStage(this, work);
}

const char* vtkVesselCut::GetSummary()
{
  return lamina::SummaryOf(this, "VesselCut");
}

void vtkVesselCut::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Origin: " << this->Origin[0] << " " << this->Origin[1] << " " << this->Origin[2] << "\n";
  os << indent << "Normal: " << this->Normal[0] << " " << this->Normal[1] << " " << this->Normal[2] << "\n";
  os << indent << "Name: " << this->Name << "\n";
  os << indent << "OpenMaterials: " << lamina::Listed(this->OpenMaterials) << "\n";
}
