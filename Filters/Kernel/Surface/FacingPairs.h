// SPDX-License-Identifier: BSD-3-Clause
// Triangles that face each other across a gap.
#pragma once

#include "InputSurface.h"

namespace lamina
{

struct Facet
{
  std::array<Vec3, 3> corners;
  Vec3 normal; ///< unit
  int sheet;
};

/// Whether two triangles without a common corner do not face each other nearer than `leastGap` and than
/// `share` of what lay between their places in the input.
bool StayApart(const Facet& s, const Facet& t, double leastGap, double share, const InputSurface& input);

/// The triangles of a refined surface, ascending, that face another one too near. `sheets`: in the numbers of
/// the input.
std::vector<Id> FindNarrow(const TriangleComplex& surface, const SheetGraph& sheets,
                           const InputSurface& input, Monitor& monitor);

} // namespace lamina
