// SPDX-License-Identifier: BSD-3-Clause
#include "vtkReassignVoxels.h"

#include "AlgorithmMonitor.h"
#include "EditDraft.h"
#include "EditFile.h"
#include "ImageBridge.h"
#include "MeshArrayNames.h"
#include "ReassignOutput.h"
#include "Report.h"
#include "Stage.h"

#include "Segmentation/Reassign.h"

#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkSelection.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkReassignVoxels);

namespace
{

/// The data on port `port`, brought up to date; null if nothing is connected.
vtkDataObject* UpdatedInput(vtkAlgorithm* self, int port)
{
  if (self->GetNumberOfInputConnections(port) == 0)
  {
    return nullptr;
  }
  int from = 0;
  vtkAlgorithm* maker = self->GetInputAlgorithm(port, 0, from);
  maker->Update(from);
  return maker->GetOutputDataObject(from);
}

/// The image on port 0; an error if there is none, as voxels are numbered in it.
vtkImageData* UpdatedImage(vtkAlgorithm* self)
{
  auto* image = vtkImageData::SafeDownCast(UpdatedInput(self, 0));
  if (!image || image->GetNumberOfPoints() == 0)
  {
    vtkErrorWithObjectMacro(self, << "no edit was added: connect the image first, whose voxels are meant");
    return nullptr;
  }
  return image;
}

/// Adds a new edit, or says why not.
bool Take(vtkReassignVoxels* self, const lamina::Result<lamina::VoxelEdit>& edit, vtkImageData* image)
{
  const auto text = edit ? lamina::Finish(*edit, image) : lamina::Result<std::string>(edit.GetError());
  if (!text)
  {
    vtkErrorWithObjectMacro(self, << "no edit was added: " << text.GetError().message);
    return false;
  }
  self->AddEdit(text->c_str());
  return true;
}

lamina::VoxelEdit NewEdit(int to, int from)
{
  return lamina::DraftEdit("the new edit", to, from == -1 ? std::vector<int>() : std::vector<int>{ from });
}

/// What Shape and the properties that go with it ask for.
lamina::Result<lamina::VoxelEdit> MakeCurrentEdit(vtkReassignVoxels* self, vtkImageData* image,
                                                  vtkSelection* selection)
{
  std::vector<int> from;
  for (int n = 0; n < self->GetNumberOfFromMaterials(); ++n)
  {
    from.push_back(self->GetFromMaterial(n));
  }
  auto draft = lamina::DraftEdit("the current edit", self->GetToMaterial(), from);
  switch (self->GetShape())
  {
    case vtkReassignVoxels::Selection:
      return WithSelection(std::move(draft), image, selection);
    case vtkReassignVoxels::Box:
      return WithBox(std::move(draft), self->GetBounds());
    case vtkReassignVoxels::Sphere:
      return WithSphere(std::move(draft), self->GetCenter(), self->GetRadius());
    default:
      return lamina::InvalidOption("the shape of the current edit is " + std::to_string(self->GetShape()) +
                                   ": choose 1 (selection), 2 (box) or 3 (sphere)");
  }
}

} // namespace

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

bool vtkReassignVoxels::AddBox(const double bounds[6], int to, int from)
{
  return Take(this, WithBox(NewEdit(to, from), bounds), nullptr);
}

bool vtkReassignVoxels::AddSphere(const double center[3], double radius, int to, int from)
{
  return Take(this, WithSphere(NewEdit(to, from), center, radius), nullptr);
}

bool vtkReassignVoxels::AddVoxels(vtkIdTypeArray* ids, int to, int from)
{
  std::vector<lamina::Id> voxels;
  for (vtkIdType v = 0; ids && v < ids->GetNumberOfValues(); ++v)
  {
    voxels.push_back(ids->GetValue(v));
  }
  vtkImageData* image = UpdatedImage(this);
  return image && Take(this, WithVoxels(NewEdit(to, from), image, voxels), image);
}

bool vtkReassignVoxels::AddSelection(vtkSelection* selection, int to, int from)
{
  vtkImageData* image = UpdatedImage(this);
  return image && Take(this, WithSelection(NewEdit(to, from), image, selection), image);
}

bool vtkReassignVoxels::KeepEdit()
{
  vtkImageData* image = this->Shape == Selection ? UpdatedImage(this) : nullptr;
  if (this->Shape == Selection && !image)
  {
    return false;
  }
  auto* selection = image ? vtkSelection::SafeDownCast(UpdatedInput(this, 1)) : nullptr;
  const bool kept = Take(this, MakeCurrentEdit(this, image, selection), image);
  if (kept)
  {
    this->SetShape(None);
  }
  return kept;
}

bool vtkReassignVoxels::SaveEdits()
{
  const auto saved = this->FileName && *this->FileName
                       ? lamina::WriteEditFile(this->FileName, this->Edits)
                       : lamina::Result<bool>(lamina::InvalidOption("no file name is given for the edits"));
  if (!saved)
  {
    vtkErrorMacro("the edits were not saved: " << saved.GetError().message);
  }
  return static_cast<bool>(saved);
}

bool vtkReassignVoxels::LoadEdits()
{
  auto loaded = this->FileName && *this->FileName
                  ? lamina::ReadEditFile(this->FileName)
                  : lamina::Result<std::vector<std::string>>(
                      lamina::InvalidOption("no file name is given for the edits"));
  if (!loaded)
  {
    vtkErrorMacro("the edits stay as they are: " << loaded.GetError().message);
    return false;
  }
  this->Edits = std::move(*loaded);
  this->Modified();
  return true;
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
  vtkDataObject::SetPointDataActiveScalarInfo(outputs->GetInformationObject(0), VTK_INT, 1);
  return 1;
}

int vtkReassignVoxels::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs,
                                           vtkInformationVector*)
{
  // Ids count through the whole image.
  vtkInformation* info = inputs[0]->GetInformationObject(0);
  int extent[6];
  info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent, 6);
  return 1;
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
      auto edit = MakeCurrentEdit(this, input, selection);
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
