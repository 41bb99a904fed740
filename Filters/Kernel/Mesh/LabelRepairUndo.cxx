// SPDX-License-Identifier: BSD-3-Clause
// What turned out needless is taken back.
#include "LabelRepair.h"

#include <algorithm>

namespace lamina
{

namespace
{

constexpr Id StepsOfImprovement = 400;
constexpr Id StepsOfAllImprovements = 20000;

} // namespace

/// Give a voxel its first label again if that makes no fault.
bool LabelRepair::TakeBackAt(Id voxel)
{
  const Place place = this->Lattice.VoxelPlace(voxel);
  const VoxelFaults faults(this->Lattice.Around(place), this->Lattice.Faults());
  const int first = this->First.Of(voxel);
  if (this->LabelOf(place) == first || faults.With(first) > faults.Now())
  {
    return false;
  }
  this->Set(place, first);
  return true;
}

/// Give voxels their first label again where that makes no fault, until there is none left.
void LabelRepair::TakeBack(Monitor& monitor)
{
  std::vector<Id> taken;
  bool stop = false;
  this->First.ForEachChanged(
    [&](Id voxel)
    {
      stop = stop || monitor.Cancelled();
      if (!stop && this->TakeBackAt(voxel))
      {
        taken.push_back(voxel);
        this->Log.clear();
      }
    });
  // Only around what was taken back can there be more.
  while (!taken.empty() && !stop && !monitor.Cancelled())
  {
    std::vector<Id> near;
    for (const Id voxel : taken)
    {
      const Place centre = this->Lattice.VoxelPlace(voxel);
      for (Id n = 0; n < 27; ++n)
      {
        const Place place{ centre[0] + n % 3 - 1, centre[1] + n / 3 % 3 - 1, centre[2] + n / 9 - 1 };
        if (this->Lattice.IsVoxel(place) && this->First.IsChanged(this->Lattice.VoxelIndex(place)))
        {
          near.push_back(this->Lattice.VoxelIndex(place));
        }
      }
    }
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    near.erase(
      std::remove_if(near.begin(), near.end(), [this](Id voxel) { return !this->TakeBackAt(voxel); }),
      near.end());
    taken = std::move(near);
    this->Log.clear();
  }
}

/// Undo a few changes that lie together and look for fewer that do the same.
bool LabelRepair::ImproveAround(const Place& centre)
{
  std::vector<LabelChange> undone;
  for (Id n = 0; n < 125 && undone.size() < 5; ++n)
  {
    const Place voxel{ centre[0] + n % 5 - 2, centre[1] + n / 5 % 5 - 2, centre[2] + n / 25 - 2 };
    if (this->Lattice.IsVoxel(voxel) && this->First.IsChanged(this->Lattice.VoxelIndex(voxel)))
    {
      undone.push_back({ voxel, this->LabelOf(voxel), this->First.Of(this->Lattice.VoxelIndex(voxel)) });
    }
  }
  if (undone.size() < 2)
  {
    return false;
  }
  for (const LabelChange& change : undone)
  {
    this->Set(change.voxel, change.to);
  }
  std::vector<Place> points;
  for (const LabelChange& change : undone)
  {
    for (int q = 0; q < 8; ++q)
    {
      const Place point = LabelLattice::CornerOf(change.voxel, q);
      if (this->IsFaulty(point) && std::find(points.begin(), points.end(), point) == points.end())
      {
        points.push_back(point);
      }
    }
  }
  double cost = 0;
  for (const LabelChange& change : undone)
  {
    cost += this->Cost.Of({ change.voxel, change.to, change.from }, {});
    this->LabelOf(change.voxel) = change.from;
  }
  for (const LabelChange& change : undone)
  {
    this->LabelOf(change.voxel) = change.to;
  }
  const auto changes = this->Search.Find(points, { cost, StepsOfImprovement, {} });
  this->Steps -= StepsOfImprovement;
  const bool better = !changes.empty();
  for (const LabelChange& change : better ? changes : undone)
  {
    this->Set(change.voxel, better ? change.to : change.from);
  }
  return better;
}

void LabelRepair::Improve(Monitor& monitor)
{
  this->Steps = StepsOfAllImprovements;
  std::sort(this->Rough.begin(), this->Rough.end());
  this->Rough.erase(std::unique(this->Rough.begin(), this->Rough.end()), this->Rough.end());
  for (bool again = true; again && this->Steps > 0 && !monitor.Cancelled();)
  {
    again = false;
    for (std::size_t r = 0; r < this->Rough.size() && this->Steps > 0 && !monitor.Cancelled(); ++r)
    {
      again = this->ImproveAround(this->Lattice.VoxelPlace(this->Rough[r])) || again;
    }
  }
}

} // namespace lamina
