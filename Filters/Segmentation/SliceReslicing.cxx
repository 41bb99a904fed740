// SPDX-License-Identifier: BSD-3-Clause
#include "SliceReslicing.h"

#include <vtkGridTransform.h>
#include <vtkImageData.h>
#include <vtkImageReslice.h>
#include <vtkNew.h>

#include <algorithm>

namespace lamina
{

namespace
{

/// An image of one slice with an image of the kernel in each component, and zeros in the others.
void Interleave(const std::vector<const SliceImage*>& images, int components, vtkImageData* slice)
{
  slice->SetDimensions(static_cast<int>(images.front()->width), static_cast<int>(images.front()->height), 1);
  slice->AllocateScalars(VTK_FLOAT, components);
  auto* values = static_cast<float*>(slice->GetScalarPointer());
  const Id count = images.front()->Count();
  std::fill(values, values + count * components, 0.0F);
  for (std::size_t c = 0; c < images.size(); ++c)
  {
    for (Id p = 0; p < count; ++p)
    {
      values[p * components + static_cast<Id>(c)] = images[c]->values[static_cast<std::size_t>(p)];
    }
  }
}

std::vector<SliceImage> Parted(vtkImageData* slice, Id width, Id height)
{
  const Id components = slice->GetNumberOfScalarComponents();
  const auto* values = static_cast<const float*>(slice->GetScalarPointer());
  std::vector<SliceImage> images(static_cast<std::size_t>(components), SliceImage(width, height));
  for (std::size_t c = 0; c < images.size(); ++c)
  {
    for (Id p = 0; p < width * height; ++p)
    {
      images[c].values[static_cast<std::size_t>(p)] = values[p * components + static_cast<Id>(c)];
    }
  }
  return images;
}

} // namespace

std::vector<SliceImage> SliceReslicing::Pull(const std::vector<const SliceImage*>& images,
                                             const SliceField& field) const
{
  vtkNew<vtkImageData> displacements;
  Interleave({ &field.dx, &field.dy }, 3, displacements);
  vtkNew<vtkGridTransform> transform;
  transform->SetDisplacementGridData(displacements);
  transform->SetInterpolationModeToLinear();
  transform->Update();

  vtkNew<vtkImageData> slice;
  Interleave(images, static_cast<int>(images.size()), slice);
  vtkNew<vtkImageReslice> reslice;
  reslice->SetInputData(slice);
  reslice->SetResliceTransform(transform);
  reslice->SetInterpolationModeToLinear();
  // However far outside, a place has the value of the nearest one inside.
  reslice->BorderOn();
  reslice->SetBorderThickness(1e9);
  reslice->SetNumberOfThreads(1);
  reslice->SetEnableSMP(false);
  reslice->Update();
  return Parted(reslice->GetOutput(), field.dx.width, field.dx.height);
}

} // namespace lamina
