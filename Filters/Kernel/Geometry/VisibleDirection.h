// SPDX-License-Identifier: BSD-3-Clause
// The direction from which a node sees all its faces best.
#pragma once

#include "../Base/Types.h"

namespace lamina
{

struct VisibleDirection
{
  Vec3 direction;          ///< unit
  double leastCosine = -1; ///< least dot product with a normal; not positive: no direction sees all faces
};

/// The unit vector m whose least dot product with the given unit normals is largest: the axis of the smallest
/// cone that holds them (an incremental construction as for the smallest enclosing ball).
VisibleDirection FindVisibleDirection(const std::vector<Vec3>& normals);

/// The unit vector whose least dot product with the given vectors of any length is largest, and that product:
/// with normals as long as their faces are well shaped it leans less on the poor ones. By trying all that two
/// or three of them can determine, so for a few vectors.
VisibleDirection FindWeightedDirection(const std::vector<Vec3>& vectors);

} // namespace lamina
