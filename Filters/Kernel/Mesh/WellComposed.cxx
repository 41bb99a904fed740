// SPDX-License-Identifier: BSD-3-Clause
#include "WellComposed.h"

#include "FaultScan.h"
#include "LabelLattice.h"
#include "LabelRepair.h"

#include <set>

namespace lamina
{

RepairReport RepairTopology(LabelImage& image, const RepairOptions& options, Monitor& monitor)
{
  const LabelLattice lattice(image, options);
  const FaultScan scan = ScanFaults(image, lattice, monitor);
  RepairReport report = scan.counts;
  if (scan.points.empty() || monitor.Cancelled())
  {
    return report;
  }
  const MaterialContacts known(image, monitor);
  LabelRepair repair(image, options, lattice, known);
  report.remaining = repair.Run(scan.points, monitor);
  report.changed = repair.Changed();
  return report;
}

std::vector<Id> FindTopologyFaults(const LabelImage& image, const RepairOptions& options, Monitor& monitor)
{
  const LabelLattice lattice(image, options);
  std::set<Id> voxels;
  for (const auto& point : ScanFaults(image, lattice, monitor).points)
  {
    for (int q = 0; q < 8; ++q)
    {
      const auto voxel = LabelLattice::VoxelAround(point, q);
      if (lattice.IsVoxel(voxel))
      {
        voxels.insert(lattice.VoxelIndex(voxel));
      }
    }
  }
  return { voxels.begin(), voxels.end() };
}

} // namespace lamina
