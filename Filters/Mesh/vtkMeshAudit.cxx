// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshAudit.h"

#include "AlgorithmMonitor.h"
#include "Arrays.h"
#include "AuditTable.h"
#include "GridAudit.h"
#include "GridBridge.h"
#include "ImageBridge.h"
#include "MeshArrayNames.h"
#include "PatchBridge.h"
#include "Report.h"
#include "Stage.h"
#include "SurfaceBridge.h"

#include "Surface/AuditSurface.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkMeshAudit);

namespace
{

/// The image's materials; without voxels if there is no image.
lamina::Result<lamina::LabelImage> ReadImage(vtkImageData* image)
{
  if (lamina::IsEmpty(image))
  {
    return lamina::LabelImage{};
  }
  const auto scalars = lamina::FindScalars(image, lamina::names::MaterialIds, "Multimaterial Segmentation");
  return scalars ? lamina::ReadLabels(image, *scalars)
                 : lamina::Result<lamina::LabelImage>(scalars.GetError());
}

/// Tell the volumes of the image's voxels, where they have travelled along, in the lengths of the mesh.
template<typename AuditT>
void TakeImageVolumes(vtkFieldData* data, double scale, AuditT& report)
{
  vtkDataArray* volumes = data->GetArray(lamina::names::ImageVolumes);
  for (vtkIdType i = 0; volumes && volumes->GetNumberOfComponents() == 2 && i < volumes->GetNumberOfTuples();
       ++i)
  {
    for (auto& material : report.materials)
    {
      if (material.material == volumes->GetComponent(i, 0))
      {
        material.imageVolume = volumes->GetComponent(i, 1) * scale * scale * scale;
      }
    }
  }
}

void TakeFigure(vtkFieldData* data, const char* name, double scale, double& figure)
{
  vtkDataArray* array = data->GetArray(name);
  figure = array && array->GetNumberOfValues() == 1 ? scale * array->GetComponent(0, 0) : figure;
}

/// What travelled with the mesh, or failing that with the surface.
void TakeWhatTravelled(vtkFieldData* data, double scale, lamina::AuditReport& report)
{
  TakeImageVolumes(data, scale, report);
  TakeFigure(data, lamina::names::IntersectingPairs, 1, report.carriedPairs);
  TakeFigure(data, lamina::names::LeastClearance, scale, report.carriedClearance);
  TakeFigure(data, lamina::names::LeastAngle, 1, report.carriedAngle);
}

} // namespace

vtkMeshAudit::vtkMeshAudit()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

int vtkMeshAudit::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
    return 1;
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 1 ? "vtkPolyData" : "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkMeshAudit::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkDataSet" : "vtkTable");
  return 1;
}

int vtkMeshAudit::RequestDataObject(vtkInformation*, vtkInformationVector** inputs,
                                    vtkInformationVector* outputs)
{
  vtkDataSet* input = vtkDataSet::GetData(inputs[0]);
  vtkInformation* first = outputs->GetInformationObject(0);
  vtkDataObject* old = first->Get(vtkDataObject::DATA_OBJECT());
  if (input && (!old || !old->IsA(input->GetClassName())))
  {
    vtkDataSet* output = input->NewInstance();
    first->Set(vtkDataObject::DATA_OBJECT(), output);
    output->FastDelete();
  }
  vtkInformation* second = outputs->GetInformationObject(1);
  if (!vtkTable::GetData(second))
  {
    second->Set(vtkDataObject::DATA_OBJECT(), vtkSmartPointer<vtkTable>::New());
  }
  return 1;
}

int vtkMeshAudit::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataSet* input = vtkDataSet::GetData(inputs[0]);
  vtkDataSet* output = vtkDataSet::GetData(outputs, 0);
  vtkTable* table = vtkTable::GetData(outputs, 1);
  this->Passed = false;
  this->ReportText = "{}";
  if (lamina::IsEmpty(input))
  {
    return 1;
  }
  output->ShallowCopy(input);
  if (vtkUnstructuredGrid* grid = vtkUnstructuredGrid::SafeDownCast(input))
  {
    return this->AuditGrid(grid, vtkPolyData::GetData(inputs[1]), vtkImageData::GetData(inputs[2]), output,
                           table);
  }
  return this->AuditSurface(vtkPolyData::SafeDownCast(input), output, table);
}

