// SPDX-License-Identifier: BSD-3-Clause
// Lists of edits, and edits in the making: what the properties of Reassign Voxels, or one of its methods, ask
// for.
#pragma once

#include "Segmentation/Reassign.h"

#include <string>
#include <vector>

class vtkImageData;
class vtkSelection;

namespace lamina
{

/// The edits that the texts describe, named "edit 1" and so on.
Result<std::vector<VoxelEdit>> ParseEdits(const std::vector<std::string>& texts);

/// An edit of material `to`, restricted to the materials `from`; as yet without a shape.
VoxelEdit DraftEdit(const std::string& name, int to, const std::vector<int>& from);
VoxelEdit WithBox(VoxelEdit edit, const double bounds[6]);
VoxelEdit WithSphere(VoxelEdit edit, const double center[3], double radius);
/// The voxels with these ids, of an image of this size.
Result<VoxelEdit> WithVoxels(VoxelEdit edit, vtkImageData* image, std::vector<Id> voxels);
/// The selected voxels, as a list.
Result<VoxelEdit> WithSelection(VoxelEdit edit, vtkImageData* image, vtkSelection* selection);

/// The edit as text for the list; a failure if it cannot be applied to the image (null: whatever the image),
/// or has no voxels.
Result<std::string> Finish(const VoxelEdit& edit, vtkImageData* image);

} // namespace lamina
