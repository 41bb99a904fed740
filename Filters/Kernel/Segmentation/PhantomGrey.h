// SPDX-License-Identifier: BSD-3-Clause
// What a scanner would make of the phantom: partial volume, blur, bias field, noise.
#pragma once

#include "HeartPhantom.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lamina
{

/// How far each voxel's centre lies from the two surfaces, in hundredths of a voxel, at most one voxel.
struct PartialVolume
{
  explicit PartialVolume(Id voxels)
    : heart(voxels)
    , blood(voxels)
  {
  }
  static signed char Encode(double distance)
  {
    return static_cast<signed char>(std::lround(100 * std::min(1.0, std::max(-1.0, distance))));
  }
  std::vector<signed char> heart;
  std::vector<signed char> blood;
};

/// Make `grey` over the grid of `labels`. Returns false if the monitor asked to stop.
bool MakeGreyValues(const LabelImage& labels, const PartialVolume& partial,
                    const HeartPhantomOptions& options, GreyImage& grey, Monitor& monitor);

} // namespace lamina
