// SPDX-License-Identifier: BSD-3-Clause
// Triangles that face each other across a gap.
#pragma once

#include "../Mesh/Adjacency.h"
#include "InputSurface.h"

#include <functional>

namespace lamina
{

/// The least cosine of angles that edits and corrections must not make between triangles that share an edge:
/// of 10 degrees.
constexpr double foldCosine = 0.98480775301220806;

struct Facet
{
  std::array<Vec3, 3> corners;
  Vec3 normal; ///< unit
  int sheet;
  MaterialPair pair;
};

/// Whether a way along the surface of at most `most` joins a place on the first facet to one on the second.
using IsJoined = std::function<bool(const Vec3& from, const Vec3& to, double most)>;

/// Whether two triangles without a common corner do not face each other nearer than `leastGap` and than
/// `share` of what lay between their places in the input. Those face each other that see each other through
/// one material, and are not joined by a short way (Search/Facing.h).
bool StayApart(const Facet& s, const Facet& t, double leastGap, double share, const InputSurface& input,
               const IsJoined& isJoined);

/// The triangles of a refined surface, ascending, that face another one too near. `sheets`: in the numbers of
/// the input; `star`: the triangles of its points.
std::vector<Id> FindNarrow(const TriangleComplex& surface, const Lists& star, const SheetGraph& sheets,
                           const InputSurface& input, Monitor& monitor);

/// The triangles, ascending, that stand at such an angle to another and stood wider where the points were
/// `before`.
std::vector<Id> FindFolds(const TriangleComplex& surface, const std::vector<Vec3>& before,
                          const EdgeTable& edges, Monitor& monitor);

} // namespace lamina
