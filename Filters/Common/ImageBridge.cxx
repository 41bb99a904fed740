// SPDX-License-Identifier: BSD-3-Clause
#include "ImageBridge.h"

#include "Arrays.h"
#include "MeshArrayNames.h"

#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <cmath>

namespace lamina
{

namespace
{

constexpr int LargestMaterial = 65535;

std::string SizeText(const std::array<Id, 3>& size)
{
  return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]);
}

bool IsOrthonormal(const std::array<double, 9>& m)
{
  constexpr double tolerance = 1e-4;
  for (std::size_t a = 0; a < 3; ++a)
  {
    for (std::size_t b = a; b < 3; ++b)
    {
      const double dot = m[a] * m[b] + m[3 + a] * m[3 + b] + m[6 + a] * m[6 + b];
      if (!(std::abs(dot - (a == b ? 1 : 0)) < tolerance))
      {
        return false;
      }
    }
  }
  return true;
}

std::string ArrayList(vtkPointData* points)
{
  std::string text;
  for (int a = 0; a < points->GetNumberOfArrays(); ++a)
  {
    const char* name = points->GetArrayName(a);
    text += (a == 0 ? "" : ", ") + std::string(name ? name : "(no name)");
  }
  return text;
}

/// Where voxel v is, for messages.
Error BadVoxel(const GridGeometry& grid, Id v, const std::string& message)
{
  const Id i = v % grid.size[0];
  const Id j = v / grid.size[0] % grid.size[1];
  const Id k = v / (grid.size[0] * grid.size[1]);
  return InvalidInput(
    message, { grid.ToWorld(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)) });
}

Status CheckScalars(const GridGeometry& grid, vtkDataArray* scalars)
{
  const std::string name = scalars->GetName() ? scalars->GetName() : "the image's array";
  if (scalars->GetNumberOfComponents() != 1)
  {
    return InvalidInput(name + " has " + std::to_string(scalars->GetNumberOfComponents()) +
                        " components: an image of one component is needed");
  }
  if (scalars->GetNumberOfTuples() != grid.Count())
  {
    return InvalidInput(name + " has " + std::to_string(scalars->GetNumberOfTuples()) + " values for " +
                        std::to_string(grid.Count()) + " voxels");
  }
  return Done{};
}

} // namespace

Result<GridGeometry> ReadGeometry(vtkImageData* image)
{
  GridGeometry grid;
  int extent[6];
  image->GetExtent(extent);
  for (int a = 0; a < 3; ++a)
  {
    grid.size[static_cast<std::size_t>(a)] = static_cast<Id>(extent[2 * a + 1]) - extent[2 * a] + 1;
    grid.spacing[a] = image->GetSpacing()[a];
  }
  image->TransformContinuousIndexToPhysicalPoint(extent[0], extent[2], extent[4], &grid.origin.x);
  const double* direction = image->GetDirectionMatrix()->GetData();
  std::copy(direction, direction + 9, grid.direction.begin());
  for (int a = 0; a < 3; ++a)
  {
    if (grid.size[static_cast<std::size_t>(a)] < 2)
    {
      return InvalidInput("the image has " + SizeText(grid.size) + " voxels: a 3-D image is needed");
    }
    if (!(grid.spacing[a] > 0) || !std::isfinite(grid.spacing[a]))
    {
      return InvalidInput("the image's spacing " + ToString(grid.spacing) + " must be positive");
    }
  }
  if (!IsFinite(grid.origin) || !IsOrthonormal(grid.direction))
  {
    return InvalidInput(
      "the image's axes are skewed or its origin is not finite: resample it to a rectangular grid");
  }
  return grid;
}

Result<vtkDataArray*> FindScalars(vtkImageData* image, const char* name, const char* filter)
{
  vtkPointData* points = image->GetPointData();
  if (vtkDataArray* array = name ? points->GetArray(name) : nullptr)
  {
    return array;
  }
  const std::string advice =
    filter && name ? std::string(": run ") + filter + " first, which makes " + name : std::string();
  if (points->GetNumberOfArrays() == 1 && points->GetArray(0))
  {
    return points->GetArray(0);
  }
  if (points->GetNumberOfArrays() == 0)
  {
    return InvalidInput("the image has no array on its points" + advice);
  }
  if (!name && points->GetScalars())
  {
    return points->GetScalars();
  }
  return InvalidInput("the image has several arrays (" + ArrayList(points) + ") and none is named " +
                      (name ? name : "as scalars") + advice);
}