int vtkMeshAudit::AuditGrid(vtkUnstructuredGrid* input, vtkPolyData* surface, vtkImageData* image,
                            vtkDataSet* output, vtkTable* table)
{
  lamina::AlgorithmMonitor monitor(this);
  const auto work = [&]() -> lamina::Status
  {
    const auto mesh = lamina::ReadGrid(input, lamina::WithoutMaterials::TakeAsOne);
    if (!mesh)
    {
      return mesh.GetError();
    }
    const auto interfaces = lamina::ReadSideSurface(surface, monitor);
    if (!interfaces)
    {
      return interfaces.GetError();
    }
    const auto labels = ReadImage(image);
    if (!labels)
    {
      return lamina::InvalidInput("image: " + labels.GetError().message);
    }
    auto twins = lamina::ReadValues<lamina::Id>(input->GetPointData(), lamina::names::TwinNodeIds,
                                                input->GetNumberOfPoints(), 1, "points");
    if (!twins)
    {
      return twins.GetError();
    }
    lamina::MeshPatches patches;
    const bool hasPatches = lamina::ReadRawPatches(input, patches);
    lamina::AuditOptions options;
    options.qualityGate = this->QualityGate;
    options.volumeTolerance = this->VolumeTolerance;
    options.overlapSamples = this->OverlapSamples;
    options.surfaceScale = this->SurfaceScale;
    options.twins = std::move(*twins);
    const lamina::GridAuditInput all{ &*mesh, interfaces->triangles.empty() ? nullptr : &*interfaces,
                                      labels->labels.empty() ? nullptr : &*labels,
                                      hasPatches ? &patches : nullptr };
    auto audit = lamina::AuditWholeGrid(all, options, monitor);
    if (!audit)
    {
      return audit.GetError();
    }
    if (all.surface != nullptr)
    {
      TakeWhatTravelled(surface->GetFieldData(), this->SurfaceScale, audit->report);
    }
    TakeWhatTravelled(input->GetFieldData(), this->SurfaceScale, audit->report);
    vtkCellData* cells = output->GetCellData();
    lamina::SetOrRemove<vtkDoubleArray>(cells, lamina::names::MeshQuality, audit->marks.quality);
    lamina::SetOrRemove<vtkUnsignedCharArray>(cells, lamina::names::MeshingFlags, audit->marks.flags);
    cells->SetActiveScalars(lamina::names::MeshQuality);
    lamina::FillTable(*audit, table);
    this->Passed = audit->report.Passed();
    this->ReportText = lamina::DescribeAudit(*audit).Json();
    lamina::AttachReport(output, "MeshAudit", lamina::DescribeAudit(*audit));
    return lamina::Done{};
  };
  return lamina::RunStage(this, work);
}

int vtkMeshAudit::AuditSurface(vtkPolyData* input, vtkDataSet* output, vtkTable* table)
{
  lamina::AlgorithmMonitor monitor(this);
  const auto work = [&]() -> lamina::Status
  {
    const auto surface = lamina::ReadSurface(input, monitor);
    if (!surface)
    {
      return surface.GetError();
    }
    std::vector<unsigned char> flags;
    auto report = lamina::AuditSurface(*surface, flags, monitor);
    if (!report)
    {
      return report.GetError();
    }
    TakeImageVolumes(input->GetFieldData(), 1, *report);
    lamina::SetOrRemove<vtkUnsignedCharArray>(output->GetCellData(), lamina::names::MeshingFlags, flags);
    lamina::FillTable(*report, table);
    this->Passed = report->Passed();
    this->ReportText = lamina::DescribeAudit(*report).Json();
    lamina::AttachReport(output, "MeshAudit", lamina::DescribeAudit(*report));
    return lamina::Done{};
  };
  return lamina::RunStage(this, work);
}

const char* vtkMeshAudit::GetSummary()
{
  return lamina::SummaryOf(this, "MeshAudit");
}

void vtkMeshAudit::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "QualityGate: " << this->QualityGate << "\n";
  os << indent << "VolumeTolerance: " << this->VolumeTolerance << "\n";
  os << indent << "OverlapSamples: " << this->OverlapSamples << "\n";
  os << indent << "SurfaceScale: " << this->SurfaceScale << "\n";
  os << indent << "Passed: " << this->Passed << "\n";
}
