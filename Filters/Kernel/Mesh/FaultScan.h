// SPDX-License-Identifier: BSD-3-Clause
// All faulty lattice points of a label image.
#pragma once

#include "../Base/Monitor.h"
#include "LabelLattice.h"
#include "WellComposed.h"

namespace lamina
{

struct FaultScan
{
  std::vector<LabelLattice::Place> points; ///< i fastest, then j, then k
  RepairReport counts;                     ///< edges, corners and contacts
};

FaultScan ScanFaults(const LabelImage& image, const LabelLattice& lattice, Monitor& monitor);

} // namespace lamina
