// SPDX-License-Identifier: BSD-3-Clause
// How many pieces, tunnels and cavities each material has.
#pragma once

#include "../Base/Monitor.h"
#include "../Mesh/LabelImage.h"

namespace lamina
{

/// Betti numbers of one material: voxels connected over faces, the rest over corners.
struct BettiNumbers
{
  int material = 0;
  Id voxels = 0;
  Id b0 = 0; ///< pieces
  Id b1 = 0; ///< tunnels: independent loops
  Id b2 = 0; ///< cavities: pieces of the rest that the material encloses
};

/// Betti numbers of every material present, background always, ascending by material. The image is surrounded
/// by background, whose counts include that surrounding: its cavities are the bodies in it. b1 follows from
/// the Euler number, counted as voxels less pairs over faces plus full 2x2x1 squares less full 2x2x2 blocks.
/// Empty if the monitor asked to stop.
std::vector<BettiNumbers> CountBettiNumbers(const LabelImage& image, Monitor& monitor);

} // namespace lamina
