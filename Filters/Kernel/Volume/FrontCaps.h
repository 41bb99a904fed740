// SPDX-License-Identifier: BSD-3-Clause
// The ends of a front in the planes of the wall's caps.
#pragma once

#include "../Mesh/TriangleComplex.h"
#include "Columns.h"

namespace lamina
{

/// Closes the front (FrontOf) in the plane of each cap: what lies inside the rim of the front there gets new
/// triangles, as large as the cap's own. False if a rim crosses itself, or the closed front does.
bool CloseFront(const Wall& wall, TriangleComplex& front, Monitor& monitor);

} // namespace lamina
