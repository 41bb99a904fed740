// SPDX-License-Identifier: BSD-3-Clause
// The audit's part on space: random points lie in exactly one cell inside, in none outside.
#pragma once

#include "Audit.h"

namespace lamina
{

/// Tests options.overlapSamples points in the mesh's bounding box (where the surface, which may be null,
/// tells whether a cell is due) and as many inside cells. Counts overlaps, adds findings and flags cells.
void AuditOverlap(const VolumeMesh& mesh, const TriangleComplex* surface, const AuditOptions& options,
                  AuditReport& report, AuditMarks& marks, Monitor& monitor);

} // namespace lamina
