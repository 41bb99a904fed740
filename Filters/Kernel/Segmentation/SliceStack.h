// SPDX-License-Identifier: BSD-3-Clause
// A grey image as a stack of slices along one of its axes, and a mask as regions drawn on some of them.
#pragma once

#include "../Base/Monitor.h"
#include "../Mesh/LabelImage.h"
#include "SliceImage.h"

#include <vector>

namespace lamina
{

/// The slices of a grid across one axis: x and y of a slice are the grid's other axes, in ascending order.
struct SliceGrid
{
  std::array<Id, 3> size{ { 0, 0, 0 } };
  int axis = 2;
  Id width = 0;
  Id height = 0;
  Id slices = 0;
  PixelShape shape;

  SliceGrid() = default;
  SliceGrid(const GridGeometry& grid, int axis);
  Id Voxel(Id slice, Id x, Id y) const;
};

/// What was drawn on one slice.
struct DrawnSlice
{
  Id slice = 0;
  bool assumed = false; ///< not drawn, but taken for empty
  bool empty = true;
  std::vector<int> labels;
  /// Signed distances: of all regions together, then, if there are several, of each in the order of the ids.
  std::vector<SliceImage> distances;
  std::vector<Id> smallest;  ///< pixels of the smallest parts, see SmallestParts()
  std::vector<float> depths; ///< for each, the greatest distance inside, in pixels; 0 where it is absent
};

/// Read slice `slice` of a mask; `ids` are the regions looked for.
DrawnSlice ReadDrawnSlice(const SliceGrid& grid, const LabelImage& mask, const std::vector<int>& ids,
                          Id slice);
/// A slice taken for empty.
DrawnSlice EmptySlice(const SliceGrid& grid, const std::vector<int>& ids, Id slice);

/// Grey values from 0 to 1, a slice each: what lies in and around the drawn regions decides which grey values
/// are 0 and 1, as contrast far away from them is of no use. NaN counts as the least.
struct SliceStack
{
  std::vector<SliceImage> slices;
  double low = 0;      ///< grey value of 0
  double high = 0;     ///< of 1; equal to low where the image is constant around the regions
  double noise = 0.01; ///< standard deviation of the noise there, in these units; at least 0.01

  bool IsConstant() const { return !(this->high > this->low); }
};

/// The slices [from, to) are filled, the others stay empty.
SliceStack ReadSliceStack(const SliceGrid& grid, const GreyImage& grey, const std::vector<DrawnSlice>& drawn,
                          Id from, Id to, Monitor& monitor);

} // namespace lamina
