// SPDX-License-Identifier: BSD-3-Clause
// An audit's report as JSON, and as a table with a row for each figure or finding.
#pragma once

#include "GridAudit.h"
#include "Report.h"

#include "Surface/AuditSurface.h"

class vtkTable;

namespace lamina
{

Report DescribeAudit(const GridAudit& audit);
Report DescribeAudit(const SurfaceAuditReport& report);

void FillTable(const GridAudit& audit, vtkTable* table);
void FillTable(const SurfaceAuditReport& report, vtkTable* table);

} // namespace lamina
