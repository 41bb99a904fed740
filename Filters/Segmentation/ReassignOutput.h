// SPDX-License-Identifier: BSD-3-Clause
// What edits and their repair did: as report, as table and in Disputed.
#pragma once

#include "Report.h"

#include "Segmentation/Reassign.h"

class vtkImageData;
class vtkTable;

namespace lamina
{

Report Describe(const ReassignReport& report);
/// A row an edit, then one for the repair, if there was any, and one for what it changed of the edits'
/// voxels.
void FillTable(const ReassignReport& report, vtkTable* table);
/// Clear Disputed, if the image has it, where an edit decided; set it where the repair had to change that.
/// `decisions`: a Decision a voxel.
void UpdateDisputed(const std::vector<unsigned char>& decisions, vtkImageData* output);

} // namespace lamina
