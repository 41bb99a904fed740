// SPDX-License-Identifier: BSD-3-Clause
// The audit's part on what should be one but is not: gaps between faces, and nodes that hang on them.
#pragma once

#include "../Base/Monitor.h"
#include "../Mesh/Audit.h"

namespace lamina
{

struct BoundaryAudit
{
  Id gapPoints = 0;     ///< outer nodes next to another node, but not in its place
  Id hangingPoints = 0; ///< outer nodes on a face or edge of an outer face whose corner they are not
  std::vector<std::string> findings;
};

/// Looks at each node of `boundary` (the faces of one cell only) for other faces of it within `tolerance`
/// mean edge lengths. Nodes of exactly the same place are not its question. Flags the cells in `flags`
/// (FlagNonConforming).
Result<BoundaryAudit> AuditBoundary(const VolumeMesh& mesh, const std::vector<CellFace>& boundary,
                                    double tolerance, std::vector<unsigned char>& flags, Monitor& monitor);

} // namespace lamina
