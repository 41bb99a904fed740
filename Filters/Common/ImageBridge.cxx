// SPDX-License-Identifier: BSD-3-Clause
#include "ImageBridge.h"

#include "Arrays.h"
#include "MeshArrayNames.h"

#include "Base/Text.h"

#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace lamina
{

namespace
{

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

/// A second image is read voxel by voxel: that makes sense only if its voxels lie where the first one's do.
Status CheckSameGrid(const GridGeometry& mask, const GridGeometry& image, const std::string& what)
{
  if (mask.size != image.size)
  {
    return InvalidInput("the " + what + " has " + SizeText(mask.size) + " voxels, the image " +
                        SizeText(image.size) + ": they must agree");
  }
  for (int corner = 0; corner < 8; ++corner)
  {
    const double at[3] = { corner & 1 ? image.size[0] - 1.0 : 0, corner & 2 ? image.size[1] - 1.0 : 0,
                           corner & 4 ? image.size[2] - 1.0 : 0 };
    const Vec3 here = image.ToWorld(at[0], at[1], at[2]);
    const Vec3 there = mask.ToWorld(at[0], at[1], at[2]);
    if (Norm(here - there) > 0.5 * std::min({ image.spacing.x, image.spacing.y, image.spacing.z }))
    {
      return InvalidInput("the " + what +
                          " lies elsewhere in the world than the image: a corner voxel is at " +
                          ToString(there) + " instead of " + ToString(here) +
                          "; give it the image's origin, spacing and direction, or resample it");
    }
  }
  return Done{};
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

Result<GreyView> ViewGrey(vtkImageData* image, vtkDataArray* scalars)
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
  vtkSmartPointer<vtkDataArray> array = scalars;
  if (!scalars->HasStandardMemoryLayout() || scalars->GetDataType() == VTK_BIT)
  {
    // Values that are not laid out one after the other have to be copied after all.
    const int type = scalars->GetDataType() == VTK_BIT ? VTK_UNSIGNED_CHAR : scalars->GetDataType();
    array.TakeReference(vtkDataArray::CreateDataArray(type));
    array->DeepCopy(scalars);
  }
  const auto keep = std::make_shared<vtkSmartPointer<vtkDataArray>>(array);
  const void* values = array->GetVoidPointer(0);
  switch (array->GetDataType())
  {
    vtkTemplateMacro(return GreyView(*grid, static_cast<const VTK_TT*>(values), grid->Count(), keep));
  }
  return InvalidInput(std::string("the image's values are of a type without numbers: ") +
                      array->GetDataTypeAsString());
}

Result<GreyImage> ReadGrey(vtkImageData* image, vtkDataArray* scalars)
{
  const Result<GreyView> view = ViewGrey(image, scalars);
  if (!view)
  {
    return view.GetError();
  }
  GreyImage grey{ view->grid, std::vector<double>(static_cast<std::size_t>(view->Count())) };
  view->Read(0, view->Count(), grey.values.data());
  return grey;
}

Result<GreyView> ViewGreyBeside(vtkImageData* image, const GridGeometry& labels)
{
  const Result<vtkDataArray*> scalars = FindScalars(image, names::Intensity, nullptr);
  if (!scalars)
  {
    return InvalidInput("grey image: " + scalars.GetError().message);
  }
  Result<GreyView> grey = ViewGrey(image, *scalars);
  if (!grey)
  {
    return InvalidInput("grey image: " + grey.GetError().message);
  }
  if (const Status same = CheckSameGrid(grey->grid, labels, "grey image"); !same)
  {
    return same.GetError();
  }
  return grey;
}

Result<RegionMask> ReadRegion(vtkImageData* mask, const GridGeometry& image)
{
  const Result<GridGeometry> grid = ReadGeometry(mask);
  if (!grid)
  {
    return InvalidInput("mask: " + grid.GetError().message);
  }
  if (const Status same = CheckSameGrid(*grid, image, "mask"); !same)
  {
    return same.GetError();
  }
  const Result<vtkDataArray*> scalars = FindScalars(mask, nullptr, nullptr);
  if (!scalars)
  {
    return InvalidInput("mask: " + scalars.GetError().message);
  }
  const Result<GreyView> values = ViewGrey(mask, *scalars);
  if (!values)
  {
    return InvalidInput("mask: " + values.GetError().message);
  }
  RegionMask region{ image, std::vector<unsigned char>(static_cast<std::size_t>(image.Count())) };
  std::vector<double> row(static_cast<std::size_t>(image.size[0]));
  for (Id first = 0; first < image.Count(); first += image.size[0])
  {
    values->Read(first, first + image.size[0], row.data());
    std::transform(row.begin(), row.end(), region.inside.begin() + first,
                   [](double value) { return static_cast<unsigned char>(value == 1); });
  }
  return region;
}

Result<LabelImage> ReadMask(vtkImageData* mask, const GridGeometry& image)
{
  const Result<RegionMask> region = ReadRegion(mask, image);
  if (!region)
  {
    return region.GetError();
  }
  return LabelImage{ image, { region->inside.begin(), region->inside.end() } };
}

void WriteGeometry(const GridGeometry& grid, vtkImageData* image)
{
  image->SetDimensions(static_cast<int>(grid.size[0]), static_cast<int>(grid.size[1]),
                       static_cast<int>(grid.size[2]));
  image->SetOrigin(grid.origin.x, grid.origin.y, grid.origin.z);
  image->SetSpacing(grid.spacing.x, grid.spacing.y, grid.spacing.z);
  image->SetDirectionMatrix(grid.direction.data());
}

void WriteLabels(const LabelImage& labels, vtkImageData* image)
{
  // SetScalars would throw out the array that is active so far.
  image->GetPointData()->AddArray(MakeArray<vtkIntArray>(names::MaterialIds, labels.labels));
  image->GetPointData()->SetActiveScalars(names::MaterialIds);
  AttachMaterialList(image, DistinctValues(labels.labels));
}

} // namespace lamina
