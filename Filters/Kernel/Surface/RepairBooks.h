// SPDX-License-Identifier: BSD-3-Clause
// What the repair of the labels took from materials and gave to others, booked where the surface can return
// it.
#pragma once

#include "../Mesh/LabelImage.h"

#include <functional>

namespace lamina
{

/// A voxel face at the surface, and the material that has a claim there.
struct RepairClaim
{
  std::array<Id, 3> corner; ///< the lattice point of the face's lower corner
  int axis = 0;
  int material = 0;
  double voxels = 0; ///< that the material lacks, below 0: has too many
};

struct RepairBooks
{
  std::vector<RepairClaim> claims;
  Id lostVoxels = 0; ///< of pieces that the repair removed whole: no surface is left that could return them
};

/// Every voxel of `changed` (ascending) is one too few for the label it had in `first` and one too many for
/// the one it has in `now`; the background is a label like others. Each is booked on the nearest faces of the
/// piece it belonged or belongs to, in steps over voxels of the same fate.
RepairBooks BookRepair(const LabelImage& first, const LabelImage& now, const std::vector<Id>& changed);

} // namespace lamina
