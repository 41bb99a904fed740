// SPDX-License-Identifier: BSD-3-Clause
// The edit that the properties of vtkReassignVoxels describe.
#pragma once

#include "EditDraft.h"

class vtkImageData;
class vtkReassignVoxels;
class vtkSelection;

namespace lamina
{

/// What Shape and the properties that go with it ask for.
Result<VoxelEdit> MakeCurrentEdit(vtkReassignVoxels* self, vtkImageData* image, vtkSelection* selection);

} // namespace lamina
