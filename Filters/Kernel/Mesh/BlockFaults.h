// SPDX-License-Identifier: BSD-3-Clause
// What can be wrong in a block of 2x2x2 voxels: contacts over an edge or a corner only, and forbidden
// neighbours.
#pragma once

#include "../Base/Types.h"

#include <array>
#include <vector>

namespace lamina
{

/// Two materials that may not meet over a face, an edge or a corner.
using ForbiddenPair = std::array<int, 2>;

/// The labels of 2x2x2 voxels, bit 0 of the index along i, bit 1 along j, bit 2 along k.
struct Block
{
  std::array<int, 8> labels{};
  unsigned exempt = 0; ///< bits of the voxels whose contacts are never forbidden

  bool IsUniform() const;
};

struct BlockFaults
{
  int edges = 0;    ///< lattice edges across which only a material touches itself
  int corners = 0;  ///< 1 if it does so across the block's centre
  int contacts = 0; ///< voxels, at least, that must change before no forbidden neighbours are left

  int All() const { return this->edges + this->corners + this->contacts; }
};

/// True if the four voxels around a lattice edge, in cyclic order, have a material that touches itself only
/// across the edge (Latecki's critical configuration C1, tested for every label and its complement).
bool IsCriticalEdge(int p0, int p1, int p2, int p3);

/// Finds the faults of blocks under a set of forbidden pairs.
class FaultRules
{
public:
  explicit FaultRules(const std::vector<ForbiddenPair>& forbidden);

  BlockFaults Find(const Block& block) const;
  bool MayNotTouch(int a, int b) const;
  bool HasForbidden() const { return !this->Forbidden.empty(); }
  /// For a material that holds this set of a block's voxels: bits 0 to 5 the lattice edges, bit 6 the corner
  /// across which alone it or its complement touches itself.
  unsigned CriticalOf(unsigned set) const { return this->Critical[set]; }

private:
  int CountContacts(const Block& block) const;

  std::array<unsigned char, 256>
    Critical; ///< by set of voxels: bits 0 to 5 its critical edges, bit 6 the corner
  std::vector<ForbiddenPair> Forbidden;     ///< each with the smaller id first, ascending
  std::array<unsigned long long, 64> Low{}; ///< for ids below 64: a bit for each that may not touch
};

} // namespace lamina
