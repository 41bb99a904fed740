// SPDX-License-Identifier: BSD-3-Clause
// What it costs to give a voxel another label: thin things may grow, not break.
#pragma once

#include "FirstLabels.h"
#include "LabelLattice.h"
#include "MaterialContacts.h"
#include "VoxelFaults.h"

namespace lamina
{

struct LabelChange
{
  LabelLattice::Place voxel{ { 0, 0, 0 } };
  int from = 0;
  int to = 0;
};

/// What a change costs beside its voxel.
struct RepairPrices
{
  double join = 0.6; ///< two bodies of the new label, apart over faces nearby, become one
  double cut = 0.6;  ///< the old label is parted over corners, or loses the tip of a strand
  /// The old label is nowhere three voxels thick around the voxel: what loses one there is nearer to a hole.
  double thin = 0.15;
  double bridge = 0.25; ///< the voxel joins one piece of the new label to itself: a tunnel under it
};

/// Prices at which walls and vessels of one voxel are thickened, not cut. Thin pieces and bridges only tell
/// changes apart that are as good otherwise: a wall is thickened by bridges, too.
constexpr RepairPrices CarefulPrices{ 4.5, 4.5, 0.15, 0.25 };

/// Prices changes by what they do to the image as it came, whatever the order in which they are made.
///
/// A wall or a vessel that steps diagonally is one piece over corners and many small ones over faces. Joining
/// such fragments costs nothing; joining what is large on both sides opens a wall.
class RepairCost
{
public:
  /// lattice: the image as it is now; original: as it came.
  RepairCost(const LabelLattice& lattice, const FirstLabels& original, const MaterialContacts& known)
    : Lattice(lattice)
    , Original(original)
    , Known(known)
    , Harms(HarmsKept)
  {
  }

  /// 1, joins and cuts at their prices, and more where materials would meet that touch nowhere. The voxel
  /// still has its old label.
  double Of(const LabelChange& change, const RepairPrices& prices)
  {
    return this->Of(change, { this->Lattice.Around(change.voxel), this->Lattice.Faults() }, prices);
  }
  /// The same, with what stands around the voxel now.
  double Of(const LabelChange& change, const VoxelFaults& around, const RepairPrices& prices);

private:
  /// Neighbouring changes are priced again and again, distant ones never.
  static constexpr std::size_t HarmsKept = 1 << 14;
  /// In the original: 0 to 1, how much a change joins; whether it cuts, or takes from what is thin.
  struct Harm
  {
    Id key = -1; ///< of voxel and new label
    float joins = 0;
    bool cuts = false;
    bool bridges = false; ///< joins one piece to itself
    bool thins = false;   ///< takes from what is thin
  };
  const Harm& HarmOf(const LabelChange& change);

  const LabelLattice& Lattice;
  const FirstLabels& Original;
  const MaterialContacts& Known;
  std::vector<Harm> Harms; ///< each in the one slot of its key
};

} // namespace lamina
