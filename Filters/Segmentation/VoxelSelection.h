// SPDX-License-Identifier: BSD-3-Clause
// What a selection of ParaView means for the voxels of an image.
#pragma once

#include "Base/Result.h"

#include <vector>

class vtkImageData;
class vtkSelection;

namespace lamina
{

/// The ids of the selected voxels, ascending. Of any kind that ParaView's Extract Selection understands: ids,
/// frusta, locations, thresholds, queries, and their combinations. A selected cell stands for the eight
/// voxels at its corners. A failure for ids that the image does not have, and for what is neither points nor
/// cells.
Result<std::vector<Id>> SelectedVoxels(vtkImageData* image, vtkSelection* selection);

} // namespace lamina
