// SPDX-License-Identifier: BSD-3-Clause
#include "RepairSearch.h"

#include <algorithm>
#include <cmath>

namespace lamina
{

bool RepairSearch::IsExcluded(const LabelChange& change) const
{
  const auto same = [&](const LabelChange& other)
  { return other.voxel == change.voxel && other.to == change.to; };
  const auto changed = [&](const LabelChange& other) { return other.voxel == change.voxel; };
  return std::any_of(this->Path.begin(), this->Path.end(), changed) ||
         std::any_of(this->Excluded.begin(), this->Excluded.end(), same);
}

void RepairSearch::Watch(const Place& voxel)
{
  for (int q = 0; q < 8; ++q)
  {
    const Place point = LabelLattice::CornerOf(voxel, q);
    const bool matters = !this->Faulty.At(point);
    if (matters && std::find(this->Watched.begin(), this->Watched.end(), point) == this->Watched.end())
    {
      this->Watched.push_back(point);
    }
  }
}

int RepairSearch::Remaining(Place& first) const
{
  std::vector<Place> apart; // blocks that share no voxel need a change each
  for (const Place& point : this->Watched)
  {
    if (this->Lattice.FaultsAt(point).All() == 0)
    {
      continue;
    }
    const bool shares = std::any_of(apart.begin(), apart.end(),
                                    [&](const Place& other)
                                    {
                                      return std::abs(other[0] - point[0]) < 2 &&
                                             std::abs(other[1] - point[1]) < 2 &&
                                             std::abs(other[2] - point[2]) < 2;
                                    });
    if (!shares)
    {
      first = apart.empty() ? point : first;
      apart.push_back(point);
    }
  }
  return static_cast<int>(apart.size());
}

std::vector<RepairSearch::Option> RepairSearch::OptionsAt(const Place& point)
{
  std::vector<Option> options;
  const Block block = this->Lattice.BlockAt(point);
  for (int q = 0; q < 8; ++q)
  {
    const Place voxel = LabelLattice::VoxelAround(point, q);
    if (!this->Lattice.IsVoxel(voxel) || this->Lattice.IsFrozen(this->Lattice.VoxelIndex(voxel)))
    {
      continue;
    }
    const int own = block.labels[static_cast<std::size_t>(q)];
    const VoxelFaults faults(this->Lattice.Around(voxel), this->Lattice.Faults());
    const int before = faults.Now();
    for (std::size_t p = 0; p < 8; ++p)
    {
      const int label = block.labels[p];
      const bool first = std::find(block.labels.begin(), block.labels.end(), label) ==
                         block.labels.begin() + static_cast<std::ptrdiff_t>(p);
      if (first && label != own && !this->IsExcluded({ voxel, own, label }))
      {
        const LabelChange change{ voxel, own, label };
        options.push_back(
          { change, this->Cost.Of(change, faults, this->Now.prices), faults.With(label) - before });
      }
    }
  }
  return options;
}

void RepairSearch::Search(double cost)
{
  Place point{};
  const int needed = this->Remaining(point);
  if (needed == 0)
  {
    if (cost < this->BestCost)
    {
      this->BestCost = cost;
      this->Best = this->Path;
    }
    return;
  }
  if (cost + needed >= this->BestCost)
  {
    return;
  }
  std::vector<Option> options = this->OptionsAt(point);
  std::stable_sort(options.begin(), options.end(),
                   [](const Option& a, const Option& b) { return a.faults + a.cost < b.faults + b.cost; });
  const std::size_t excluded = this->Excluded.size();
  for (const Option& option : options)
  {
    if (this->Steps >= this->Now.steps)
    {
      break;
    }
    if (cost + option.cost < this->BestCost && option.cost <= this->Now.dearest)
    {
      ++this->Steps;
      const std::size_t watched = this->Watched.size();
      this->First.Keep(this->Lattice.VoxelIndex(option.change.voxel));
      this->LabelOf(option.change.voxel) = option.change.to;
      this->Path.push_back(option.change);
      this->Watch(option.change.voxel);
      this->Search(cost + option.cost);
      this->Watched.resize(watched);
      this->Path.pop_back();
      this->LabelOf(option.change.voxel) = option.change.from;
    }
    this->Excluded.push_back(option.change); // what has it was looked at above
  }
  this->Excluded.resize(excluded);
}

std::vector<LabelChange> RepairSearch::Find(const std::vector<Place>& points, const Limits& limits)
{
  this->Goal = points;
  this->Watched = points;
  this->Path.clear();
  this->Excluded.clear();
  this->Best.clear();
  this->BestCost = limits.cost;
  this->Steps = 0;
  this->Now = limits;
  this->Search(0);
  return this->Best;
}

} // namespace lamina
