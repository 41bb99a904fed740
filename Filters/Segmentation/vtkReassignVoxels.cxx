// SPDX-License-Identifier: BSD-3-Clause
#include "vtkReassignVoxels.h"

#include "AlgorithmMonitor.h"
#include "CurrentEdit.h"
#include "EditFile.h"
#include "ImageBridge.h"
#include "ImageRequests.h"
#include "MeshArrayNames.h"
#include "ReassignOutput.h"
#include "Report.h"
#include "Stage.h"

#include "Segmentation/Reassign.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkSelection.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkReassignVoxels);

vtkReassignVoxels::vtkReassignVoxels()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

vtkReassignVoxels::~vtkReassignVoxels()
{
  this->SetFileName(nullptr);
}

void vtkReassignVoxels::AddEdit(const char* json)
{
  this->Edits.emplace_back(json ? json : "");
  this->Modified();
}

void vtkReassignVoxels::ClearEdits()
{
  if (!this->Edits.empty())
  {
    this->Edits.clear();
    this->Modified();
  }
}

void vtkReassignVoxels::RemoveLastEdit()
{
  if (!this->Edits.empty())
  {
    this->Edits.pop_back();
    this->Modified();
  }
}

const char* vtkReassignVoxels::GetEdit(int index)
{
  return index >= 0 && index < this->GetNumberOfEdits() ? this->Edits[static_cast<std::size_t>(index)].c_str()
                                                        : nullptr;
}

vtkStringArray* vtkReassignVoxels::GetEdits()
{
  this->EditArray->Initialize();
  for (const std::string& edit : this->Edits)
  {
    this->EditArray->InsertNextValue(edit);
  }
  return this->EditArray;
}

void vtkReassignVoxels::AddFromMaterial(int material)
{
  this->FromMaterials.push_back(material);
  this->Modified();
}

void vtkReassignVoxels::ClearFromMaterials()
{
  this->FromMaterials.clear();
  this->Modified();
}

int vtkReassignVoxels::GetFromMaterial(int index)
{
  return index >= 0 && index < this->GetNumberOfFromMaterials()
           ? this->FromMaterials[static_cast<std::size_t>(index)]
           : -1;
}

void vtkReassignVoxels::AddForbiddenContact(int first, int second)
{
  this->ForbiddenContacts.push_back({ { first, second } });
  this->Modified();
}

void vtkReassignVoxels::ClearForbiddenContacts()
{
  this->ForbiddenContacts.clear();
  this->Modified();
}

void vtkReassignVoxels::GetForbiddenContact(int index, int pair[2])
{
  const bool known = index >= 0 && index < this->GetNumberOfForbiddenContacts();
  for (std::size_t side = 0; side < 2; ++side)
  {
    pair[side] = known ? this->ForbiddenContacts[static_cast<std::size_t>(index)][side] : -1;
  }
}

int vtkReassignVoxels::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkImageData" : "vtkSelection");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
  return 1;
}

int vtkReassignVoxels::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkImageData" : "vtkTable");
  return 1;
}

int vtkReassignVoxels::RequestInformation(vtkInformation*, vtkInformationVector**,
                                          vtkInformationVector* outputs)
{
  return lamina::TellScalarType(outputs, VTK_INT);
}

int vtkReassignVoxels::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs,
                                           vtkInformationVector*)
{
  // Ids count through the whole image.
  return lamina::AskForWholeImages(inputs, 1);
}

int vtkReassignVoxels::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                   vtkInformationVector* outputs)
{
  vtkImageData* input = vtkImageData::GetData(inputs[0]);
  vtkSelection* selection = vtkSelection::GetData(inputs[1]);
  vtkImageData* output = vtkImageData::GetData(outputs, 0);
  vtkTable* table = vtkTable::GetData(outputs, 1);
  if (!input || input->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  const auto work = [&]() -> lamina::Status
  {
    const auto scalars = lamina::FindScalars(input, lamina::names::MaterialIds, "Multimaterial Segmentation");
    if (!scalars)
    {
      return scalars.GetError();
    }
    auto labels = lamina::ReadLabels(input, *scalars);
    if (!labels)
    {
      return labels.GetError();
    }
    auto edits = lamina::ParseEdits(this->Edits);
    if (!edits)
    {
      return edits.GetError();
    }
    const bool live = this->Shape != None && (this->Shape != Selection || selection);
    if (live)
    {
      auto edit = lamina::MakeCurrentEdit(this, input, selection);
      if (!edit)
      {
        return edit.GetError();
      }
      edits->push_back(std::move(*edit));
    }
    const lamina::ReassignOptions options{ std::move(*edits), this->RepairTopology, this->ForbiddenContacts,
                                           this->OpenAtImageBorder };
    std::vector<unsigned char> decisions;
    lamina::AlgorithmMonitor monitor(this);
    const auto report = lamina::Reassign(*labels, decisions, options, monitor);
    if (!report)
    {
      return report.GetError();
    }
    for (const std::string& warning : report->warnings)
    {
      vtkWarningMacro(<< warning);
    }
    output->ShallowCopy(input);
    lamina::WriteLabels(*labels, output);
    lamina::UpdateDisputed(decisions, output);
    lamina::AttachReport(output, "ReassignVoxels", Describe(*report));
    FillTable(*report, table);
    return lamina::Done{};
  };
  return lamina::RunStage(this, work);
}

const char* vtkReassignVoxels::GetSummary()
{
  return lamina::SummaryOf(this, "ReassignVoxels");
}

void vtkReassignVoxels::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Edits: " << this->Edits.size() << "\n";
  for (const std::string& edit : this->Edits)
  {
    os << indent.GetNextIndent() << edit << "\n";
  }
  os << indent << "Shape: " << this->Shape << "\n";
  os << indent << "ToMaterial: " << this->ToMaterial << "\n";
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "RepairTopology: " << this->RepairTopology << "\n";
  os << indent << "ForbiddenContacts: " << this->ForbiddenContacts.size() << "\n";
  os << indent << "OpenAtImageBorder: " << this->OpenAtImageBorder << "\n";
}
