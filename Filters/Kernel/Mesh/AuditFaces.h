// SPDX-License-Identifier: BSD-3-Clause
// The audit's part on faces: who shares them, and how they fit the surface.
#pragma once

#include "Audit.h"

namespace lamina
{

/// Finds every face, compares it with its neighbour and with `surface` (may be null); fills the counts of
/// `report` that concern faces and each material's components (report.materials must be there), adds findings
/// and flags cells.
void AuditFaces(const VolumeMesh& mesh, const TriangleComplex* surface, const AuditOptions& options,
                AuditReport& report, AuditMarks& marks, Monitor& monitor);

} // namespace lamina
