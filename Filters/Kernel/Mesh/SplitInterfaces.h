// SPDX-License-Identifier: BSD-3-Clause
// Nodes of their own for the fluids, where they touch solids.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "VolumeMesh.h"

namespace lamina
{

struct SplitInterfacesReport
{
  Id twins = 0; ///< nodes that were doubled
};

/// Double every node that cells of `fluids` share with other cells: the copies, of the same coordinates and
/// values, stand behind the old nodes and belong to the fluids. `twinOf` gets for each node the id of the one
/// in its place, -1 where there is none.
Result<SplitInterfacesReport> SplitInterfaces(VolumeMesh& mesh, const std::vector<int>& fluids,
                                              std::vector<Id>& twinOf, Monitor& monitor);

} // namespace lamina
