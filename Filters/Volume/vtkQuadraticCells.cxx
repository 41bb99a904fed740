// SPDX-License-Identifier: BSD-3-Clause
#include "vtkQuadraticCells.h"

#include "AlgorithmMonitor.h"
#include "Arrays.h"
#include "GridBridge.h"
#include "MeshArrayNames.h"
#include "PatchBridge.h"
#include "Report.h"
#include "Stage.h"
#include "SurfaceBridge.h"

#include "Base/Text.h"
#include "Volume/QuadraticMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkQuadraticCells);

namespace
{

unsigned char QuadraticType(lamina::CellType type)
{
  switch (type)
  {
    case lamina::CellType::Wedge:
      return VTK_QUADRATIC_WEDGE;
    case lamina::CellType::Pyramid:
      return VTK_QUADRATIC_PYRAMID;
    default:
      return VTK_QUADRATIC_TETRA;
  }
}

void WriteQuadratic(const lamina::VolumeMesh& mesh, const lamina::QuadraticNodes& nodes,
                    vtkUnstructuredGrid* output)
{
  std::vector<lamina::Vec3> points = mesh.points;
  points.insert(points.end(), nodes.points.begin(), nodes.points.end());
  std::vector<lamina::Id> offsets{ 0 };
  std::vector<lamina::Id> connectivity;
  std::vector<unsigned char> types;
  for (std::size_t c = 0; c < mesh.types.size(); ++c)
  {
    connectivity.insert(connectivity.end(), mesh.connectivity.begin() + mesh.offsets[c],
                        mesh.connectivity.begin() + mesh.offsets[c + 1]);
    connectivity.insert(connectivity.end(), nodes.connectivity.begin() + nodes.offsets[c],
                        nodes.connectivity.begin() + nodes.offsets[c + 1]);
    offsets.push_back(static_cast<lamina::Id>(connectivity.size()));
    types.push_back(QuadraticType(mesh.types[c]));
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(lamina::MakeArray<vtkIdTypeArray>("", offsets),
                 lamina::MakeArray<vtkIdTypeArray>("", connectivity));
  output->SetPoints(lamina::MakePoints(points));
  output->SetCells(lamina::MakeArray<vtkUnsignedCharArray>("", types), cells);
  std::vector<int> layers = mesh.layerIndex;
  std::vector<lamina::Id> interfaceNodes = mesh.interfaceNodeIds;
  layers.resize(points.size(), -1);
  interfaceNodes.resize(points.size(), -1);
  vtkPointData* data = output->GetPointData();
  data->AddArray(lamina::MakeArray<vtkIntArray>(lamina::names::LayerIndex, layers));
  data->AddArray(lamina::MakeArray<vtkIdTypeArray>(lamina::names::InterfaceNodeIds, interfaceNodes));
  lamina::WriteNodeIds(output);
}

} // namespace

vtkQuadraticCells::vtkQuadraticCells()
{
  this->SetNumberOfInputPorts(2);
}

int vtkQuadraticCells::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkQuadraticCells::RequestData(vtkInformation*, vtkInformationVector** inputs,
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
    const auto mesh = lamina::ReadGrid(input, lamina::WithoutMaterials::TakeAsOne);
    if (!mesh)
    {
      return mesh.GetError();
    }
    const auto surface = lamina::ReadSideSurface(vtkPolyData::GetData(inputs[1]), monitor);
    if (!surface)
    {
      return surface.GetError();
    }
    bool isStale = false;
    lamina::MeshPatches patches = lamina::ReadPatches(input, *mesh, isStale);
    if (patches.faces.empty())
    {
      const auto found = lamina::FindPatches(*mesh, nullptr, {}, patches, monitor);
      if (!found)
      {
        return found.GetError();
      }
    }
    lamina::QuadraticNodes nodes;
    const auto report = lamina::AddMiddleNodes(*mesh, patches, &*surface,
                                               { this->SurfaceScale, this->LargestOffset }, nodes, monitor);
    if (!report)
    {
      return report.GetError();
    }
    WriteQuadratic(*mesh, nodes, output);
    output->GetCellData()->PassData(input->GetCellData());
    output->GetCellData()->SetActiveScalars(lamina::names::MaterialIds);
    output->GetFieldData()->ShallowCopy(input->GetFieldData());
    lamina::AttachReport(output, "QuadraticCells",
                         lamina::Report()
                           .Add("middleNodes", report->middleNodes)
                           .Add("curvedEdges", report->curvedEdges)
                           .Add("straightenedEdges", report->straightenedEdges)
                           .Tell(lamina::Amount(report->middleNodes, "middle node") + ", " +
                                 lamina::Amount(report->curvedEdges, "edge") + " on the surface, " +
                                 lamina::Amount(report->straightenedEdges, "edge") + " left straight"));
    return lamina::Done{};
  };
  return lamina::RunStage(this, work);
}

const char* vtkQuadraticCells::GetSummary()
{
  return lamina::SummaryOf(this, "QuadraticCells");
}

void vtkQuadraticCells::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SurfaceScale: " << this->SurfaceScale << "\n";
  os << indent << "LargestOffset: " << this->LargestOffset << "\n";
}
