// SPDX-License-Identifier: BSD-3-Clause
// The border of a carried region, corrected by patches of like grey values.
#pragma once

#include "SliceStack.h"

#include <vector>

namespace lamina
{

/// A drawn slice carried to another: its grey values and signed distances on the other's pixels.
struct Carried
{
  SliceImage grey;
  std::vector<SliceImage> distances;
  float weight = 1;
};

/// Correct the blended signed distances of the regions on a slice with grey values `target`: wherever the
/// carried slices do not all put a pixel far to the same side of the border, patches vote, and `blended`
/// becomes positive inside and negative outside, in no unit. Non-local label fusion after P. Coupe, J. V.
/// Manjon, V. Fonov, J. Pruessner, M. Robles and D. L. Collins, Patch-based segmentation using expert priors,
/// NeuroImage 54 (2011).
void CorrectByPatches(const SliceGrid& grid, const SliceImage& target, double noise,
                      const std::vector<Carried>& carried, std::vector<SliceImage>& blended);

} // namespace lamina
