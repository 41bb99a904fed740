// SPDX-License-Identifier: BSD-3-Clause
// All faulty lattice points of a label image.
#pragma once

#include "../Base/Monitor.h"
#include "LabelLattice.h"
#include "PointFlags.h"
#include "WellComposed.h"

namespace lamina
{

struct FaultScan
{
  explicit FaultScan(const LabelLattice& lattice)
    : points(lattice.Points())
  {
  }
  PointFlags points;
  RepairReport counts; ///< edges, corners and contacts
};

FaultScan ScanFaults(const LabelImage& image, const LabelLattice& lattice, Monitor& monitor);

} // namespace lamina
