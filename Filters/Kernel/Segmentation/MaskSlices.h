// SPDX-License-Identifier: BSD-3-Clause
// What was drawn: the axis, the slices and the regions of a mask, and the gaps between its drawn slices.
#pragma once

#include "MaskPropagation.h"
#include "SliceStack.h"

namespace lamina
{

/// The regions that count, ascending; a failure if there are none or too many.
Result<std::vector<int>> FindRegions(const LabelImage& mask, int maskValue, Monitor& monitor);

/// Across i, j, k: for each slice, 1 if it has a voxel of the regions.
using SliceFlags = std::array<std::vector<char>, 3>;
SliceFlags FindSlices(const LabelImage& mask, const std::vector<int>& ids, Monitor& monitor);

/// The axis across which the mask was drawn: that with the greatest share of slices left out between the
/// first and the last drawn one; if none was left out, that with far fewer drawn slices than the others; else
/// k.
int FindDrawnAxis(const SliceFlags& flags);

/// The slices that are flagged, or those listed, ascending from 0; a failure if no flagged one is listed.
/// `first`: the number of the first slice in `listed`.
Result<std::vector<Id>> FindDrawnSlices(const SliceFlags& flags, int axis, const std::vector<Id>& listed,
                                        Id first);

/// Slices [first, last] that were not drawn, and the drawn ones (indices) before and after; -1 if none.
struct MaskGap
{
  Id first = 0;
  Id last = 0;
  Id low = -1;
  Id high = -1;

  /// With the drawn slices on both sides.
  Id Begin() const { return this->low >= 0 ? this->first - 1 : this->first; }
  Id End() const { return this->high >= 0 ? this->last + 1 : this->last; }
};

/// The gaps to fill, ascending; slices taken for empty at both ends are put into `drawn`.
std::vector<MaskGap> FindGaps(const SliceGrid& grid, const std::vector<int>& ids, Id maximumSlices,
                              std::vector<DrawnSlice>& drawn);

} // namespace lamina
