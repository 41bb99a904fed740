// SPDX-License-Identifier: BSD-3-Clause
#include "EditDraft.h"

#include "EditText.h"
#include "ImageBridge.h"
#include "VoxelSelection.h"

#include <vtkImageData.h>

#include <utility>

namespace lamina
{

Result<std::vector<VoxelEdit>> ParseEdits(const std::vector<std::string>& texts)
{
  std::vector<VoxelEdit> edits;
  for (const std::string& text : texts)
  {
    auto edit = ParseEdit(text, "edit " + std::to_string(edits.size() + 1));
    if (!edit)
    {
      return edit.GetError();
    }
    edits.push_back(std::move(*edit));
  }
  return edits;
}

VoxelEdit DraftEdit(const std::string& name, int to, const std::vector<int>& from)
{
  VoxelEdit edit;
  edit.name = name;
  edit.to = to;
  edit.from = from;
  return edit;
}

VoxelEdit WithBox(VoxelEdit edit, const double bounds[6])
{
  edit.shape = EditShape::Box;
  edit.low = { bounds[0], bounds[2], bounds[4] };
  edit.high = { bounds[1], bounds[3], bounds[5] };
  return edit;
}

VoxelEdit WithSphere(VoxelEdit edit, const double center[3], double radius)
{
  edit.shape = EditShape::Sphere;
  edit.centre = { center[0], center[1], center[2] };
  edit.radius = radius;
  return edit;
}

Result<VoxelEdit> WithVoxels(VoxelEdit edit, vtkImageData* image, std::vector<Id> voxels)
{
  const Result<GridGeometry> grid = ReadGeometry(image);
  if (!grid)
  {
    return grid.GetError();
  }
  edit.shape = EditShape::Voxels;
  edit.size = grid->size;
  edit.voxels = std::move(voxels);
  return edit;
}

Result<VoxelEdit> WithSelection(VoxelEdit edit, vtkImageData* image, vtkSelection* selection)
{
  Result<std::vector<Id>> voxels = SelectedVoxels(image, selection);
  if (!voxels)
  {
    return voxels.GetError();
  }
  return WithVoxels(std::move(edit), image, std::move(*voxels));
}

Result<std::string> Finish(const VoxelEdit& edit, vtkImageData* image)
{
  if (edit.shape == EditShape::Voxels && edit.voxels.empty())
  {
    return InvalidInput(edit.name + " has no voxels: select some of the image first");
  }
  GridGeometry any;
  any.size = edit.size;
  const Result<GridGeometry> grid = image ? ReadGeometry(image) : Result<GridGeometry>(any);
  if (!grid)
  {
    return grid.GetError();
  }
  ReassignOptions options;
  options.edits.push_back(edit);
  if (const Result<bool> good = CheckEdits(*grid, options); !good)
  {
    return good.GetError();
  }
  return WriteEdit(edit);
}

} // namespace lamina
