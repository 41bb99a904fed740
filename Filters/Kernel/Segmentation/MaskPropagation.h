// SPDX-License-Identifier: BSD-3-Clause
// A region of interest drawn on a few slices, carried to all.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "../Mesh/LabelImage.h"

#include <string>
#include <vector>

namespace lamina
{

class SliceWarper;

struct MaskPropagationOptions
{
  /// Across which axis the mask was drawn: 0 i, 1 j, 2 k, 3 the one along which drawn slices are sparse.
  int axis = 3;
  /// Slices that were drawn; also empty ones. None: all with a voxel of the mask.
  std::vector<Id> drawnSlices;
  /// The number of the first slice across i, j, k: in the list above, the report and messages.
  std::array<Id, 3> firstSlice{ { 0, 0, 0 } };
  /// The value that is the mask; 0: every value but 0 is a region of its own.
  int maskValue = 0;
  /// How many slices beyond the first and the last drawn one the mask is carried, at least 0. -1: the mask
  /// ends before the slice that would have been drawn next, at the same distance as the last two; from a
  /// single drawn slice it is carried to all.
  Id maximumSlices = -1;
  /// 0: the best of the following, judged by how well each foretells drawn slices from their neighbours;
  /// 1: shape interpolation; 2: registration; 3: registration, corrected by grey values.
  int method = 0;
  int levels = 4;          ///< of the registration's pyramid, 1..8
  double smoothness = 1.5; ///< of the displacements: their reach in pixels of each level, 0.5..20
  double searchRange = 16; ///< greatest displacement from slice to slice, in pixels, > 0
  /// What carries masks and grey values along displacements (SliceImage.h); null: the kernel's own.
  const SliceWarper* warper = nullptr;
};

/// A slice that was not drawn.
struct PropagatedSlice
{
  Id slice = 0;
  Id from = 0; ///< drawn slices it comes from, below and above; the same beyond the first and the last
  Id to = 0;
  Id voxels = 0;
  double residual = 0; ///< mean absolute grey difference from what was carried there, around the mask
};

struct MaskPropagationReport
{
  int axis = 2;
  std::vector<Id> drawn;
  std::vector<int> ids; ///< the regions
  int method = 1;       ///< that was used, 1 to 3
  /// Dice coefficients of drawn slices with what each method makes of their neighbours; NaN: not measured.
  std::array<double, 3> foretold{};
  double residual = 0;             ///< mean of the slices'
  double unregisteredResidual = 0; ///< the same without displacements; NaN: not measured
  double noise = 0;                ///< of the grey values around the mask
  std::vector<PropagatedSlice> slices;
  std::vector<std::string> warnings;
};

/// Carry the regions drawn on some slices of `mask` to all slices; `full` has the grey image's grid. Drawn
/// slices stay as they are. Adjacent slices are registered elastically, the displacements between them
/// chained, and from both sides the signed distances of the drawn regions carried along and blended by
/// nearness. The same for any number of threads.
///
/// Failures: sizes that differ, no drawn slice, drawn slices outside the image, options out of range.
Result<MaskPropagationReport> PropagateMask(const GreyImage& grey, const LabelImage& mask, LabelImage& full,
                                            const MaskPropagationOptions& options, Monitor& monitor);

} // namespace lamina
