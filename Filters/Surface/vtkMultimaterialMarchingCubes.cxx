// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMultimaterialMarchingCubes.h"

#include "AlgorithmMonitor.h"
#include "ImageBridge.h"
#include "ImageRequests.h"
#include "MeshArrayNames.h"
#include "Report.h"
#include "Stage.h"
#include "SurfaceBridge.h"
#include "SurfaceFigures.h"

#include "Base/Text.h"
#include "Surface/ExtractInterfaces.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkStandardNewMacro(vtkMultimaterialMarchingCubes);

namespace
{

lamina::Report Describe(const lamina::ExtractInterfacesReport& report)
{
  return lamina::Report()
    .Add("points", report.points)
    .Add("triangles", report.triangles)
    .Add("junctionCurveEdges", report.junctionCurveEdges)
    .Add("openings", report.openings)
    .Add("repairedVoxels", report.repairedVoxels)
    .Add("repairedPlaces", report.repairedPlaces)
    .Add("lostVoxels", report.lostVoxels)
    .Add("materials", report.materials)
    .Add("imageVolumes", report.imageVolumes)
    .Add("movedPoints", report.movedPoints)
    .Add("heldPoints", report.heldPoints)
    .Add("clusteredPoints", report.clusteredPoints)
    .Tell(lamina::Amount(report.triangles, "triangle") + " around " +
          lamina::Amount(static_cast<lamina::Id>(report.materials.size()), "material") + ", " +
          lamina::Amount(report.openings, "opening") + ", " + lamina::Amount(report.repairedVoxels, "voxel") +
          " relabelled");
}

std::vector<int> MaterialsIn(const lamina::LabelImage& image)
{
  std::vector<bool> seen(65536, false);
  for (const int label : image.labels)
  {
    seen[static_cast<std::size_t>(label)] = true;
  }
  std::vector<int> ids;
  for (std::size_t id = 1; id < seen.size(); ++id)
  {
    if (seen[id])
    {
      ids.push_back(static_cast<int>(id));
    }
  }
  return ids;
}

/// Check the open materials and read the region of interest, as far as a border is open at all.
lamina::Status PrepareOpenings(const lamina::LabelImage& image, vtkImageData* maskInput,
                               lamina::LabelImage& mask, lamina::ExtractInterfacesOptions& options)
{
  if (!options.openAtImageBorder && !options.openAtMaskBorder)
  {
    options.openMaterials.clear();
    return lamina::Done{};
  }
  const auto known = lamina::CheckMaterials(options.openMaterials, MaterialsIn(image), "OpenMaterials");
  if (!known || !options.openAtMaskBorder)
  {
    return known;
  }
  if (!maskInput)
  {
    return lamina::InvalidInput("OpenAtMaskBorder needs a region of interest on input port 1 (Mask)");
  }
  auto read = lamina::ReadMask(maskInput, image.grid);
  if (!read)
  {
    return read.GetError();
  }
  mask = std::move(*read);
  options.mask = &mask;
  return lamina::Done{};
}

} // namespace

vtkMultimaterialMarchingCubes::vtkMultimaterialMarchingCubes()
{
  this->SetNumberOfInputPorts(3);
}

void vtkMultimaterialMarchingCubes::AddOpenMaterial(int material)
{
  this->OpenMaterials.push_back(material);
  this->Modified();
}

void vtkMultimaterialMarchingCubes::ClearOpenMaterials()
{
  this->OpenMaterials.clear();
  this->Modified();
}

int vtkMultimaterialMarchingCubes::GetOpenMaterial(int index)
{
  return index >= 0 && index < this->GetNumberOfOpenMaterials()
           ? this->OpenMaterials[static_cast<std::size_t>(index)]
           : -1;
}

int vtkMultimaterialMarchingCubes::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port > 0 ? 1 : 0);
  return 1;
}

int vtkMultimaterialMarchingCubes::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs,
                                                       vtkInformationVector*)
{
  // Neighbours matter everywhere: always the whole images.
  return lamina::AskForWholeImages(inputs, this->GetNumberOfInputPorts());
}

int vtkMultimaterialMarchingCubes::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                               vtkInformationVector* outputs)
{
  vtkImageData* input = vtkImageData::GetData(inputs[0]);
  vtkImageData* maskInput = vtkImageData::GetData(inputs[1]);
  vtkImageData* greyInput = vtkImageData::GetData(inputs[2]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (!input || input->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  lamina::AlgorithmMonitor monitor(this);
  const auto work = [&]() -> lamina::Status
  {
    const auto scalars = lamina::FindScalars(input, lamina::names::MaterialIds, "Multimaterial Segmentation");
    if (!scalars)
    {
      return scalars.GetError();
    }
    const auto image = lamina::ReadLabels(input, *scalars);
    if (!image)
    {
      return image.GetError();
    }
    lamina::LabelImage mask;
    lamina::ExtractInterfacesOptions options;
    options.openAtImageBorder = this->OpenAtImageBorder;
    options.openAtMaskBorder = this->OpenAtMaskBorder;
    options.openMaterials = this->OpenMaterials;
    if (const auto ready = PrepareOpenings(*image, maskInput, mask, options); !ready)
    {
      return ready;
    }
    lamina::GreyView grey;
    if (greyInput)
    {
      auto read = lamina::ViewGreyBeside(greyInput, image->grid);
      if (!read)
      {
        return read.GetError();
      }
      grey = std::move(*read);
      options.grey = &grey;
    }
    options.clusterPoints = this->ClusterPoints;
    lamina::TriangleComplex surface;
    const auto report = lamina::ExtractInterfaces(*image, surface, options, monitor);
    if (!report)
    {
      return report.GetError();
    }
    lamina::WriteSurface(surface, output);
    lamina::WriteImageVolumes(report->materials, report->imageVolumes, output);
    lamina::AttachReport(output, "MultimaterialMarchingCubes", Describe(*report));
    return lamina::Done{};
  };
  return lamina::RunStage(this, work);
}

const char* vtkMultimaterialMarchingCubes::GetSummary()
{
  return lamina::SummaryOf(this, "MultimaterialMarchingCubes");
}

void vtkMultimaterialMarchingCubes::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OpenMaterials: " << lamina::Listed(this->OpenMaterials) << "\n";
  os << indent << "OpenAtImageBorder: " << this->OpenAtImageBorder << "\n";
  os << indent << "OpenAtMaskBorder: " << this->OpenAtMaskBorder << "\n";
  os << indent << "ClusterPoints: " << this->ClusterPoints << "\n";
}
