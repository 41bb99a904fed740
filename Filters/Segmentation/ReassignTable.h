// SPDX-License-Identifier: BSD-3-Clause
// What edits and their repair did: as report and as table.
#pragma once

#include "Report.h"

#include "Segmentation/Reassign.h"

class vtkTable;

namespace lamina
{

Report Describe(const ReassignReport& report);
/// A row an edit, then one for the repair, if there was any, and one for what it changed of the edits'
/// voxels.
void FillTable(const ReassignReport& report, vtkTable* table);

} // namespace lamina
