// SPDX-License-Identifier: BSD-3-Clause
// Whether a surface can bound volumes: sound arrays, and every material's boundary closed and oriented.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "TriangleComplex.h"

#include <optional>

namespace lamina
{

/// An edge at which a material's boundary is not a closed, oriented, two-manifold surface.
struct OpenEdge
{
  int material = 0;
  Id a = 0; ///< a < b
  Id b = 0;
  int forward = 0; ///< triangles of the material's boundary (normal out of the material) that run from a to b
  int backward = 0; ///< and from b to a: a sound edge has one each

  /// Several sheets may meet in an edge and still enclose a volume; then as many run forward as backward.
  bool IsOpen() const { return this->forward != this->backward; }
};

/// The array lengths agree, ids are in range, coordinates finite, corners distinct, and each triangle parts
/// two materials in the order of MaterialPair. The first thing wrong, with its places.
std::optional<Error> CheckArrays(const TriangleComplex& surface);

/// The edges of the boundary of every material but the background that are not used once in each sense,
/// ordered by material and ids. The arrays must be sound.
std::vector<OpenEdge> FindOpenEdges(const TriangleComplex& surface, Monitor& monitor);

/// CheckArrays, then FindOpenEdges: an error that says where the surface is open or, with `manifold`, where
/// more than two triangles of one material's boundary meet in an edge.
std::optional<Error> CheckClosed(const TriangleComplex& surface, bool manifold, Monitor& monitor);

} // namespace lamina
