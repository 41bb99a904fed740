// SPDX-License-Identifier: BSD-3-Clause
// The audit's part on single cells: validity, quality and volume.
#pragma once

#include "Audit.h"

namespace lamina
{

/// Measures every cell into `marks` (whose arrays have one entry a cell) and fills report.materials,
/// ascending.
void AuditCells(const VolumeMesh& mesh, const AuditOptions& options, AuditReport& report, AuditMarks& marks,
                Monitor& monitor);

} // namespace lamina
