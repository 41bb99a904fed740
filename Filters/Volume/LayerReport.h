// SPDX-License-Identifier: BSD-3-Clause
// What the two filters that grow layers have to tell.
#pragma once

#include "Report.h"

#include "Volume/LayeredTets.h"

class vtkAlgorithm;

namespace lamina
{

Report DescribeLayers(const LayersReport& report);
/// A warning of `self` if wall nodes carry no layers: how many and where.
void WarnOfStoppedColumns(vtkAlgorithm* self, const LayersReport& report);
/// `ids` without those in `others`.
std::vector<int> Without(std::vector<int> ids, const std::vector<int>& others);

} // namespace lamina
