// SPDX-License-Identifier: BSD-3-Clause
// Which material fills which tetrahedra between the facets of a surface.
#pragma once

#include "../Base/Result.h"
#include "../Mesh/TriangleComplex.h"
#include "ImproveTets.h"

#include <optional>

namespace lamina
{

/// A point inside each cavity: for every connected piece of the surface a place in the background near it,
/// where a ray along the normal meets the surface again.
std::vector<Vec3> FindHoles(const TriangleComplex& surface);

/// Gives each tet (positive, on points that begin with the surface's) the material of its side of the facets
/// that wall it in, as its group, and drops the tets of the background. An error if a facet is not a face
/// with one tet on each side that is a material, or the facets of a region disagree.
std::optional<Error> AssignRegions(const TriangleComplex& surface, TetSet& set, Monitor& monitor);

} // namespace lamina
