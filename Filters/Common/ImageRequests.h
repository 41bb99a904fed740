// SPDX-License-Identifier: BSD-3-Clause
// What filters of images tell the pipeline, and ask of it, before their work.
#pragma once

#include "Mesh/LabelImage.h"

class vtkInformation;
class vtkInformationVector;

namespace lamina
{

/// RequestInformation of a source: the image that it is going to make.
void WriteInformation(const GridGeometry& grid, vtkInformation* information);
/// RequestInformation of a filter: the first output is an image of one number of `type` (VTK_INT ...) a
/// point. Returns what RequestInformation has to return.
int TellScalarType(vtkInformationVector* outputs, int type);
/// RequestUpdateExtent of a filter to which every voxel matters: the whole images on the first `ports` ports,
/// as far as they are connected. Returns what RequestUpdateExtent has to return.
int AskForWholeImages(vtkInformationVector** inputs, int ports);

} // namespace lamina
