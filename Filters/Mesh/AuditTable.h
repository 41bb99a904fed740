// SPDX-License-Identifier: BSD-3-Clause
// An audit's report as JSON, and as a table with a row for each figure or finding.
#pragma once

#include "Report.h"

#include "Mesh/Audit.h"
#include "Surface/AuditSurface.h"

class vtkTable;

namespace lamina
{

Report DescribeAudit(const AuditReport& report);
Report DescribeAudit(const SurfaceAuditReport& report);

void FillTable(const AuditReport& report, vtkTable* table);
void FillTable(const SurfaceAuditReport& report, vtkTable* table);

} // namespace lamina
