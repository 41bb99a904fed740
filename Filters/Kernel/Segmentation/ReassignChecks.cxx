// SPDX-License-Identifier: BSD-3-Clause
#include "Reassign.h"

#include "../Base/Text.h"

#include <algorithm>
#include <cmath>

namespace lamina
{

namespace
{

bool IsMaterial(int id)
{
  return id >= 0 && id <= LargestMaterial;
}

Result<bool> CheckShape(const VoxelEdit& edit)
{
  if (edit.shape == EditShape::Box)
  {
    if (!IsFinite(edit.low) || !IsFinite(edit.high))
    {
      return InvalidOption(edit.name + ": the box has a bound that is not a finite number");
    }
    for (int a = 0; a < 3; ++a)
    {
      if (!(edit.low[a] < edit.high[a]))
      {
        return InvalidOption(Text(edit.name, ": the box is empty, along ", "xyz"[a], " it runs from ",
                                  edit.low[a], " to ", edit.high[a], ": give the lower bound first"));
      }
    }
  }
  if (edit.shape == EditShape::Sphere &&
      !(IsFinite(edit.centre) && edit.radius > 0 && std::isfinite(edit.radius)))
  {
    return InvalidOption(Text(edit.name, ": the sphere about ", ToString(edit.centre), " has the radius ",
                              edit.radius, ": a finite centre and a radius above 0 are needed"));
  }
  return true;
}

Result<bool> CheckVoxels(const VoxelEdit& edit, const GridGeometry& grid)
{
  if (edit.shape != EditShape::Voxels)
  {
    return true;
  }
  if (edit.size != std::array<Id, 3>{ { 0, 0, 0 } } && edit.size != grid.size)
  {
    return InvalidInput(Text(edit.name, ": its voxels were picked in an image of ", SizeText(edit.size),
                             " voxels, this one has ", SizeText(grid.size),
                             ": use the image that the edits were made on, or pick the voxels anew"));
  }
  const Id count = grid.Count();
  const auto outside = [count](Id v) { return v < 0 || v >= count; };
  const auto bad = std::count_if(edit.voxels.begin(), edit.voxels.end(), outside);
  if (bad > 0)
  {
    return InvalidInput(Text(
      edit.name, ": ", bad, " of ", edit.voxels.size(), " voxel ids are outside the image (the first is ",
      *std::find_if(edit.voxels.begin(), edit.voxels.end(), outside), "), whose ids run from 0 to ",
      count - 1, ": select points of the image itself"));
  }
  return true;
}

Result<bool> CheckEdit(const VoxelEdit& edit, const GridGeometry& grid)
{
  if (!IsMaterial(edit.to))
  {
    return InvalidOption(Text(edit.name, ": the material to give is ", edit.to,
                              ", material ids run from 0 to ", LargestMaterial));
  }
  for (const int id : edit.from)
  {
    if (!IsMaterial(id))
    {
      return InvalidOption(Text(edit.name, ": it is restricted to material ", id,
                                ", material ids run from 0 to ", LargestMaterial));
    }
  }
  const Result<bool> good = CheckShape(edit);
  return good ? CheckVoxels(edit, grid) : good;
}

} // namespace

Result<bool> CheckEdits(const GridGeometry& grid, const ReassignOptions& options)
{
  for (const VoxelEdit& edit : options.edits)
  {
    if (Result<bool> good = CheckEdit(edit, grid); !good)
    {
      return good;
    }
  }
  for (const auto& pair : options.forbidden)
  {
    if (!IsMaterial(pair[0]) || !IsMaterial(pair[1]) || pair[0] == pair[1])
    {
      return InvalidOption(Text("the forbidden contact of materials ", pair[0], " and ", pair[1],
                                " must name two different ids from 0 to ", LargestMaterial));
    }
  }
  return true;
}

} // namespace lamina
