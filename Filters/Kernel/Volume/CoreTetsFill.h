// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra that TetGen makes of a closed surface, checked.
#pragma once

#include "CoreTets.h"
#include "ImproveTets.h"

namespace lamina
{

/// Positive tets inside the surface with the materials they lie in; the surface's points come first. If
/// TetGen fails it is asked for less: without the `graded` points, then with a ratio at which its refinement
/// is proven to end, then without refinement. The report gets the rung that succeeded; if none did, the error
/// and the offending triangles are those of the first.
Result<TetSet> FillCore(const TriangleComplex& surface, const std::vector<Vec3>& graded,
                        const std::vector<Vec3>& interior, const CoreTetsOptions& options,
                        CoreTetsReport& report, Monitor& monitor);

} // namespace lamina
