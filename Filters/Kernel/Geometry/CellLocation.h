// SPDX-License-Identifier: BSD-3-Clause
// Where a point lies with respect to an isoparametric cell, in VTK's node order.
#pragma once

#include "../Base/Types.h"

namespace lamina
{

enum class Location
{
  Outside,
  Border, ///< on the border, or too close to it (or too strange a cell) to tell
  Inside
};

/// Exact.
Location LocateInTet(const std::array<Vec3, 4>& nodes, const Vec3& p);
/// By inversion of the cell's map; within a part in 10^9 of a face counts as border. The cells must be valid.
Location LocateInWedge(const std::array<Vec3, 6>& nodes, const Vec3& p);
Location LocateInPyramid(const std::array<Vec3, 5>& nodes, const Vec3& p);

} // namespace lamina
