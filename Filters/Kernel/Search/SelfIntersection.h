// SPDX-License-Identifier: BSD-3-Clause
// All pairs of triangles of one surface that meet anywhere but in the corners and the edge they share.
#pragma once

#include "../Base/Monitor.h"
#include "TriangleTree.h"

#include <array>

namespace lamina
{

/// The pairs (i < j, ascending) for which TrianglesIntersect holds, exactly. Incomplete if
/// monitor.Cancelled().
std::vector<std::array<Id, 2>> FindIntersections(const std::vector<Vec3>& points,
                                                 const std::vector<Triangle>& triangles, Monitor& monitor);

} // namespace lamina
