// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMaskPropagation.h"

#include "AlgorithmMonitor.h"
#include "ImageBridge.h"
#include "ImageRequests.h"
#include "MaskBridge.h"
#include "Report.h"
#include "SliceReslicing.h"
#include "Stage.h"

#include "Base/Text.h"
#include "Segmentation/MaskPropagation.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkMaskPropagation);

namespace
{

const char* const MethodNames[] = { "shape interpolation", "registration", "registration and grey values" };

lamina::Report Describe(const lamina::MaskPropagationReport& report)
{
  const std::vector<int> drawn(report.drawn.begin(), report.drawn.end());
  return lamina::Report()
    .Add("sliceAxis", report.axis)
    .Add("drawnSlices", drawn)
    .Add("regions", report.ids)
    .Add("carriedSlices", static_cast<lamina::Id>(report.slices.size()))
    .Add("method", MethodNames[report.method - 1])
    .Add("diceForetoldByShape", report.foretold[0])
    .Add("diceForetoldByRegistration", report.foretold[1])
    .Add("diceForetoldByGreyValues", report.foretold[2])
    .Add("residual", report.residual)
    .Add("residualUnregistered", report.unregisteredResidual)
    .Add("noise", report.noise)
    .Add("warnings", report.warnings)
    .Tell(lamina::Amount(static_cast<lamina::Id>(drawn.size()), "drawn slice") + " carried to " +
          lamina::Amount(static_cast<lamina::Id>(report.slices.size()), "other") + " by " +
          MethodNames[report.method - 1]);
}

void FillTable(const lamina::MaskPropagationReport& report, vtkTable* table)
{
  vtkNew<vtkIntArray> slices;
  vtkNew<vtkIntArray> from;
  vtkNew<vtkIntArray> to;
  vtkNew<vtkIdTypeArray> voxels;
  vtkNew<vtkDoubleArray> residuals;
  slices->SetName("Slice");
  from->SetName("From");
  to->SetName("To");
  voxels->SetName("Voxels");
  residuals->SetName("Residual");
  for (const lamina::PropagatedSlice& slice : report.slices)
  {
    slices->InsertNextValue(static_cast<int>(slice.slice));
    from->InsertNextValue(static_cast<int>(slice.from));
    to->InsertNextValue(static_cast<int>(slice.to));
    voxels->InsertNextValue(slice.voxels);
    residuals->InsertNextValue(slice.residual);
  }
  for (vtkAbstractArray* column :
       std::initializer_list<vtkAbstractArray*>{ slices, from, to, voxels, residuals })
  {
    table->AddColumn(column);
  }
}

} // namespace

vtkMaskPropagation::vtkMaskPropagation()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

void vtkMaskPropagation::AddDrawnSlice(int slice)
{
  this->DrawnSlices.push_back(slice);
  this->Modified();
}

void vtkMaskPropagation::ClearDrawnSlices()
{
  this->DrawnSlices.clear();
  this->Modified();
}

int vtkMaskPropagation::GetDrawnSlice(int index)
{
  return index >= 0 && index < this->GetNumberOfDrawnSlices()
           ? this->DrawnSlices[static_cast<std::size_t>(index)]
           : 0;
}

int vtkMaskPropagation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkMaskPropagation::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkImageData" : "vtkTable");
  return 1;
}

int vtkMaskPropagation::RequestInformation(vtkInformation*, vtkInformationVector**,
                                           vtkInformationVector* outputs)
{
  return lamina::TellScalarType(outputs, VTK_UNSIGNED_SHORT);
}

int vtkMaskPropagation::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs,
                                            vtkInformationVector*)
{
  // A slice depends on those around it, and the drawn ones may be anywhere.
  return lamina::AskForWholeImages(inputs, 2);
}

int vtkMaskPropagation::RequestData(vtkInformation*, vtkInformationVector** inputs,
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
                            if (!maskInput)
                            {
                              return lamina::InvalidInput("there is no mask: connect one to port 1");
                            }
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
                            const auto mask = lamina::ReadRegions(maskInput, grey->grid);
                            if (!mask)
                            {
                              return mask.GetError();
                            }
                            lamina::MaskPropagationOptions options;
                            options.axis = this->SliceAxis;
                            options.drawnSlices.assign(this->DrawnSlices.begin(), this->DrawnSlices.end());
                            for (std::size_t a = 0; a < 3; ++a)
                            {
                              options.firstSlice[a] = input->GetExtent()[2 * a];
                            }
                            options.maskValue = this->MaskValue;
                            options.maximumSlices = this->MaximumSlices;
                            options.method = this->Method;
                            options.levels = this->Levels;
                            options.smoothness = this->Smoothness;
                            options.searchRange = this->SearchRange;
                            const lamina::SliceReslicing reslicing;
                            options.warper = &reslicing;
                            lamina::LabelImage full;
                            lamina::AlgorithmMonitor monitor(this);
                            const auto report = lamina::PropagateMask(*grey, *mask, full, options, monitor);
                            if (!report)
                            {
                              return report.GetError();
                            }
                            for (const std::string& warning : report->warnings)
                            {
                              vtkWarningMacro(<< warning);
                            }
                            output->ShallowCopy(input);
                            lamina::WriteRegions(full, output);
                            lamina::AttachReport(output, "MaskPropagation", Describe(*report));
                            FillTable(*report, table);
                            return lamina::Done{};
                          });
}

const char* vtkMaskPropagation::GetSummary()
{
  return lamina::SummaryOf(this, "MaskPropagation");
}

void vtkMaskPropagation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SliceAxis: " << this->SliceAxis << "\n";
  os << indent << "DrawnSlices:";
  for (const int slice : this->DrawnSlices)
  {
    os << " " << slice;
  }
  os << "\n" << indent << "MaskValue: " << this->MaskValue << "\n";
  os << indent << "MaximumSlices: " << this->MaximumSlices << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "Levels: " << this->Levels << "\n";
  os << indent << "Smoothness: " << this->Smoothness << "\n";
  os << indent << "SearchRange: " << this->SearchRange << "\n";
}
