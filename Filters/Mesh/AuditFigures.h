// SPDX-License-Identifier: BSD-3-Clause
// The numbers of an audit under their names, which its table and its JSON share.
#pragma once

#include "GridAudit.h"

#include "Surface/AuditSurface.h"

#include <utility>
#include <vector>

namespace lamina
{

using Figures = std::vector<std::pair<const char*, double>>;

Figures FiguresOf(const AuditReport& report);
Figures FiguresOf(const MaterialAudit& material);
Figures FiguresOf(const SurfaceAuditReport& report);
Figures FiguresOf(const MaterialSurfaceAudit& material);
/// Figures of the parts besides the mesh itself.
Figures FurtherFigures(const GridAudit& audit);

/// "tetrahedra", "wedges" or "pyramids".
const char* TypeName(CellType type);

} // namespace lamina
