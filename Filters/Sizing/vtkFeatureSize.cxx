// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFeatureSize.h"

#include "AlgorithmMonitor.h"
#include "Report.h"
#include "Stage.h"
#include "SurfaceBridge.h"

#include "Sizing/FeatureSize.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkFeatureSize);

namespace
{

lamina::Report Describe(const lamina::FeatureSizeReport& report)
{
  return lamina::Report()
    .Add("minimum", report.minimum)
    .Add("maximum", report.maximum)
    .Add("leastSize", report.leastSize)
    .Add("largestSize", report.largestSize)
    .Add("clippedBelow", report.clippedBelow)
    .Add("clippedAbove", report.clippedAbove)
    .Add("materials", report.materials);
}

} // namespace

int vtkFeatureSize::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
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
    lamina::FeatureSizeOptions options;
    options.minimum = this->MinimumSize;
    options.maximum = this->MaximumSize;
    options.gradient = this->Gradient;
    options.layers = this->Layers;
    options.anisotropy = this->Anisotropy;
    options.coneAngle = this->ConeAngle;
    const auto report = lamina::ComputeFeatureSize(*surface, options, monitor);
    if (!report)
    {
      return report.GetError();
    }
    output->ShallowCopy(input);
    lamina::WriteSurface(*surface, output);
    lamina::AttachReport(output, "FeatureSize", Describe(*report));
    return lamina::Done{};
  };
  return lamina::RunStage(this, work);
}

void vtkFeatureSize::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Layers: " << this->Layers << "\n";
  os << indent << "Anisotropy: " << this->Anisotropy << "\n";
  os << indent << "MinimumSize: " << this->MinimumSize << "\n";
  os << indent << "MaximumSize: " << this->MaximumSize << "\n";
  os << indent << "Gradient: " << this->Gradient << "\n";
  os << indent << "ConeAngle: " << this->ConeAngle << "\n";
}
