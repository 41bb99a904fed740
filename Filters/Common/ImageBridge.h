// SPDX-License-Identifier: BSD-3-Clause
// Between vtkImageData and the kernel's images. Origin, spacing, direction and extents that do not start at 0
// are honoured.
#pragma once

#include "Stage.h"

#include "Mesh/GreyView.h"
#include "Mesh/LabelImage.h"

class vtkDataArray;
class vtkImageData;

namespace lamina
{

/// Where the image's voxels stand; a failure for 2-D images, spacings that are not positive and skewed axes.
Result<GridGeometry> ReadGeometry(vtkImageData* image);

/// The point array `name` if the image has it, else its only array; a failure if there is none, or a choice.
/// `filter`: who would make the array, for the message; may be null.
Result<vtkDataArray*> FindScalars(vtkImageData* image, const char* name, const char* filter);

/// Material ids from an array of any number type: whole numbers from 0 to 65,535.
Result<LabelImage> ReadLabels(vtkImageData* image, vtkDataArray* scalars);
/// Grey values of any number type where they lie in the array, which must outlive the view; NaN means that
/// nothing is known there.
Result<GreyView> ViewGrey(vtkImageData* image, vtkDataArray* scalars);
/// Grey values that belong to an image of labels: of the same grid (size, and place in the world to half a
/// voxel), in the array Intensity or the only one.
Result<GreyView> ViewGreyBeside(vtkImageData* image, const GridGeometry& labels);
/// Grey values in a copy of doubles, for work that goes over few values again and again.
Result<GreyImage> ReadGrey(vtkImageData* image, vtkDataArray* scalars);
/// A region of interest of the same grid as `image` (size, and place in the world to half a voxel): inside
/// where the mask's values are 1, as other values mark regions that are of no interest.
Result<RegionMask> ReadRegion(vtkImageData* mask, const GridGeometry& image);
/// The same as labels: 1 inside, else 0.
Result<LabelImage> ReadMask(vtkImageData* mask, const GridGeometry& image);

/// Set the geometry of a new image whose extent starts at 0.
void WriteGeometry(const GridGeometry& grid, vtkImageData* image);
/// Put the labels on an image of the same size as its material ids, and make them its active scalars.
void WriteLabels(const LabelImage& labels, vtkImageData* image);

} // namespace lamina
