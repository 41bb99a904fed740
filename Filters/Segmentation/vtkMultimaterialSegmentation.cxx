// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMultimaterialSegmentation.h"

#include "AlgorithmMonitor.h"
#include "Arrays.h"
#include "ImageBridge.h"
#include "ImageRequests.h"
#include "MeshArrayNames.h"
#include "SegmentationReport.h"
#include "Stage.h"

#include "Segmentation/Segment.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

vtkStandardNewMacro(vtkMultimaterialSegmentation);

namespace
{

/// The properties for the kernel, which checks the numbers; choices are checked here.
lamina::Status ReadOptions(vtkMultimaterialSegmentation* self, lamina::SegmentOptions& options)
{
  for (const int choice : { self->GetKeptComponents(), self->GetRepairTopology() })
  {
    if (choice < 0 || choice > 2)
    {
      return lamina::InvalidOption("KeptComponents and RepairTopology are 0, 1 or 2, not " +
                                   std::to_string(choice));
    }
  }
  if (self->GetDisputedVoxels() < 0 || self->GetDisputedVoxels() > 1)
  {
    return lamina::InvalidOption("DisputedVoxels is 0 or 1, not " +
                                 std::to_string(self->GetDisputedVoxels()));
  }
  options.thresholds.clear();
  for (int t = 0; t < self->GetNumberOfThresholds(); ++t)
  {
    options.thresholds.push_back(self->GetThreshold(t));
  }
  options.forbidden.clear();
  for (int p = 0; p < self->GetNumberOfForbiddenContacts(); ++p)
  {
    const int* pair = self->GetForbiddenContact(p);
    options.forbidden.push_back({ { pair[0], pair[1] } });
  }
  options.smoothingSweeps = self->GetSmoothingSweeps();
  options.coronaryMajority = self->GetCoronaryMajority();
  options.disputed = static_cast<lamina::DisputedChoice>(self->GetDisputedVoxels());
  options.dissolveSkins = self->GetDissolveSkins();
  options.kept = static_cast<lamina::KeptComponents>(self->GetKeptComponents());
  options.keptCount = self->GetComponentCount();
  options.minimumShare = self->GetMinimumShare();
  options.minimumVoxels = self->GetMinimumVoxels();
  options.repair = static_cast<lamina::TopologyRepair>(self->GetRepairTopology());
  options.openAtImageBorder = self->GetOpenAtImageBorder();
  options.openAtMaskBorder = self->GetOpenAtMaskBorder();
  return lamina::Done{};
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

void vtkMultimaterialSegmentation::AddForbiddenContact(int first, int second)
{
  this->ForbiddenContacts.push_back({ { first, second } });
  this->Modified();
}

void vtkMultimaterialSegmentation::ClearForbiddenContacts()
{
  this->ForbiddenContacts.clear();
  this->Modified();
}

const int* vtkMultimaterialSegmentation::GetForbiddenContact(int index)
{
  static const int none[2] = { -1, -1 };
  return index >= 0 && index < this->GetNumberOfForbiddenContacts()
           ? this->ForbiddenContacts[static_cast<std::size_t>(index)].data()
           : none;
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
  return lamina::TellScalarType(outputs, VTK_INT);
}

int vtkMultimaterialSegmentation::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs,
                                                      vtkInformationVector*)
{
  // Components run through the whole image.
  return lamina::AskForWholeImages(inputs, 2);
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
  return lamina::RunStage(
    this,
    [&]() -> lamina::Status
    {
      const auto scalars = lamina::FindScalars(input, nullptr, nullptr);
      if (!scalars)
      {
        return scalars.GetError();
      }
      const auto grey = lamina::ViewGrey(input, *scalars);
      if (!grey)
      {
        return grey.GetError();
      }
      lamina::SegmentOptions options;
      if (const auto read = ReadOptions(this, options); !read)
      {
        return read.GetError();
      }
      lamina::RegionMask mask;
      if (maskInput)
      {
        auto read = lamina::ReadRegion(maskInput, grey->grid);
        if (!read)
        {
          return read.GetError();
        }
        mask = std::move(*read);
        options.mask = &mask;
      }
      lamina::LabelImage labels;
      std::vector<unsigned char> flags;
      lamina::AlgorithmMonitor monitor(this);
      const auto report = lamina::Segment(*grey, labels, flags, options, monitor);
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
        lamina::MakeArray<vtkUnsignedCharArray>(lamina::names::Disputed, flags));
      lamina::AttachReport(output, "MultimaterialSegmentation", lamina::Describe(*report));
      lamina::FillTable(*report, table);
      lamina::AttachReport(table, "MultimaterialSegmentation", lamina::Describe(*report));
      return lamina::Done{};
    });
}

const char* vtkMultimaterialSegmentation::GetSummary()
{
  return lamina::SummaryOf(this, "MultimaterialSegmentation");
}

void vtkMultimaterialSegmentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Thresholds:";
  for (const double threshold : this->Thresholds)
  {
    os << " " << threshold;
  }
  os << "\n" << indent << "SmoothingSweeps: " << this->SmoothingSweeps << "\n";
  os << indent << "DisputedVoxels: " << this->DisputedVoxels << "\n";
  os << indent << "DissolveSkins: " << this->DissolveSkins << "\n";
  os << indent << "KeptComponents: " << this->KeptComponents << "\n";
  os << indent << "ComponentCount: " << this->ComponentCount << "\n";
  os << indent << "MinimumShare: " << this->MinimumShare << "\n";
  os << indent << "MinimumVoxels: " << this->MinimumVoxels << "\n";
  os << indent << "ForbiddenContacts:";
  for (const auto& pair : this->ForbiddenContacts)
  {
    os << " (" << pair[0] << ", " << pair[1] << ")";
  }
  os << "\n" << indent << "RepairTopology: " << this->RepairTopology << "\n";
  os << indent << "OpenAtImageBorder: " << this->OpenAtImageBorder << "\n";
  os << indent << "OpenAtMaskBorder: " << this->OpenAtMaskBorder << "\n";
  os << indent << "CoronaryMajority: " << this->CoronaryMajority << "\n";
}
