// SPDX-License-Identifier: BSD-3-Clause
// Faces of a mesh on their way to its patches.
#pragma once

#include "MeshPatches.h"

#include <tuple>

namespace lamina
{

/// What faces of one patch share before pieces are told apart.
struct PatchGroup
{
  PatchKind kind = PatchKind::Wall;
  MaterialPair pair;
  int surfacePatch = 0;
};
inline bool operator<(const PatchGroup& a, const PatchGroup& b)
{
  return std::tie(a.kind, a.pair.first, a.pair.second, a.surfacePatch) <
         std::tie(b.kind, b.pair.first, b.pair.second, b.surfacePatch);
}
inline bool operator==(const PatchGroup& a, const PatchGroup& b)
{
  return !(a < b) && !(b < a);
}

/// A face that belongs to a patch, before the patches are numbered.
struct RawFace
{
  PatchFace face;
  std::array<Id, 4> corners;
  PatchGroup group;
};

/// The faces that belong to a patch: those of one cell, and those of two cells of different materials.
std::vector<RawFace> CollectFaces(const VolumeMesh& mesh, const TriangleComplex* surface, double scale,
                                  const CellFaces* known, Monitor& monitor);
/// The piece of each face: faces of one group that are connected through edges; pieces are numbered in the
/// order of their first face.
std::vector<std::size_t> FindPieces(const std::vector<RawFace>& faces, std::size_t& count);

} // namespace lamina
