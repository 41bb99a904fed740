// SPDX-License-Identifier: BSD-3-Clause
// Wedges and pyramids cut into tetrahedra that match across every face.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "MeshPatches.h"
#include "VolumeMesh.h"

namespace lamina
{

struct SplitPrismsReport
{
  Id splitCells = 0;  ///< wedges and pyramids that were cut
  Id addedPoints = 0; ///< middles of cells that no cut between their own nodes makes positive
  Id turnedQuads = 0; ///< quads cut by the other diagonal, as the first choice gave no positive cut
};

/// Cut every wedge into three tetrahedra and every pyramid into two. A quad is cut by the diagonal through
/// its node of the smallest id, so that both cells at it agree (Dompierre, Labbe, Vallet, Camarero: How to
/// subdivide pyramids, prisms, and hexahedra into tetrahedra, 8th International Meshing Roundtable, 1999).
/// Where a cell so cut is not positive everywhere (exactly), it gets a point in its middle, or the quad's
/// other diagonal is taken. Tetrahedra stay as they are, cells keep their order, added points stand last.
/// `patches` (may be null) are carried over. A failure if a cell has no positive cut.
Result<SplitPrismsReport> SplitPrisms(const VolumeMesh& mesh, VolumeMesh& tets, MeshPatches* patches,
                                      Monitor& monitor);

} // namespace lamina
