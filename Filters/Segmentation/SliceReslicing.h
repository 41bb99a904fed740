// SPDX-License-Identifier: BSD-3-Clause
// Slices carried along displacements by VTK's transforms and image filters.
#pragma once

#include "Segmentation/SliceImage.h"

namespace lamina
{

/// vtkImageReslice along a vtkGridTransform, both linear: to rounding the same as the kernel's own. Each call
/// has a pipeline of its own, of one thread, as the kernel calls it from many.
class SliceReslicing : public SliceWarper
{
public:
  std::vector<SliceImage> Pull(const std::vector<const SliceImage*>& images,
                               const SliceField& field) const override;
};

} // namespace lamina
