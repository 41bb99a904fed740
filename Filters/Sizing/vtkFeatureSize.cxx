// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFeatureSize.h"

#include "AlgorithmMonitor.h"
#include "MeshArrayNames.h"
#include "Report.h"
#include "Stage.h"
#include "SurfaceBridge.h"

#include "Base/Text.h"
#include "Sizing/FeatureSize.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <cmath>

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
    .Add("curved", report.curved)
    .Add("thinWalls", report.thinWalls)
    .Add("strongestCurvature", report.strongestCurvature)
    .Add("materials", report.materials)
    .Tell("feature sizes from " + lamina::Short(report.leastSize) + " to " +
          lamina::Short(report.largestSize) + ", kept within " + lamina::Short(report.minimum) + " and " +
          lamina::Short(report.maximum) + "; " + lamina::Amount(report.thinWalls, "point") +
          " at walls too thin for that");
}

/// Entries of five numbers; ids and layers must be whole.
lamina::Result<std::vector<lamina::MaterialSizing>> ReadSizings(const std::vector<double>& values)
{
  std::vector<lamina::MaterialSizing> sizings;
  for (std::size_t i = 0; i + 4 < values.size(); i += 5)
  {
    for (std::size_t k = 0; k < 2; ++k)
    {
      const double value = values[i + k];
      if (!(std::abs(value) < 1e6) || value != std::floor(value))
      {
        return lamina::InvalidOption(
          "entry " + std::to_string(i / 5) + " of MaterialSizings has " + std::to_string(value) +
          " for the " + (k == 0 ? "material id" : "number of layers") + ": a whole number is needed");
      }
    }
    sizings.push_back({ static_cast<int>(values[i]), static_cast<int>(values[i + 1]), values[i + 2],
                        values[i + 3], values[i + 4] });
  }
  return sizings;
}

} // namespace

void vtkFeatureSize::AddMaterialSizing(double material, double layers, double anisotropy, double minimum,
                                       double maximum)
{
  this->MaterialSizings.insert(this->MaterialSizings.end(),
                               { material, layers, anisotropy, minimum, maximum });
  this->Modified();
}

void vtkFeatureSize::ClearMaterialSizings()
{
  this->MaterialSizings.clear();
  this->Modified();
}

void vtkFeatureSize::GetMaterialSizing(int index, double sizing[5])
{
  const bool isThere = index >= 0 && index < this->GetNumberOfMaterialSizings();
  for (std::size_t k = 0; k < 5; ++k)
  {
    sizing[k] = isThere ? this->MaterialSizings[5 * static_cast<std::size_t>(index) + k] : 0;
  }
}

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
    options.nodesPerCircumference = this->NodesPerCircumference;
    options.edgePerLayer = this->EdgePerLayer;
    auto sizings = ReadSizings(this->MaterialSizings);
    if (!sizings)
    {
      return sizings.GetError();
    }
    options.materials = std::move(*sizings);
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

const char* vtkFeatureSize::GetSummary()
{
  return lamina::SummaryOf(this, lamina::names::FeatureSize);
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
  os << indent << "NodesPerCircumference: " << this->NodesPerCircumference << "\n";
  os << indent << "EdgePerLayer: " << this->EdgePerLayer << "\n";
  os << indent << "MaterialSizings:";
  for (const double value : this->MaterialSizings)
  {
    os << " " << value;
  }
  os << "\n";
}
