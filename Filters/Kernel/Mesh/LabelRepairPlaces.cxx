// SPDX-License-Identifier: BSD-3-Clause
// One faulty place after the other.
#include "LabelRepair.h"

#include <set>

namespace lamina
{

/// Mend a place alone, or with the faulty places around it, whichever costs less a place.
bool LabelRepair::MendPlace(const Place& point, const Care& care)
{
  std::vector<LabelChange> best;
  double least = 0;
  if (this->PlaceSteps <= 0)
  {
    return this->MendByOne(point, care);
  }
  for (const std::size_t most : { std::size_t(0), std::size_t(4) })
  {
    std::vector<Place> points = this->FaultyNear(point, 1, most);
    if (most > 0 && points.empty())
    {
      break;
    }
    points.insert(points.begin(), point);
    const double count = static_cast<double>(points.size());
    const auto changes = this->Search.Find(points, { 4 + 2 * count, care.steps, care.prices, care.dearest });
    this->PlaceSteps -= this->Search.StepsTaken();
    if (!changes.empty() && (best.empty() || this->Search.BestCostFound() / count < least))
    {
      best = changes;
      least = this->Search.BestCostFound() / count;
    }
  }
  if (!this->Apply(best))
  {
    return false;
  }
  for (const LabelChange& change : best)
  {
    this->NoteRough(change.voxel);
  }
  return true;
}

/// Raise the label of the voxel of a faulty block that leaves least faults. False if all that may change are
/// at the top of what the block offers.
bool LabelRepair::Climb(const Place& point)
{
  const Block block = this->Lattice.BlockAt(point);
  std::set<int> labels(block.labels.begin(), block.labels.end());
  // Blocks of frozen voxels may not offer the last label, which mends every block without them.
  labels.insert(this->Top);
  LabelChange best;
  int least = 0;
  bool found = false;
  for (int q = 0; q < 8; ++q)
  {
    const Place v = LabelLattice::VoxelAround(point, q);
    if (!this->Lattice.IsVoxel(v) || this->Lattice.IsFrozen(this->Lattice.VoxelIndex(v)))
    {
      continue;
    }
    const int own = this->LabelOf(v);
    const VoxelFaults all(this->Lattice.Around(v), this->Lattice.Faults());
    for (const int label : labels)
    {
      if (this->Rank.at(label) <= this->Rank.at(own))
      {
        continue;
      }
      const int faults = all.With(label);
      if (!found || faults < least)
      {
        best = { v, own, label };
        least = faults;
        found = true;
      }
    }
  }
  if (found)
  {
    this->Set(best.voxel, best.to);
    this->NoteRough(best.voxel);
  }
  return found;
}

/// Mend a place, and those that this makes faulty or leaves so.
void LabelRepair::MendFrom(const Place& start, Monitor& monitor)
{
  std::vector<Place> work{ start };
  for (std::size_t next = 0; next < work.size() && !monitor.Cancelled(); ++next)
  {
    this->Log.clear();
    const Place point = work[next];
    if (this->IsFaulty(point) && !this->MendPlace(point, { {}, 1e300, StepsInNoise }))
    {
      this->Climb(point);
    }
    // A change that is no search's may make faults where there were none, or leave some.
    for (const LabelChange& change : this->Log)
    {
      for (int q = 0; q < 8; ++q)
      {
        const Place corner = LabelLattice::CornerOf(change.voxel, q);
        if (this->IsFaulty(corner))
        {
          work.push_back(corner);
        }
      }
    }
  }
  this->Log.clear();
}

void LabelRepair::MendOneByOne(Monitor& monitor)
{
  for (Id slot = this->Faulty.Next(0); slot != this->Faulty.End() && !monitor.Cancelled();
       slot = this->Faulty.Next(slot + 1))
  {
    this->MendFrom(this->Faulty.PlaceOf(slot), monitor);
  }
}

} // namespace lamina
