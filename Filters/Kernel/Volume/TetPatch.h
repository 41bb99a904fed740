// SPDX-License-Identifier: BSD-3-Clause
// Small parts of a set of tetrahedra, to be taken out, changed and put back.
#pragma once

#include "ImproveTets.h"

namespace lamina
{

/// Puts a free point into the middle of a tet, edge or face (its points), which all tets that have it are
/// split at. False, and nothing is done, where that is on the boundary or between groups.
bool SplitPart(TetSet& set, const std::vector<Id>& part);

class TetPatches
{
public:
  explicit TetPatches(TetSet& set);

  /// The tets that some rings of neighbours reach from this one, and their points, numbered anew; those that
  /// others share are fixed. `own` gets the tet in the new numbers. False: some have been replaced since this
  /// object was made.
  bool Take(Id tet, int rings, TetSet& patch, std::array<Id, 4>& own);
  /// The tets that were taken last become those of the patch; its further points come to the set's end. Tets
  /// that go keep their place with -1 as first node.
  void PutBack(const TetSet& patch);

private:
  /// False if some have been replaced.
  bool Grow(Id tet, int rings);
  void Number();

  TetSet& Set;
  std::vector<std::size_t> Start; ///< of each point's tets
  std::vector<Id> Stars;
  std::vector<char> IsTaken; ///< one a tet
  std::vector<Id> Tets;      ///< taken last
  std::vector<Id> Points;    ///< of these, in the patch's order
  std::vector<Id> Local;     ///< one a point: its number in the patch, or -1
};

} // namespace lamina
