// SPDX-License-Identifier: BSD-3-Clause
// Points in the middle of a wall between the fronts of its columns.
#pragma once

#include "Columns.h"

namespace lamina
{

/// Points half way between opposite fronts, where an even number of layers has its middle. Points too near to
/// one taken before are left out. `front` has the columns' tops.
std::vector<Vec3> MiddlePoints(const Wall& wall, const Columns& columns, const TriangleComplex& front,
                               int layers, double anisotropy, Monitor& monitor);

} // namespace lamina
