// SPDX-License-Identifier: BSD-3-Clause
// Names for the plane parts of an extracted surface: openings, and the borders of the image.
#pragma once

#include "../Mesh/TriangleComplex.h"

namespace lamina
{

/// Sets the surface's patches and their names from the plane of each triangle: 0 a wall, above 0 one of the
/// image's six borders, below 0 an opening in the plane of that number. Connected openings are numbered in
/// the order of their first triangles; returns how many there are.
Id NamePlanePatches(const std::vector<int>& planeOfTriangle, TriangleComplex& surface);

} // namespace lamina