Result<LabelImage> ReadLabels(vtkImageData* image, vtkDataArray* scalars)
{
  const Result<GridGeometry> grid = ReadGeometry(image);
  if (!grid)
  {
    return grid.GetError();
  }
  if (const Status status = CheckScalars(*grid, scalars); !status)
  {
    return status.GetError();
  }
  LabelImage labels{ *grid, std::vector<int>(static_cast<std::size_t>(grid->Count())) };
  for (Id v = 0; v < grid->Count(); ++v)
  {
    const double value = scalars->GetComponent(v, 0);
    if (!(value >= 0 && value <= LargestMaterial) || value != std::floor(value))
    {
      return BadVoxel(*grid, v,
                      std::string(scalars->GetName() ? scalars->GetName() : "the array") + " has the value " +
                        std::to_string(value) +
                        ", but material ids are whole numbers from 0 to 65535: run Multimaterial "
                        "Segmentation on a grey image first; this voxel is");
    }
    labels.labels[static_cast<std::size_t>(v)] = static_cast<int>(value);
  }
  return labels;
}

Result<GreyImage> ReadGrey(vtkImageData* image, vtkDataArray* scalars)
{
  const Result<GridGeometry> grid = ReadGeometry(image);
  if (!grid)
  {
    return grid.GetError();
  }
  if (const Status status = CheckScalars(*grid, scalars); !status)
  {
    return status.GetError();
  }
  GreyImage grey{ *grid, std::vector<double>(static_cast<std::size_t>(grid->Count())) };
  for (Id v = 0; v < grid->Count(); ++v)
  {
    grey.values[static_cast<std::size_t>(v)] = scalars->GetComponent(v, 0);
  }
  return grey;
}

Result<LabelImage> ReadMask(vtkImageData* mask, const GridGeometry& image)
{
  const Result<GridGeometry> grid = ReadGeometry(mask);
  if (!grid)
  {
    return InvalidInput("mask: " + grid.GetError().message);
  }
  if (grid->size != image.size)
  {
    return InvalidInput("the mask has " + SizeText(grid->size) + " voxels, the image " +
                        SizeText(image.size) + ": they must agree");
  }
  const Result<vtkDataArray*> scalars = FindScalars(mask, nullptr, nullptr);
  if (!scalars)
  {
    return InvalidInput("mask: " + scalars.GetError().message);
  }
  if (const Status status = CheckScalars(*grid, *scalars); !status)
  {
    return InvalidInput("mask: " + status.GetError().message);
  }
  LabelImage result{ image, std::vector<int>(static_cast<std::size_t>(image.Count())) };
  for (Id v = 0; v < image.Count(); ++v)
  {
    result.labels[static_cast<std::size_t>(v)] = (*scalars)->GetComponent(v, 0) == 1 ? 1 : 0;
  }
  return result;
}

void WriteGeometry(const GridGeometry& grid, vtkImageData* image)
{
  image->SetDimensions(static_cast<int>(grid.size[0]), static_cast<int>(grid.size[1]),
                       static_cast<int>(grid.size[2]));
  image->SetOrigin(grid.origin.x, grid.origin.y, grid.origin.z);
  image->SetSpacing(grid.spacing.x, grid.spacing.y, grid.spacing.z);
  image->SetDirectionMatrix(grid.direction.data());
}

void WriteInformation(const GridGeometry& grid, vtkInformation* information)
{
  const int extent[6] = { 0, static_cast<int>(grid.size[0]) - 1, 0, static_cast<int>(grid.size[1]) - 1,
                          0, static_cast<int>(grid.size[2]) - 1 };
  information->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  information->Set(vtkDataObject::ORIGIN(), &grid.origin.x, 3);
  information->Set(vtkDataObject::SPACING(), &grid.spacing.x, 3);
  information->Set(vtkDataObject::DIRECTION(), grid.direction.data(), 9);
}

void WriteLabels(const LabelImage& labels, vtkImageData* image)
{
  // SetScalars would throw out the array that is active so far.
  image->GetPointData()->AddArray(MakeArray<vtkIntArray>(names::MaterialIds, labels.labels));
  image->GetPointData()->SetActiveScalars(names::MaterialIds);
}

} // namespace lamina
