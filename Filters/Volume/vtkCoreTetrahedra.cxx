// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCoreTetrahedra.h"

#include "AlgorithmMonitor.h"
#include "Arrays.h"
#include "GridBridge.h"
#include "MeshArrayNames.h"
#include "Programs.h"
#include "Report.h"
#include "Stage.h"
#include "SurfaceBridge.h"

#include "Base/Text.h"
#include "Volume/CoreTets.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkCoreTetrahedra);

namespace
{

lamina::Report Describe(const lamina::CoreTetsReport& report)
{
  return lamina::Report()
    .Add("tets", report.tets)
    .Add("addedPoints", report.addedPoints)
    .Add("leastQuality", report.leastQuality)
    .Add("aboveGate", report.aboveGate)
    .Add("rung", report.rung)
    .Tell(lamina::Amount(report.tets, "tetrahedron", "tetrahedra") + ", worst " +
          lamina::Short(report.leastQuality) + ", " + lamina::Short(100 * report.aboveGate) + " % above 0.1");
}

/// The triangles of `surface` that are in `ids`, with their points.
lamina::TriangleComplex Extract(const lamina::TriangleComplex& surface, const std::vector<lamina::Id>& ids)
{
  lamina::TriangleComplex part;
  for (const lamina::Id id : ids)
  {
    const auto t = static_cast<std::size_t>(id);
    lamina::Triangle triangle;
    for (std::size_t i = 0; i < 3; ++i)
    {
      triangle[i] = static_cast<lamina::Id>(part.points.size());
      part.points.push_back(surface.points[static_cast<std::size_t>(surface.triangles[t][i])]);
    }
    part.triangles.push_back(triangle);
    part.materials.push_back(surface.materials[t]);
  }
  return part;
}

} // namespace

vtkCoreTetrahedra::vtkCoreTetrahedra()
{
  this->SetNumberOfOutputPorts(2);
}

int vtkCoreTetrahedra::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkCoreTetrahedra::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  return 1;
}

int vtkCoreTetrahedra::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                   vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkUnstructuredGrid* tets = vtkUnstructuredGrid::GetData(outputs, 0);
  vtkPolyData* offending = vtkPolyData::GetData(outputs, 1);
  if (lamina::IsEmpty(input))
  {
    return 1;
  }
  lamina::TriangleComplex refused;
  lamina::AlgorithmMonitor monitor(this);
  monitor.LimitMemory(this->MemoryLimit);
  const auto work = [&]() -> lamina::Status
  {
    auto surface = lamina::ReadSurface(input, monitor);
    if (!surface)
    {
      return surface.GetError();
    }
    auto heights = lamina::ReadValues<double>(input->GetPointData(), lamina::names::LayerHeight,
                                              input->GetNumberOfPoints(), 1, "points");
    if (!heights)
    {
      return heights.GetError();
    }
    surface->layerHeight = std::move(*heights);
    const auto sides = lamina::ReadValues<double>(input->GetPointData(), lamina::names::LayerSide,
                                                  input->GetNumberOfPoints(), 3, "points");
    if (!sides)
    {
      return sides.GetError();
    }
    for (std::size_t i = 0; i + 2 < sides->size(); i += 3)
    {
      surface->layerSide.push_back({ (*sides)[i], (*sides)[i + 1], (*sides)[i + 2] });
    }
    const lamina::CoreTetsOptions options{ lamina::FindProgram("lamina-tetgen"), this->RadiusEdgeRatio,
                                           this->SizeFactor, this->MaximumEdge, true };
    lamina::VolumeMesh mesh;
    lamina::CoreTetsReport onFailure;
    const auto report = lamina::MeshCoreTets(*surface, {}, options, mesh, monitor, &onFailure);
    if (!report)
    {
      refused = Extract(*surface, onFailure.offendingTriangles);
      return report.GetError();
    }
    lamina::WriteGrid(mesh, tets);
    if (report->rung > 1)
    {
      vtkWarningMacro("TetGen failed at what was asked for; it filled the surface with less: "
                      << (report->rung == 2 ? "sizes are not graded from the last layer"
                                            : (report->rung == 3 ? "sizes are not graded, the ratio is 2"
                                                                 : "no refinement, tetrahedra may be poor")));
    }
    lamina::AttachReport(tets, "CoreTetrahedra", Describe(*report));
    return lamina::Done{};
  };
  const int result = lamina::RunStage(this, work);
  if (!refused.triangles.empty())
  {
    lamina::WriteSurface(refused, offending);
  }
  return result;
}

const char* vtkCoreTetrahedra::GetSummary()
{
  return lamina::SummaryOf(this, "CoreTetrahedra");
}

void vtkCoreTetrahedra::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RadiusEdgeRatio: " << this->RadiusEdgeRatio << "\n";
  os << indent << "SizeFactor: " << this->SizeFactor << "\n";
  os << indent << "MaximumEdge: " << this->MaximumEdge << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
}
