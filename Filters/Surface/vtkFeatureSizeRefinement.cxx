// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFeatureSizeRefinement.h"

#include "AlgorithmMonitor.h"
#include "Report.h"
#include "Stage.h"
#include "SurfaceBridge.h"
#include "SurfaceFigures.h"

#include "Surface/RefineSurface.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkFeatureSizeRefinement);

namespace
{

lamina::Report Describe(const lamina::RefineSurfaceReport& report)
{
  return lamina::Report()
    .Add("splits", report.splits)
    .Add("merges", report.merges)
    .Add("swaps", report.swaps)
    .Add("triangles", report.triangles)
    .Add("edgesInRange", report.edgesInRange)
    .Add("leastQuality", report.leastQuality)
    .Add("largestVolumeChange", report.largestVolumeChange)
    .Add("hiddenNodes", report.hiddenNodes)
    .Add("hiddenPlaces", report.hiddenPlaces);
}

} // namespace

int vtkFeatureSizeRefinement::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                          vtkInformationVector* outputs)
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
    if (const auto sized = lamina::RequireTargetEdgeLength(*surface); !sized)
    {
      return sized;
    }
    lamina::RefineSurfaceOptions options;
    options.iterations = this->Iterations;
    options.splitRatio = this->SplitRatio;
    options.mergeRatio = this->MergeRatio;
    options.tolerance = this->Tolerance;
    const auto report = lamina::RefineSurface(*surface, options, monitor);
    if (!report)
    {
      return report.GetError();
    }
    lamina::WriteSurface(*surface, output);
    lamina::WriteCertificate(lamina::Certify(*surface, monitor), output);
    lamina::AttachReport(output, "SurfaceRefinement", Describe(*report));
    return lamina::Done{};
  };
  return lamina::RunStage(this, work);
}

void vtkFeatureSizeRefinement::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Iterations: " << this->Iterations << "\n";
  os << indent << "SplitRatio: " << this->SplitRatio << "\n";
  os << indent << "MergeRatio: " << this->MergeRatio << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
}
