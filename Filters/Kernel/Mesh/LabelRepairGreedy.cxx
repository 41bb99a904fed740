// SPDX-License-Identifier: BSD-3-Clause
// Single changes, those that mend most first.
#include "LabelRepair.h"

#include <algorithm>
#include <queue>
#include <tuple>
#include <unordered_map>

namespace lamina
{

bool LabelRepair::HasFaultyCorner(const Place& voxel) const
{
  bool any = false;
  for (int q = 0; q < 8 && !any; ++q)
  {
    any = this->IsFaulty(LabelLattice::CornerOf(voxel, q));
  }
  return any;
}

/// The change of a voxel that mends most; score: faults after less before, and what it breaks. Above -1: none
/// good.
LabelChange LabelRepair::BestChange(const Place& voxel, const Care& care, double& score)
{
  const int own = this->LabelOf(voxel);
  LabelChange best{ voxel, own, own };
  score = 0;
  if (this->Lattice.IsFrozen(this->Lattice.VoxelIndex(voxel)) || !this->HasFaultyCorner(voxel))
  {
    return best;
  }
  const VoxelFaults faults(this->Lattice.Around(voxel), this->Lattice.Faults());
  const int before = faults.Now();
  std::array<std::pair<int, int>, 27> choices; // more faults, label
  std::size_t count = 0;
  for (int n = 1; n < faults.LabelCount(); ++n)
  {
    const int label = faults.LabelAt(n);
    const int more = faults.With(label) - before;
    if (more < 0)
    {
      choices[count++] = { more, label };
    }
  }
  std::sort(choices.begin(), choices.begin() + static_cast<std::ptrdiff_t>(count));
  // A change costs 1 at least, so the first that cannot be better ends the choice.
  for (std::size_t n = 0; n < count && (score > -1 || choices[n].first < score); ++n)
  {
    const double cost = this->Cost.Of({ voxel, own, choices[n].second }, faults, care.prices);
    const double value = choices[n].first + cost - 1;
    if (value <= -1 && value < score && cost <= care.dearest)
    {
      score = value;
      best.to = choices[n].second;
    }
  }
  return best;
}

/// Voxels in the order of what they mend. An entry may promise more than its voxel holds by now: it is looked
/// at again when its turn comes. What holds more than promised is entered anew.
class LabelRepair::Promises
{
public:
  struct Promise
  {
    double score;
    Id voxel;
    int to;
    bool operator<(const Promise& other) const
    {
      return std::tie(other.score, other.voxel, other.to) < std::tie(this->score, this->voxel, this->to);
    }
    bool operator==(const Promise& other) const
    {
      return this->score == other.score && this->voxel == other.voxel && this->to == other.to;
    }
  };
  /// voxels: ascending; if `only`, no others are entered.
  Promises(const std::vector<Id>& voxels, bool only)
    : Voxels(voxels)
    , Only(only)
  {
  }
  bool MayEnter(Id voxel) const
  {
    return !this->Only || std::binary_search(this->Voxels.begin(), this->Voxels.end(), voxel);
  }
  void Enter(const Promise& promise)
  {
    const auto at = this->Live.insert({ promise.voxel, promise });
    if (at.second || at.first->second < promise)
    {
      at.first->second = promise;
      this->Queue.push(promise);
    }
  }
  bool Take(Promise& promise)
  {
    while (!this->Queue.empty())
    {
      promise = this->Queue.top();
      this->Queue.pop();
      const auto at = this->Live.find(promise.voxel);
      if (at != this->Live.end() && at->second == promise)
      {
        this->Live.erase(at);
        return true;
      }
    }
    return false;
  }

private:
  const std::vector<Id>& Voxels;
  bool Only;
  std::priority_queue<Promise> Queue; // the least score on top
  std::unordered_map<Id, Promise> Live;
};

void LabelRepair::Consider(const Place& voxel, const Care& care, Promises& promises)
{
  if (!promises.MayEnter(this->Lattice.VoxelIndex(voxel)))
  {
    return;
  }
  double score = 0;
  const LabelChange change = this->BestChange(voxel, care, score);
  if (score <= -1)
  {
    promises.Enter({ score, this->Lattice.VoxelIndex(voxel), change.to });
  }
}

void LabelRepair::MendGreedily(const std::vector<Place>& group, const Care& care, Monitor& monitor)
{
  std::vector<Id> voxels;
  for (const Place& point : group)
  {
    for (int q = 0; q < 8; ++q)
    {
      const Place voxel = LabelLattice::VoxelAround(point, q);
      if (this->Lattice.IsVoxel(voxel))
      {
        voxels.push_back(this->Lattice.VoxelIndex(voxel));
      }
    }
  }
  std::sort(voxels.begin(), voxels.end());
  voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
  // The next part has its own turn.
  Promises promises(voxels, group.size() >= MostInPart);
  for (const Id voxel : voxels)
  {
    this->Consider(this->Lattice.VoxelPlace(voxel), care, promises);
  }
  Promises::Promise promise;
  while (!monitor.Cancelled() && promises.Take(promise))
  {
    const Place voxel = this->Lattice.VoxelPlace(promise.voxel);
    double score = 0;
    const LabelChange change = this->BestChange(voxel, care, score);
    if (!(promise == Promises::Promise{ score, promise.voxel, change.to }))
    {
      this->Consider(voxel, care, promises);
      continue;
    }
    if (!this->Apply({ change }))
    {
      continue;
    }
    this->NoteRough(voxel);
    for (Id n = 0; n < 27; ++n)
    {
      const Place near{ voxel[0] + n % 3 - 1, voxel[1] + n / 3 % 3 - 1, voxel[2] + n / 9 - 1 };
      if (this->Lattice.IsVoxel(near))
      {
        this->Consider(near, care, promises);
      }
    }
  }
}

/// Lessen the faults around a place by the one change that does most.
bool LabelRepair::MendByOne(const Place& point, const Care& care)
{
  LabelChange best;
  double least = 0;
  for (int q = 0; q < 8; ++q)
  {
    const Place voxel = LabelLattice::VoxelAround(point, q);
    double score = 0;
    const LabelChange change =
      this->Lattice.IsVoxel(voxel) ? this->BestChange(voxel, care, score) : LabelChange();
    if (score < least)
    {
      least = score;
      best = change;
    }
  }
  if (least > -1 || !this->Apply({ best }))
  {
    return false;
  }
  this->NoteRough(best.voxel);
  return true;
}

} // namespace lamina
