// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMultimaterialSegmentation.h"

#include "AlgorithmMonitor.h"
#include "Arrays.h"
#include "ImageBridge.h"
#include "MeshArrayNames.h"
#include "Report.h"
#include "Stage.h"

#include "Segmentation/Segment.h"

#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

vtkStandardNewMacro(vtkMultimaterialSegmentation);

namespace
{

lamina::Report Describe(const lamina::SegmentReport& report)
{
  std::vector<lamina::Report> rules;
  for (const lamina::SegmentRule& rule : report.rules)
  {
    rules.emplace_back();
    rules.back()
      .Add("rule", rule.name)
      .Add("material", rule.material)
      .Add("components", rule.components)
      .Add("voxels", rule.voxels);
  }
  std::vector<lamina::Report> materials;
  for (const lamina::SegmentMaterial& material : report.materials)
  {
    materials.emplace_back();
    materials.back()
      .Add("material", material.id)
      .Add("voxels", material.voxels)
      .Add("components", material.components);
  }
  return lamina::Report()
    .Add("rules", rules)
    .Add("materials", materials)
    .Add("least", report.least)
    .Add("greatest", report.greatest)
    .Add("disputed", report.disputed)
    .Add("passes", report.passes);
}

void FillTable(const lamina::SegmentReport& report, vtkTable* table)
{
  vtkNew<vtkStringArray> rules;
  vtkNew<vtkIntArray> materials;
  vtkNew<vtkIdTypeArray> components;
  vtkNew<vtkIdTypeArray> voxels;
  rules->SetName("Rule");
  materials->SetName("Material");
  components->SetName("Components");
  voxels->SetName("Voxels");
  const auto add = [&](const std::string& rule, int material, lamina::Id parts, lamina::Id count)
  {
    rules->InsertNextValue(rule);
    materials->InsertNextValue(material);
    components->InsertNextValue(parts);
    voxels->InsertNextValue(count);
  };
  for (const lamina::SegmentRule& rule : report.rules)
  {
    add(rule.name, rule.material, rule.components, rule.voxels);
  }
  for (const lamina::SegmentMaterial& material : report.materials)
  {
    add("in all", material.id, material.components, material.voxels);
  }
  for (vtkAbstractArray* column :
       std::initializer_list<vtkAbstractArray*>{ rules, materials, components, voxels })
  {
    table->AddColumn(column);
  }
}

} // namespace

vtkMultimaterialSegmentation::vtkMultimaterialSegmentation()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

void vtkMultimaterialSegmentation::AddThreshold(double threshold)
{
  this->Thresholds.push_back(threshold);
  this->Modified();
}

void vtkMultimaterialSegmentation::ClearThresholds()
{
  this->Thresholds.clear();
  this->Modified();
}

double vtkMultimaterialSegmentation::GetThreshold(int index)
{
  return index >= 0 && index < this->GetNumberOfThresholds()
           ? this->Thresholds[static_cast<std::size_t>(index)]
           : 0.0;
}

int vtkMultimaterialSegmentation::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
  return 1;
}

int vtkMultimaterialSegmentation::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkImageData" : "vtkTable");
  return 1;
}

int vtkMultimaterialSegmentation::RequestInformation(vtkInformation*, vtkInformationVector**,
                                                     vtkInformationVector* outputs)
{
  vtkDataObject::SetPointDataActiveScalarInfo(outputs->GetInformationObject(0), VTK_INT, 1);
  return 1;
}

int vtkMultimaterialSegmentation::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs,
                                                      vtkInformationVector*)
{
  // Components run through the whole image.
  for (int port = 0; port < 2; ++port)
  {
    if (vtkInformation* info = inputs[port]->GetInformationObject(0))
    {
      int extent[6];
      info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
      info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent, 6);
    }
  }
  return 1;
}

int vtkMultimaterialSegmentation::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                              vtkInformationVector* outputs)
{
  vtkImageData* input = vtkImageData::GetData(inputs[0]);
  vtkImageData* maskInput = vtkImageData::GetData(inputs[1]);
  vtkImageData* output = vtkImageData::GetData(outputs, 0);
  vtkTable* table = vtkTable::GetData(outputs, 1);
  if (!input || input->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  return lamina::RunStage(this,
                          [&]() -> lamina::Status
                          {
                            const auto scalars = lamina::FindScalars(input, nullptr, nullptr);
                            if (!scalars)
                            {
                              return scalars.GetError();
                            }
                            const auto grey = lamina::ReadGrey(input, *scalars);
                            if (!grey)
                            {
                              return grey.GetError();
                            }
                            lamina::SegmentOptions options;
                            options.thresholds = this->Thresholds;
                            options.coronaryMajority = this->CoronaryMajority;
                            options.largestOnly = this->LargestOnly;
                            options.minimumShare = this->MinimumShare;
                            options.minimumVoxels = this->MinimumVoxels;
                            options.openAtImageBorder = this->OpenAtImageBorder;
                            options.openAtMaskBorder = this->OpenAtMaskBorder;
                            lamina::LabelImage mask;
                            if (maskInput)
                            {
                              auto read = lamina::ReadMask(maskInput, grey->grid);
                              if (!read)
                              {
                                return read.GetError();
                              }
                              mask = std::move(*read);
                              options.mask = &mask;
                            }
                            lamina::LabelImage labels;
                            std::vector<unsigned char> disputed;
                            lamina::AlgorithmMonitor monitor(this);
                            const auto report = lamina::Segment(*grey, labels, disputed, options, monitor);
                            if (!report)
                            {
                              return report.GetError();
                            }
                            for (const std::string& warning : report->warnings)
                            {
                              vtkWarningMacro(<< warning);
                            }
                            output->ShallowCopy(input);
                            lamina::WriteLabels(labels, output);
                            output->GetPointData()->AddArray(
                              lamina::MakeArray<vtkUnsignedCharArray>(lamina::names::Disputed, disputed));
                            lamina::AttachReport(output, "MultimaterialSegmentation", Describe(*report));
                            FillTable(*report, table);
                            return lamina::Done{};
                          });
}

void vtkMultimaterialSegmentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Thresholds:";
  for (const double threshold : this->Thresholds)
  {
    os << " " << threshold;
  }
  os << "\n" << indent << "LargestOnly: " << this->LargestOnly << "\n";
  os << indent << "MinimumShare: " << this->MinimumShare << "\n";
  os << indent << "MinimumVoxels: " << this->MinimumVoxels << "\n";
  os << indent << "OpenAtImageBorder: " << this->OpenAtImageBorder << "\n";
  os << indent << "OpenAtMaskBorder: " << this->OpenAtMaskBorder << "\n";
  os << indent << "CoronaryMajority: " << this->CoronaryMajority << "\n";
}
