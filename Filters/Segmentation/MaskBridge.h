// SPDX-License-Identifier: BSD-3-Clause
// Masks of several regions to and from the kernel.
#pragma once

#include "Stage.h"

#include "Mesh/LabelImage.h"

class vtkImageData;

namespace lamina
{

/// The regions of a mask of any number type that stands where `image` does: whole numbers from 0 to 65,535;
/// NaN is 0. A failure if its size, place or axes differ.
Result<LabelImage> ReadRegions(vtkImageData* mask, const GridGeometry& image);
/// Put the regions on an image of the same size as its Mask, and make that its active scalars.
void WriteRegions(const LabelImage& regions, vtkImageData* image);

} // namespace lamina
