// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVolumeConservingSmoothing.h"

#include "AlgorithmMonitor.h"
#include "Report.h"
#include "Stage.h"
#include "SurfaceBridge.h"
#include "SurfaceFigures.h"

#include "Base/Text.h"
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
  std::vector<lamina::Report> missed;
  constexpr std::size_t most = 100;
  for (std::size_t i = 0; i < report.missedPieces.size() && i < most; ++i)
  {
    const lamina::MissedPiece& piece = report.missedPieces[i];
    missed.push_back(lamina::Report()
                       .Add("material", piece.material)
                       .Add("target", piece.target)
                       .Add("volume", piece.volume)
                       .Add("place", std::vector<lamina::Vec3>{ piece.place }));
  }
  return lamina::Report()
    .Add("sweeps", report.sweepsDone)
    .Add("movesRefused", report.movesRefused)
    .Add("pointsRolledBack", report.pointsRolledBack)
    .Add("largestVolumeChange", report.largestVolumeChange)
    .Add("materials", report.materials)
    .Add("volumesBefore", report.volumesBefore)
    .Add("volumesHeld", report.volumesHeld)
    .Add("volumesAfter", report.volumesAfter)
    .Tell(lamina::Amount(report.sweepsDone, "sweep") + ", volumes kept to " +
          lamina::Short(report.largestVolumeChange) + ", " + lamina::Amount(report.movesRefused, "move") +
          " refused")
    .Add("pieces", report.pieces)
    .Add("largestPieceError", report.largestPieceError)
    .Add("piecesMissed", static_cast<lamina::Id>(report.missedPieces.size()))
    .Add("missedPieces", missed)
    .Add("faultyEdges", report.faultyEdges)
    .Add("faultyPairs", report.faultyPairs)
    .Add("intersectingPairs", report.certificate.intersectingPairs)
    .Add("leastClearance", report.certificate.leastClearance)
    .Add("leastAngle", report.certificate.leastAngle);
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
    options.largestDisplacement = this->LargestDisplacement;
    options.wavelength = this->Wavelength;
    options.settled = this->Settled;
    options.acceptFaults = this->AcceptFaults;
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
    lamina::WriteCertificate(report->certificate, output);
    lamina::AttachReport(output, "VolumeConservingSmoothing", Describe(*report));
    return lamina::Done{};
  };
  return lamina::RunStage(this, work);
}

const char* vtkVolumeConservingSmoothing::GetSummary()
{
  return lamina::SummaryOf(this, "VolumeConservingSmoothing");
}

void vtkVolumeConservingSmoothing::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Sweeps: " << this->Sweeps << "\n";
  os << indent << "Relaxation: " << this->Relaxation << "\n";
  os << indent << "LargestDrift: " << this->LargestDrift << "\n";
  os << indent << "LargestDisplacement: " << this->LargestDisplacement << "\n";
  os << indent << "Wavelength: " << this->Wavelength << "\n";
  os << indent << "Settled: " << this->Settled << "\n";
  os << indent << "AcceptFaults: " << this->AcceptFaults << "\n";
}
