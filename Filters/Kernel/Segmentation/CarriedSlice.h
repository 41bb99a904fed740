// SPDX-License-Identifier: BSD-3-Clause
// The regions of one slice from those of drawn slices, carried to it.
#pragma once

#include "SliceStack.h"

namespace lamina
{

/// How regions come to a slice that was not drawn, from the simplest on.
enum class CarryMethod
{
  Shape = 0,        ///< signed distances of the drawn slices, blended in place
  Registration = 1, ///< the same, along the displacements of the registration
  GreyValues = 2    ///< the same, and the border corrected by patches of like grey values
};

/// A drawn slice as seen from the slice it is carried to.
struct CarriedSource
{
  const DrawnSlice* drawn = nullptr;
  const SliceImage* grey = nullptr;  ///< of the drawn slice
  const SliceField* field = nullptr; ///< from the target to the drawn slice; null for CarryMethod::Shape
  float weight = 1;                  ///< all sources' weights sum to 1
  /// The slice on the other side, which says how fast a region shrinks that is absent from this one: as if
  /// this were as far outside everywhere as that is inside. Null if there is none.
  const DrawnSlice* other = nullptr;
};

struct CarriedSlice
{
  std::vector<int> labels;
  double residual = 0; ///< mean absolute difference of grey values around the regions, contrast 1
};

/// The regions `ids` on the slice with grey values `grey` (null for CarryMethod::Shape). Where regions meet
/// the one whose border is farther takes the pixel, at a tie the one of lesser id.
///
/// GreyValues: a pixel near the border looks at the carried slices within three pixels of itself, and takes
/// the side of the border that the patches (3 x 3 pixels) like its own lie on (PatchVotes.h). Where no side
/// is likelier the blended distance decides.
CarriedSlice CarryToSlice(const SliceGrid& grid, const SliceImage* grey, double noise,
                          const std::vector<CarriedSource>& sources, const std::vector<int>& ids,
                          CarryMethod method, const SliceWarper& warper);

} // namespace lamina
