// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFeatureSizeRefinement.h"

#include "AlgorithmMonitor.h"
#include "Arrays.h"
#include "MeshArrayNames.h"
#include "Report.h"
#include "Stage.h"
#include "SurfaceBridge.h"
#include "SurfaceFigures.h"

#include "Base/Text.h"
#include "Surface/RefineSurface.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

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
    .Add("goodTriangles", report.goodTriangles)
    .Add("largestVolumeChange", report.largestVolumeChange)
    .Add("hiddenNodes", report.hiddenNodes)
    .Add("forbiddenNodes", report.forbiddenNodes)
    .Add("hiddenPlaces", report.hiddenPlaces)
    .Tell(lamina::Amount(report.triangles, "triangle") + ", worst " + lamina::Short(report.leastQuality) +
          ", " + lamina::Short(100 * report.edgesInRange) + " % of the edges near their target, " +
          lamina::Amount(report.hiddenNodes, "node") + " that layers cannot start from");
}

/// The targets that the properties ask for, in place of those of the input.
lamina::Status SetTargets(vtkPolyData* input, double length, const std::string& array,
                          lamina::TriangleComplex& surface)
{
  if (length != 0)
  {
    if (!(length > 0) || !std::isfinite(length))
    {
      return lamina::InvalidOption("EdgeLength must be positive, or 0 to go by TargetArray");
    }
    surface.targetEdgeLength.assign(surface.points.size(), length);
    return lamina::Done{};
  }
  auto targets =
    lamina::ReadValues<double>(input->GetPointData(), array.c_str(), input->GetNumberOfPoints(), 1, "points");
  if (!targets)
  {
    return targets.GetError();
  }
  if (targets->empty())
  {
    return lamina::MissingArray(array.c_str(), "points", "Feature Size");
  }
  surface.targetEdgeLength = std::move(*targets);
  return lamina::RequireTargetEdgeLength(surface, array.c_str());
}

} // namespace

vtkFeatureSizeRefinement::vtkFeatureSizeRefinement()
  : TargetArray(lamina::names::TargetEdgeLength)
{
}

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
  monitor.LimitMemory(this->MemoryLimit);
  const auto work = [&]() -> lamina::Status
  {
    auto surface = lamina::ReadSurface(input, monitor);
    if (!surface)
    {
      return surface.GetError();
    }
    if (const auto sized = SetTargets(input, this->EdgeLength, this->TargetArray, *surface); !sized)
    {
      return sized;
    }
    lamina::RefineSurfaceOptions options;
    options.iterations = this->Iterations;
    options.splitRatio = this->SplitRatio;
    options.mergeRatio = this->MergeRatio;
    options.tolerance = this->Tolerance;
    options.tangentialAnisotropy = this->TangentialAnisotropy;
    const auto report = lamina::RefineSurface(*surface, options, monitor);
    if (!report)
    {
      return report.GetError();
    }
    lamina::WriteSurface(*surface, output);
    std::vector<unsigned char> flags(surface->points.size(), 0);
    for (const lamina::Id p : report->hiddenPoints)
    {
      flags[static_cast<std::size_t>(p)] = lamina::FlagHiddenNode;
    }
    lamina::SetOrRemove<vtkUnsignedCharArray>(output->GetPointData(), lamina::names::MeshingFlags, flags);
    lamina::WriteCertificate(lamina::Certify(*surface, monitor), output);
    lamina::AttachReport(output, "SurfaceRefinement", Describe(*report));
    return lamina::Done{};
  };
  return lamina::RunStage(this, work);
}

const char* vtkFeatureSizeRefinement::GetSummary()
{
  return lamina::SummaryOf(this, "SurfaceRefinement");
}

void vtkFeatureSizeRefinement::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Iterations: " << this->Iterations << "\n";
  os << indent << "SplitRatio: " << this->SplitRatio << "\n";
  os << indent << "MergeRatio: " << this->MergeRatio << "\n";
  os << indent << "EdgeLength: " << this->EdgeLength << "\n";
  os << indent << "TargetArray: " << this->TargetArray << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "TangentialAnisotropy: " << this->TangentialAnisotropy << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
}
