// SPDX-License-Identifier: BSD-3-Clause
// The largest field below a given one whose slope in space nowhere exceeds a bound.
#pragma once

#include "../Base/Monitor.h"

namespace lamina
{

/// Lowers `values` (one for each entry of `ids`, points of `points`) to f*(x) = min over y of f(y) + gradient
/// * |x - y|, exact to rounding: a value moves only if it falls by more than a part in 10^13, so that a
/// second call changes nothing. The result does not depend on the order of the points nor on the number of
/// threads.
void LimitGradient(const std::vector<Vec3>& points, const std::vector<Id>& ids, double gradient,
                   std::vector<double>& values, Monitor& monitor);

} // namespace lamina
