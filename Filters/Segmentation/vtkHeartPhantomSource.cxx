// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeartPhantomSource.h"

#include "AlgorithmMonitor.h"
#include "Arrays.h"
#include "ImageBridge.h"
#include "ImageRequests.h"
#include "MeshArrayNames.h"
#include "Report.h"
#include "Stage.h"

#include "Base/Text.h"
#include "Segmentation/HeartPhantom.h"

#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

vtkStandardNewMacro(vtkHeartPhantomSource);

namespace
{

lamina::HeartPhantomOptions OptionsOf(vtkHeartPhantomSource* self)
{
  lamina::HeartPhantomOptions options;
  options.resolution = self->GetResolution();
  options.length = self->GetLength();
  options.noise = self->GetNoise();
  options.blur = self->GetBlur();
  options.bias = self->GetBias();
  options.seed = static_cast<unsigned long long>(self->GetSeed());
  options.open = self->GetOpenVessels();
  return options;
}

void WriteIntensity(const lamina::GreyImage& grey, vtkImageData* image)
{
  const std::vector<unsigned char> values(grey.values.begin(), grey.values.end());
  image->GetPointData()->SetScalars(
    lamina::MakeArray<vtkUnsignedCharArray>(lamina::names::Intensity, values));
}

lamina::Report Describe(const lamina::HeartPhantomReport& report)
{
  std::vector<lamina::Report> rows;
  for (const lamina::HeartPhantomMaterial& material : report.materials)
  {
    rows.emplace_back();
    rows.back()
      .Add("material", material.id)
      .Add("voxels", material.voxels)
      .Add("components", material.components);
  }
  std::string line;
  for (const lamina::HeartPhantomMaterial& material : report.materials)
  {
    if (material.id > 0)
    {
      line +=
        (line.empty() ? "" : "; ") + (material.id == 1 ? std::string("tissue: ") : std::string("blood: ")) +
        lamina::Amount(material.voxels, "voxel") + " in " + lamina::Amount(material.components, "piece");
    }
  }
  return lamina::Report().Add("materials", rows).Add("mendedVoxels", report.mendedVoxels).Tell(line);
}

} // namespace

vtkHeartPhantomSource::vtkHeartPhantomSource()
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
}

int vtkHeartPhantomSource::RequestInformation(vtkInformation*, vtkInformationVector**,
                                              vtkInformationVector* outputs)
{
  const auto grid = lamina::HeartPhantomGrid(OptionsOf(this));
  if (!grid)
  {
    return lamina::Fail(this, grid.GetError());
  }
  const int types[2] = { VTK_UNSIGNED_CHAR, VTK_INT };
  for (int port = 0; port < 2; ++port)
  {
    vtkInformation* info = outputs->GetInformationObject(port);
    lamina::WriteInformation(*grid, info);
    vtkDataObject::SetPointDataActiveScalarInfo(info, types[port], 1);
  }
  return 1;
}

int vtkHeartPhantomSource::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkImageData* image = vtkImageData::GetData(outputs, 0);
  vtkImageData* truth = vtkImageData::GetData(outputs, 1);
  return lamina::RunStage(this,
                          [&]() -> lamina::Status
                          {
                            lamina::GreyImage grey;
                            lamina::LabelImage labels;
                            lamina::AlgorithmMonitor monitor(this);
                            const auto report =
                              lamina::MakeHeartPhantom(grey, labels, OptionsOf(this), monitor);
                            if (!report)
                            {
                              return report.GetError();
                            }
                            lamina::WriteGeometry(grey.grid, image);
                            WriteIntensity(grey, image);
                            lamina::WriteGeometry(labels.grid, truth);
                            lamina::WriteLabels(labels, truth);
                            truth->GetPointData()->AddArray(
                              lamina::MakeArray<vtkUnsignedCharArray>(lamina::names::Parts, report->parts));
                            std::vector<lamina::Id> components;
                            for (const lamina::HeartPhantomMaterial& material : report->materials)
                            {
                              components.push_back(material.components);
                            }
                            truth->GetFieldData()->AddArray(lamina::MakeArray<vtkIdTypeArray>(
                              lamina::names::MaterialComponents, components));
                            lamina::AttachReport(truth, "HeartPhantom", Describe(*report));
                            return lamina::Done{};
                          });
}

const char* vtkHeartPhantomSource::GetSummary()
{
  return lamina::SummaryOf(this, "HeartPhantom");
}

void vtkHeartPhantomSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "Length: " << this->Length << "\n";
  os << indent << "Noise: " << this->Noise << "\n";
  os << indent << "Blur: " << this->Blur << "\n";
  os << indent << "Bias: " << this->Bias << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "OpenVessels: " << this->OpenVessels << "\n";
}
