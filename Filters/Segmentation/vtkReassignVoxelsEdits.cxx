// SPDX-License-Identifier: BSD-3-Clause
// How vtkReassignVoxels gets its edits, keeps them and takes them from files.
#include "vtkReassignVoxels.h"

#include "CurrentEdit.h"
#include "EditFile.h"

#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkSelection.h"

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

} // namespace

namespace lamina
{

Result<VoxelEdit> MakeCurrentEdit(vtkReassignVoxels* self, vtkImageData* image, vtkSelection* selection)
{
  std::vector<int> from;
  for (int n = 0; n < self->GetNumberOfFromMaterials(); ++n)
  {
    from.push_back(self->GetFromMaterial(n));
  }
  auto draft = DraftEdit("the current edit", self->GetToMaterial(), from);
  switch (self->GetShape())
  {
    case vtkReassignVoxels::Selection:
      return WithSelection(std::move(draft), image, selection);
    case vtkReassignVoxels::Box:
      return WithBox(std::move(draft), self->GetBounds());
    case vtkReassignVoxels::Sphere:
      return WithSphere(std::move(draft), self->GetCenter(), self->GetRadius());
    default:
      return InvalidOption("the shape of the current edit is " + std::to_string(self->GetShape()) +
                           ": choose 1 (selection), 2 (box) or 3 (sphere)");
  }
}

} // namespace lamina

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
  const bool kept = Take(this, lamina::MakeCurrentEdit(this, image, selection), image);
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
