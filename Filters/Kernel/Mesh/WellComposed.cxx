// SPDX-License-Identifier: BSD-3-Clause
#include "WellComposed.h"

#include "FaultScan.h"
#include "LabelLattice.h"
#include "LabelRepair.h"

#include <algorithm>

namespace lamina
{

RepairReport RepairTopology(LabelImage& image, const RepairOptions& options, Monitor& monitor)
{
  const LabelLattice lattice(image, options);
  FaultScan scan = ScanFaults(image, lattice, monitor);
  RepairReport report = scan.counts;
  if (scan.points.Next(0) == scan.points.End() || monitor.Cancelled())
  {
    return report;
  }
  const MaterialContacts known(image, monitor);
  if (monitor.Cancelled())
  {
    return report;
  }
  LabelRepair repair(image, options, lattice, known, std::move(scan.points));
  report.remaining = repair.Run(monitor);
  report.changed = repair.Changed();
  return report;
}

std::vector<Id> FindTopologyFaults(const LabelImage& image, const RepairOptions& options, Monitor& monitor)
{
  const LabelLattice lattice(image, options);
  std::vector<bool> near(image.labels.size(), false);
  const PointFlags points = ScanFaults(image, lattice, monitor).points;
  for (Id slot = points.Next(0); slot != points.End(); slot = points.Next(slot + 1))
  {
    for (int q = 0; q < 8; ++q)
    {
      const auto voxel = LabelLattice::VoxelAround(points.PlaceOf(slot), q);
      if (lattice.IsVoxel(voxel))
      {
        near[static_cast<std::size_t>(lattice.VoxelIndex(voxel))] = true;
      }
    }
  }
  std::vector<Id> voxels;
  voxels.reserve(static_cast<std::size_t>(std::count(near.begin(), near.end(), true)));
  for (auto found = std::find(near.begin(), near.end(), true); found != near.end();
       found = std::find(found + 1, near.end(), true))
  {
    voxels.push_back(found - near.begin());
  }
  return voxels;
}

} // namespace lamina
