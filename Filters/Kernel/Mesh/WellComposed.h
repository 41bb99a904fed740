// SPDX-License-Identifier: BSD-3-Clause
// Label images between whose voxels a manifold surface can pass.
#pragma once

#include "../Base/Monitor.h"
#include "BlockFaults.h"
#include "LabelImage.h"

namespace lamina
{

struct RepairOptions
{
  /// Pairs that may not meet. Voxels outside the image count as background.
  std::vector<ForbiddenPair> forbidden;
  /// Whether forbidden materials may meet across the image's border, and across the edge of the frozen
  /// voxels.
  bool openAtImageBorder = false;
  bool openAtFrozen = false;
  /// One flag a voxel; where it is not 0 the label may not change. Null: all may.
  const std::vector<unsigned char>* frozen = nullptr;
};

struct RepairReport
{
  Id criticalEdges = 0;     ///< lattice edges across which only a material touched itself
  Id criticalCorners = 0;   ///< lattice points
  Id forbiddenContacts = 0; ///< lattice points around which forbidden neighbours stood
  Id remaining = 0;         ///< lattice points whose fault stays because of frozen voxels
  std::vector<Id> changed;  ///< voxels, ascending
};

/// Relabel as few voxels as the search can find until no 2x2x2 block is left in which a material, or its
/// complement, touches itself across an edge or a corner only (Latecki's well-composedness, for every label),
/// and none with forbidden neighbours.
///
/// Each place is searched for the cheapest set of changes that makes no new fault. A change costs more if it
/// joins bodies, cuts strands, bridges a piece to itself or takes from what is thin, so vessels and walls of
/// a voxel are thickened where they step diagonally, not cut. Dense noise is mended part by part, in time and
/// memory in proportion to the image. It ends for every input: a search only ever lowers the number of faulty
/// places or of faults, and where it finds nothing a voxel climbs in a fixed order of labels, whose last one
/// can fill the image without a fault. Each voxel takes part in at most four changes of searches, and so in
/// at most 5 (labels - 1) climbs. Where voxels are frozen there may be no way out: those places stay and are
/// counted.
RepairReport RepairTopology(LabelImage& image, const RepairOptions& options, Monitor& monitor);

/// The voxels of all blocks that RepairTopology would have to mend, ascending.
std::vector<Id> FindTopologyFaults(const LabelImage& image, const RepairOptions& options, Monitor& monitor);

} // namespace lamina
