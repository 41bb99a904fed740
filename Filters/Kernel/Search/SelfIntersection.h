// SPDX-License-Identifier: BSD-3-Clause
// Where a surface meets itself: pairs of triangles with more in common than the corners and the edge they
// share.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "TriangleTree.h"

#include <array>
#include <optional>

namespace lamina
{

/// The pairs (i < j, ascending) for which TrianglesIntersect holds, exactly. Incomplete if
/// monitor.Cancelled().
std::vector<std::array<Id, 2>> FindIntersections(const std::vector<Vec3>& points,
                                                 const std::vector<Triangle>& triangles, Monitor& monitor);

/// The same as an error: "<what> intersects itself in <n> pairs of triangles", with a place for every
/// triangle concerned. `offending` (if given) gets those triangles, ascending. Cancelled() where the test
/// could not be finished: an unfinished test proves nothing.
std::optional<Error> CheckEmbedded(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                                   const std::string& what, Monitor& monitor,
                                   std::vector<Id>* offending = nullptr);

} // namespace lamina
