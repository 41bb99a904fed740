// SPDX-License-Identifier: BSD-3-Clause
// The audit's part on patches: do they cover the boundary, close, and hold what their names say.
#pragma once

#include "Audit.h"
#include "MeshPatches.h"

namespace lamina
{

struct PatchAudit
{
  Id wrongFaces = 0;     ///< rows that name no face, or not one of the patch's kind and materials
  Id missingFaces = 0;   ///< outer faces and faces between materials that are in no patch
  Id repeatedFaces = 0;  ///< in more than one
  Id openEdges = 0;      ///< edges at which the patches round a material do not close
  Id swappedPatches = 0; ///< in several pieces, not plane though an end, or out of order
  std::vector<std::string> findings;
};

/// Audit `patches` (MeshPatches as a mesh carries them) against those found anew. With `isSure` these were
/// found with the surface, and tell also walls, plane ends and openings apart.
PatchAudit AuditPatches(const VolumeMesh& mesh, const MeshPatches& patches, const MeshPatches& anew,
                        bool isSure, std::vector<unsigned char>& flags);

} // namespace lamina
