// SPDX-License-Identifier: BSD-3-Clause
// Triangular faces found by their corners, and the neighbours of tetrahedra.
#pragma once

#include "../Base/Monitor.h"

namespace lamina
{

/// The corners of a positive tet's face opposite to each of its nodes, counter-clockwise seen from outside.
constexpr std::size_t TetFaces[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };

inline Triangle TetFace(const std::array<Id, 4>& tet, std::size_t opposite)
{
  const auto& f = TetFaces[opposite];
  return { { tet[f[0]], tet[f[1]], tet[f[2]] } };
}

/// True if the triangles, of the same corners, turn the same way.
inline bool TurnAlike(const Triangle& a, const Triangle& b)
{
  const std::size_t k = b[0] == a[0] ? 0 : (b[1] == a[0] ? 1 : 2);
  return b[(k + 1) % 3] == a[1];
}

/// Triangles by their corners in any order.
class FaceTable
{
public:
  FaceTable(const std::vector<Triangle>& faces, Id pointCount);
  /// The first face with these corners, else -1.
  Id Find(const Triangle& corners) const;

private:
  struct Entry
  {
    Id middle;
    Id high;
    Id face;
  };
  std::vector<std::size_t> Start; ///< entries of lowest corner p: Start[p] to Start[p + 1] - 1
  std::vector<Entry> Entries;
};

/// The tet across each face (opposite to each node), -1 where there is none, -2 where a face has more than
/// two tets.
std::vector<std::array<Id, 4>> FindTetNeighbours(const std::vector<std::array<Id, 4>>& tets, Id pointCount,
                                                 Monitor& monitor);

} // namespace lamina
