// SPDX-License-Identifier: BSD-3-Clause
// The operations on single tetrahedra that ImproveTets is made of.
#pragma once

#include "ImproveTets.h"

namespace lamina
{

/// The surroundings of some tets of a set, open to reconnection. Tets taken out keep their place with -1 as
/// first node, new ones are appended.
class TetCavity
{
public:
  using Tet = std::array<Id, 4>;
  enum class Done
  {
    Nothing,
    EdgeRemoved,
    FaceFlipped
  };

  /// Only the points of the tets `around` get their tets known.
  TetCavity(TetSet& set, const std::vector<Id>& around);

  double Quality(const Tet& tet) const;
  /// The best of removing one of the tet's edges or flipping one of its faces, if that raises the least
  /// quality.
  Done Reconnect(Id tet);
  /// Moves the tet's free points uphill; the number that moved.
  Id MovePoints(Id tet);

private:
  /// Tets to take out, those to put in, and the least quality of the new ones.
  struct Change
  {
    std::vector<Id> out;
    std::vector<Tet> in;
    double quality = -1;
    Done kind = Done::Nothing;
  };
  void RemoveEdge(Id tet, Id a, Id b, Change& best) const;
  void FlipFace(Id tet, std::size_t opposite, Change& best) const;
  /// The best tets instead of a ring of them round edge (a, b), and their least quality; none if not above
  /// `floor`.
  double Triangulate(const std::vector<Id>& ring, Id a, Id b, double floor, std::vector<Tet>& in) const;
  bool FindRing(Id a, Id b, int group, std::vector<Id>& out, std::vector<Id>& ring) const;
  bool IsInterior(Id point) const;
  bool MovePoint(Id point);
  bool Allows(Id a, Id b) const;
  bool IsKnown(Id point) const;
  const std::vector<Id>& TetsOf(Id point) const;
  double LeastOf(const std::vector<Id>& tets) const;
  bool IsSound(const std::vector<Tet>& tets) const;
  void Apply(const Change& change);

  TetSet& Set;
  std::vector<Id> Slot; ///< one a point: where its tets stand in Stars, -1 unknown
  std::vector<std::vector<Id>> Stars;
};

} // namespace lamina
