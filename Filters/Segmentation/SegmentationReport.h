// SPDX-License-Identifier: BSD-3-Clause
// What the segmentation has to tell, as JSON and as a table.
#pragma once

#include "Report.h"

#include "Segmentation/Segment.h"

class vtkTable;

namespace lamina
{

Report Describe(const SegmentReport& report);
/// Columns Rule, Material, Components, Voxels, Tunnels, Cavities: each material after the thresholds, what
/// each rule did in the order of work, the topological faults, each material in the end.
void FillTable(const SegmentReport& report, vtkTable* table);

} // namespace lamina
