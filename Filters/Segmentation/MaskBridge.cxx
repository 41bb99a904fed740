// SPDX-License-Identifier: BSD-3-Clause
#include "MaskBridge.h"

#include "Arrays.h"
#include "ImageBridge.h"
#include "MeshArrayNames.h"

#include "Base/Text.h"

#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkUnsignedShortArray.h"

#include <algorithm>
#include <cmath>

namespace lamina
{

namespace
{

constexpr int LargestRegion = 65535;
constexpr double PlaceTolerance = 0.1; ///< voxels that the corners of the two grids may lie apart

Vec3 Corner(const GridGeometry& grid, int corner)
{
  const auto end = [&](int axis)
  {
    const Id last = grid.size[static_cast<std::size_t>(axis)] - 1;
    return (corner >> axis) & 1 ? static_cast<double>(last) : 0.0;
  };
  return grid.ToWorld(end(0), end(1), end(2));
}

Status CheckPlace(const GridGeometry& mask, const GridGeometry& image)
{
  if (mask.size != image.size)
  {
    return InvalidInput("the mask has " + SizeText(mask.size) + " voxels, the image " + SizeText(image.size) +
                        ": they must agree; resample the mask to the image");
  }
  const double least = std::min({ image.spacing.x, image.spacing.y, image.spacing.z });
  for (int c = 0; c < 8; ++c)
  {
    const Vec3 a = Corner(mask, c);
    const Vec3 b = Corner(image, c);
    if (!(Norm(a - b) <= PlaceTolerance * least))
    {
      return InvalidInput("the mask does not stand where the image does: a corner of its grid is at " +
                          ToString(a) + ", that of the image at " + ToString(b) +
                          "; give both the same origin, spacing and direction, or resample the mask");
    }
  }
  return Done{};
}

} // namespace

Result<LabelImage> ReadRegions(vtkImageData* mask, const GridGeometry& image)
{
  const Result<GridGeometry> grid = ReadGeometry(mask);
  if (!grid)
  {
    return InvalidInput("mask: " + grid.GetError().message);
  }
  if (const Status status = CheckPlace(*grid, image); !status)
  {
    return status.GetError();
  }
  const Result<vtkDataArray*> scalars = FindScalars(mask, nullptr, nullptr);
  if (!scalars)
  {
    return InvalidInput("mask: " + scalars.GetError().message);
  }
  vtkDataArray* values = *scalars;
  if (values->GetNumberOfComponents() != 1 || values->GetNumberOfTuples() != image.Count())
  {
    return InvalidInput("the mask has " + std::to_string(values->GetNumberOfTuples()) + " values of " +
                        std::to_string(values->GetNumberOfComponents()) +
                        " components: one value for each of " + std::to_string(image.Count()) +
                        " voxels is needed");
  }
  LabelImage regions{ image, std::vector<int>(static_cast<std::size_t>(image.Count())) };
  for (Id v = 0; v < image.Count(); ++v)
  {
    const double value = values->GetComponent(v, 0);
    if (std::isnan(value))
    {
      continue;
    }
    if (!(value >= 0 && value <= LargestRegion) || value != std::floor(value))
    {
      const Id i = v % image.size[0];
      const Id j = v / image.size[0] % image.size[1];
      const Id k = v / (image.size[0] * image.size[1]);
      return InvalidInput(
        "the mask has the value " + std::to_string(value) +
          ", but it must be 0 outside and a whole number up to 65535 inside (is this the grey "
          "image?); this voxel is",
        { image.ToWorld(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)) });
    }
    regions.labels[static_cast<std::size_t>(v)] = static_cast<int>(value);
  }
  return regions;
}

void WriteRegions(const LabelImage& regions, vtkImageData* image)
{
  const std::vector<unsigned short> values(regions.labels.begin(), regions.labels.end());
  // SetScalars would throw out the array that is active so far.
  image->GetPointData()->AddArray(MakeArray<vtkUnsignedShortArray>(names::Mask, values));
  image->GetPointData()->SetActiveScalars(names::Mask);
}

} // namespace lamina
