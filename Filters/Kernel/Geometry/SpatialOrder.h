// SPDX-License-Identifier: BSD-3-Clause
// An order of points in which neighbours in space mostly stand near one another.
#pragma once

#include "../Base/Types.h"

namespace lamina
{

/// The ids of the points along a Z-shaped curve through space (G. M. Morton: A computer oriented geodetic
/// data base, 1966); points at the same place keep their order. What visits points so finds most of what it
/// reads in the processor's cache.
std::vector<Id> SpatialOrder(const std::vector<Vec3>& points);

} // namespace lamina
