// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVolumeConservingSmoothing.h"

#include "AlgorithmMonitor.h"
#include "Report.h"
#include "Stage.h"
#include "SurfaceBridge.h"

#include "Surface/SmoothSurface.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkVolumeConservingSmoothing);

namespace
{

lamina::Report Describe(const lamina::SmoothSurfaceReport& report)
{
  return lamina::Report()
    .Add("sweeps", report.sweepsDone)
    .Add("movesRefused", report.movesRefused)
    .Add("pointsRolledBack", report.pointsRolledBack)
    .Add("largestVolumeChange", report.largestVolumeChange)
    .Add("materials", report.materials)
    .Add("volumesBefore", report.volumesBefore)
    .Add("volumesAfter", report.volumesAfter);
}

} // namespace

int vtkVolumeConservingSmoothing::RequestData(vtkInformation*, vtkInformationVector** inputs,
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
    lamina::SmoothSurfaceOptions options;
    options.sweeps = this->Sweeps;
    options.relaxation = this->Relaxation;
    options.largestDrift = this->LargestDrift;
    options.wavelength = this->Wavelength;
    const auto report = lamina::SmoothSurface(*surface, options, monitor);
    if (!report)
    {
      return report.GetError();
    }
    surface->featureSize.clear();
    surface->targetEdgeLength.clear();
    surface->thickness.clear();
    surface->maximumCurvature.clear();
    surface->minimumCurvature.clear();
    surface->maximumCurvatureDirection.clear();
    output->ShallowCopy(input);
    lamina::WriteSurface(*surface, output);
    lamina::AttachReport(output, "VolumeConservingSmoothing", Describe(*report));
    return lamina::Done{};
  };
  return lamina::RunStage(this, work);
}

void vtkVolumeConservingSmoothing::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Sweeps: " << this->Sweeps << "\n";
  os << indent << "Relaxation: " << this->Relaxation << "\n";
  os << indent << "LargestDrift: " << this->LargestDrift << "\n";
  os << indent << "Wavelength: " << this->Wavelength << "\n";
}
