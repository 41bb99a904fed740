// SPDX-License-Identifier: BSD-3-Clause
// How many triangles a surface gets by its target edge lengths, told before it is refined.
#pragma once

#include "../Base/Memory.h"
#include "../Mesh/TriangleComplex.h"

namespace lamina
{

/// Area of an equilateral triangle with edges of 1.
inline constexpr double UnitArea = 0.43301270189221932;

/// Every triangle counts as one: a surface that is not going to be refined.
std::vector<double> AsItIs(const TriangleComplex& surface);

/// How many triangles each triangle becomes (below 1: it is merged with others), by its area and the target
/// edge lengths at its corners; 1 for all without targets.
std::vector<double> TrianglesWanted(const TriangleComplex& surface);

/// What Surface Refinement makes of the surface.
MemoryDemand RefinementDemand(const TriangleComplex& surface);

} // namespace lamina
