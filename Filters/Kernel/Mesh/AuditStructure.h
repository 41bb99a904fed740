// SPDX-License-Identifier: BSD-3-Clause
// Pieces and layers of a mesh, counted from its faces.
#pragma once

#include "Audit.h"
#include "CellFaces.h"

namespace lamina
{

/// Pieces of each material that are connected through faces, into the report's materials.
void CountComponents(const VolumeMesh& mesh, const CellFaces& faces, AuditReport& report);

/// How many prisms stand on each triangle of a wall, from the first triangle of a prism of layer 1 on, into
/// the report's stackHeights.
void CountStacks(const VolumeMesh& mesh, const CellFaces& faces, AuditReport& report);

} // namespace lamina
