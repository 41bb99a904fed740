// SPDX-License-Identifier: BSD-3-Clause
#include "LabelRepair.h"

#include <algorithm>
#include <deque>
#include <queue>
#include <set>
#include <tuple>

namespace lamina
{

namespace
{

/// Larger groups of faulty places are not searched as one: the search grows exponentially.
constexpr std::size_t MostInGroup = 8;
/// In larger groups the changes that mend most go first, if careful ones are not enough.
constexpr std::size_t ManyInGroup = 24;
/// The share of the lattice points of its box that a group of noise takes up at least.
constexpr double DensityOfNoise = 0.25;
/// How often searches may change a voxel: twice in the end, and in attempts that were taken back.
constexpr int MostSearched = 4;
/// Careful changes up to this cost join and cut nothing.
constexpr double DearestThatKeeps = 1.5;
constexpr Id StepsOfGroup = 3000;
constexpr Id StepsOfPlace = 150;
/// For all places together: where searches find little, single changes do as well.
constexpr Id StepsOfAllPlaces = 20000;
constexpr Id StepsForEachFault = 10;
constexpr Id StepsOfImprovement = 400;
constexpr Id StepsOfAllImprovements = 20000;

/// Whether places fill their box so densely that they are no wall and no strand.
bool IsNoise(const std::vector<LabelLattice::Place>& group)
{
  LabelLattice::Place low = group.front();
  LabelLattice::Place high = group.front();
  for (const auto& place : group)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], place[axis]);
      high[axis] = std::max(high[axis], place[axis]);
    }
  }
  const Id box = (high[0] - low[0] + 1) * (high[1] - low[1] + 1) * (high[2] - low[2] + 1);
  return static_cast<double>(group.size()) > DensityOfNoise * static_cast<double>(box);
}

} // namespace

LabelRepair::LabelRepair(LabelImage& image, const RepairOptions& options, const LabelLattice& lattice,
                         const MaterialContacts& known)
  : Image(image)
  , Before(image)
  , Original(this->Before, options)
  , Lattice(lattice)
  , Known(known)
  , Cost(lattice, this->Original, known)
  , Search(image.labels, lattice, this->Cost, this->Faulty)
  , Faulty(static_cast<std::size_t>(lattice.PointCount()), false)
{
  this->RankLabels(options);
}

/// From the rarest label to the most frequent, so that climbing wears down what there is most of least. The
/// last one must be able to fill the image: beside background, which lies around it, if that is forbidden or
/// where frozen voxels may hold it, background itself.
void LabelRepair::RankLabels(const RepairOptions& options)
{
  const FaultRules rules(options.forbidden);
  std::set<int> present{ 0 };
  for (std::size_t v = 0; v < this->Image.labels.size(); ++v)
  {
    if (v == 0 || this->Image.labels[v] != this->Image.labels[v - 1])
    {
      present.insert(this->Image.labels[v]);
    }
  }
  std::vector<std::tuple<bool, Id, int>> order;
  for (const int label : present)
  {
    const bool last = options.frozen ? label == 0 : !rules.MayNotTouch(label, 0) || options.openAtImageBorder;
    order.push_back({ last, this->Known.Voxels(label), label });
  }
  std::sort(order.begin(), order.end());
  for (std::size_t r = 0; r < order.size(); ++r)
  {
    this->Rank[std::get<2>(order[r])] = static_cast<int>(r);
  }
}

std::vector<LabelRepair::Place> LabelRepair::FaultyNear(const Place& centre, Id distance,
                                                        std::size_t most) const
{
  std::vector<Place> found;
  for (Id dk = -distance; dk <= distance; ++dk)
  {
    for (Id dj = -distance; dj <= distance; ++dj)
    {
      for (Id di = -distance; di <= distance && found.size() < most; ++di)
      {
        const Place point{ centre[0] + di, centre[1] + dj, centre[2] + dk };
        if (point != centre && this->Lattice.IsPoint(point) && this->IsFaulty(point))
        {
          found.push_back(point);
        }
      }
    }
  }
  return found;
}

std::vector<LabelRepair::Place> LabelRepair::AllFaulty() const
{
  std::vector<Place> all;
  for (auto found = std::find(this->Faulty.begin(), this->Faulty.end(), true); found != this->Faulty.end();
       found = std::find(found + 1, this->Faulty.end(), true))
  {
    all.push_back(this->Lattice.PointPlace(found - this->Faulty.begin()));
  }
  return all;
}

void LabelRepair::Set(const Place& voxel, int label)
{
  int& own = this->LabelOf(voxel);
  this->First.insert({ this->Lattice.VoxelIndex(voxel), own });
  this->Log.push_back({ voxel, own, label });
  own = label;
  for (int q = 0; q < 8; ++q)
  {
    const Place point = LabelLattice::CornerOf(voxel, q);
    this->Faulty[static_cast<std::size_t>(this->Lattice.PointIndex(point))] =
      this->Lattice.FaultsAt(point).All() > 0;
  }
}

/// Make the changes of a search, unless a voxel had its share of them.
bool LabelRepair::Apply(const std::vector<LabelChange>& changes)
{
  const bool spent = std::any_of(changes.begin(), changes.end(),
                                 [this](const LabelChange& change)
                                 {
                                   const auto found =
                                     this->Searched.find(this->Lattice.VoxelIndex(change.voxel));
                                   return found != this->Searched.end() && found->second >= MostSearched;
                                 });
  if (spent || changes.empty())
  {
    return false;
  }
  for (const LabelChange& change : changes)
  {
    ++this->Searched[this->Lattice.VoxelIndex(change.voxel)];
    this->Spent += this->Cost.Of(change, CarefulPrices);
    this->Set(change.voxel, change.to);
  }
  return true;
}

/// Faulty places at most two apart can be mended by one voxel, or get in each other's way.
void LabelRepair::MendGroups(const std::vector<Place>& faulty, Monitor& monitor)
{
  std::vector<bool> grouped(this->Faulty.size(), false);
  for (const Place& start : faulty)
  {
    if (grouped[static_cast<std::size_t>(this->Lattice.PointIndex(start))] || !this->IsFaulty(start) ||
        monitor.Cancelled())
    {
      continue;
    }
    std::vector<Place> group{ start };
    grouped[static_cast<std::size_t>(this->Lattice.PointIndex(start))] = true;
    for (std::size_t next = 0; next < group.size(); ++next)
    {
      for (const Place& point : this->FaultyNear(group[next], 2, 124))
      {
        const std::size_t index = static_cast<std::size_t>(this->Lattice.PointIndex(point));
        if (!grouped[index])
        {
          grouped[index] = true;
          group.push_back(point);
        }
      }
    }
    this->MendGroup(group, monitor);
  }
}

void LabelRepair::MendGroup(const std::vector<Place>& group, Monitor& monitor)
{
  if (group.size() <= MostInGroup)
  {
    this->Apply(
      this->Search.Find(group, { 2.0 * static_cast<double>(group.size()) + 4, StepsOfGroup, CarefulPrices }));
    return;
  }
  const std::size_t begin = this->Log.size();
  const std::size_t rough = this->Rough.size();
  const double spent = this->Spent;
  const bool done = !IsNoise(group) && this->MendCarefully(group, monitor);
  const double careful = this->Spent - spent;
  this->Rough.resize(rough);
  const std::vector<LabelChange> changes = this->TakeBackFrom(begin);
  this->Spent = spent;
  if (group.size() > ManyInGroup)
  {
    this->MendGreedily(group, { {}, 1e300 }, monitor);
  }
  const bool mended = this->MendPlaces(group, begin, { {}, 1e300 }, monitor);
  if (done && (!mended || careful < this->Spent - spent))
  {
    this->TakeBackFrom(begin);
    this->Rough.resize(rough);
    for (const LabelChange& change : changes)
    {
      this->Set(change.voxel, change.to);
    }
  }
}

/// Undo all changes from one on; returns them in the order in which they were made.
std::vector<LabelChange> LabelRepair::TakeBackFrom(std::size_t begin)
{
  const std::vector<LabelChange> changes(this->Log.begin() + static_cast<std::ptrdiff_t>(begin),
                                         this->Log.end());
  for (auto change = changes.rbegin(); change != changes.rend(); ++change)
  {
    this->Set(change->voxel, change->from);
  }
  this->Log.resize(begin);
  return changes;
}

/// Mend a group by changes that join and cut nothing: a wall that is oblique to the grid is thickened from
/// end to end before any hole in it may be opened. False if that is not enough.
bool LabelRepair::MendCarefully(const std::vector<Place>& group, Monitor& monitor)
{
  const Care care{ CarefulPrices, DearestThatKeeps };
  const std::size_t begin = this->Log.size();
  this->MendGreedily(group, care, monitor);
  return this->MendPlaces(group, begin, care, monitor);
}

/// Mend the places of a group one by one, and those that changes from `begin` on made faulty.
bool LabelRepair::MendPlaces(const std::vector<Place>& group, std::size_t begin, const Care& care,
                             Monitor& monitor)
{
  const auto mend = [&](const Place& point)
  { return !this->IsFaulty(point) || (!monitor.Cancelled() && this->MendPlace(point, care)); };
  if (!std::all_of(group.begin(), group.end(), mend))
  {
    return false;
  }
  for (std::size_t next = begin; next < this->Log.size(); ++next)
  {
    const Place voxel = this->Log[next].voxel;
    for (int q = 0; q < 8; ++q)
    {
      if (!mend(LabelLattice::CornerOf(voxel, q)))
      {
        return false;
      }
    }
  }
  return true;
}

/// The change of a voxel that mends most; score: faults after less before, and what it breaks. Above -1: none
/// good.
LabelChange LabelRepair::BestChange(const Place& voxel, const Care& care, double& score)
{
  const int own = this->LabelOf(voxel);
  LabelChange best{ voxel, own, own };
  score = 0;
  if (this->Lattice.IsFrozen(this->Lattice.VoxelIndex(voxel)))
  {
    return best;
  }
  Surroundings around = this->Lattice.Around(voxel);
  const int before = this->Lattice.CountFaults(around);
  std::array<int, 27> labels = around.labels;
  std::sort(labels.begin(), labels.end());
  const auto end = before > 0 ? std::unique(labels.begin(), labels.end()) : labels.begin();
  for (auto label = labels.begin(); label != end; ++label)
  {
    if (*label == own)
    {
      continue;
    }
    around.labels[13] = *label;
    const int faults = this->Lattice.CountFaults(around) - before;
    const double cost = faults < score ? this->Cost.Of({ voxel, own, *label }, care.prices) : 1;
    const double value = faults + cost - 1;
    if (value < score && cost <= care.dearest)
    {
      score = value;
      best.to = *label;
    }
  }
  return best;
}

void LabelRepair::MendGreedily(const std::vector<Place>& group, const Care& care, Monitor& monitor)
{
  struct Entry
  {
    double score;
    Id voxel;
    int to;
    bool operator<(const Entry& other) const
    {
      return std::tie(other.score, other.voxel, other.to) < std::tie(this->score, this->voxel, this->to);
    }
  };
  std::priority_queue<Entry> queue; // the least score on top
  const auto consider = [&](const Place& voxel)
  {
    double score = 0;
    const LabelChange change = this->BestChange(voxel, care, score);
    if (score <= -1)
    {
      queue.push({ score, this->Lattice.VoxelIndex(voxel), change.to });
    }
  };
  std::set<Id> voxels;
  for (const Place& point : group)
  {
    for (int q = 0; q < 8; ++q)
    {
      const Place voxel = LabelLattice::VoxelAround(point, q);
      if (this->Lattice.IsVoxel(voxel) && voxels.insert(this->Lattice.VoxelIndex(voxel)).second)
      {
        consider(voxel);
      }
    }
  }
  while (!queue.empty() && !monitor.Cancelled())
  {
    const Entry top = queue.top();
    queue.pop();
    const Place voxel = this->Lattice.VoxelPlace(top.voxel);
    double score = 0;
    const LabelChange change = this->BestChange(voxel, care, score);
    if (score != top.score || change.to != top.to)
    {
      continue; // an entry of its present state is in the queue as well
    }
    if (!this->Apply({ change }))
    {
      continue;
    }
    this->Rough.push_back(top.voxel);
    for (Id n = 0; n < 125; ++n)
    {
      const Place near{ voxel[0] + n % 5 - 2, voxel[1] + n / 5 % 5 - 2, voxel[2] + n / 25 - 2 };
      if (this->Lattice.IsVoxel(near))
      {
        consider(near);
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
  this->Rough.push_back(this->Lattice.VoxelIndex(best.voxel));
  return true;
}

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
    const auto changes =
      this->Search.Find(points, { 4 + 2 * count, StepsOfPlace, care.prices, care.dearest });
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
    this->Rough.push_back(this->Lattice.VoxelIndex(change.voxel));
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
  labels.insert(std::max_element(this->Rank.begin(), this->Rank.end(),
                                 [](const auto& a, const auto& b) { return a.second < b.second; })
                  ->first);
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
    Surroundings around = this->Lattice.Around(v);
    for (const int label : labels)
    {
      if (this->Rank.at(label) <= this->Rank.at(own))
      {
        continue;
      }
      around.labels[13] = label;
      const int faults = this->Lattice.CountFaults(around);
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
    this->Rough.push_back(this->Lattice.VoxelIndex(best.voxel));
  }
  return found;
}

void LabelRepair::MendOneByOne(const std::vector<Place>& faulty, Monitor& monitor)
{
  std::deque<Place> work(faulty.begin(), faulty.end());
  while (!work.empty() && !monitor.Cancelled())
  {
    const Place point = work.front();
    work.pop_front();
    const std::size_t begin = this->Log.size();
    if (this->IsFaulty(point) && !this->MendPlace(point, { {}, 1e300 }))
    {
      this->Climb(point);
    }
    // A change that is no search's may make faults where there were none, or leave some.
    for (std::size_t next = begin; next < this->Log.size(); ++next)
    {
      for (int q = 0; q < 8; ++q)
      {
        const Place corner = LabelLattice::CornerOf(this->Log[next].voxel, q);
        if (this->IsFaulty(corner))
        {
          work.push_back(corner);
        }
      }
    }
  }
}

/// Give voxels their first label again where that makes no fault.
void LabelRepair::TakeBack(Monitor& monitor)
{
  for (bool again = true; again && !monitor.Cancelled();)
  {
    again = false;
    for (const auto& item : this->First)
    {
      const Place voxel = this->Lattice.VoxelPlace(item.first);
      Surroundings around = this->Lattice.Around(voxel);
      if (around.labels[13] == item.second)
      {
        continue;
      }
      const int before = this->Lattice.CountFaults(around);
      around.labels[13] = item.second;
      if (this->Lattice.CountFaults(around) <= before)
      {
        this->Set(voxel, item.second);
        again = true;
      }
    }
  }
}

/// Undo a few changes that lie together and look for fewer that do the same.
bool LabelRepair::ImproveAround(const Place& centre)
{
  std::vector<LabelChange> undone;
  for (Id n = 0; n < 125 && undone.size() < 5; ++n)
  {
    const Place voxel{ centre[0] + n % 5 - 2, centre[1] + n / 5 % 5 - 2, centre[2] + n / 25 - 2 };
    const auto found =
      this->Lattice.IsVoxel(voxel) ? this->First.find(this->Lattice.VoxelIndex(voxel)) : this->First.end();
    if (found != this->First.end() && found->second != this->LabelOf(voxel))
    {
      undone.push_back({ voxel, this->LabelOf(voxel), found->second });
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
    for (std::size_t r = 0; r < this->Rough.size() && this->Steps > 0; ++r)
    {
      again = this->ImproveAround(this->Lattice.VoxelPlace(this->Rough[r])) || again;
    }
  }
}

Id LabelRepair::Run(const std::vector<Place>& faulty, Monitor& monitor)
{
  for (const Place& point : faulty)
  {
    this->Faulty[static_cast<std::size_t>(this->Lattice.PointIndex(point))] = true;
  }
  this->PlaceSteps = StepsOfAllPlaces + StepsForEachFault * static_cast<Id>(faulty.size());
  this->MendGroups(faulty, monitor);
  this->MendOneByOne(this->AllFaulty(), monitor);
  this->TakeBack(monitor);
  this->Improve(monitor);
  this->TakeBack(monitor);
  return std::count(this->Faulty.begin(), this->Faulty.end(), true);
}

std::vector<Id> LabelRepair::Changed() const
{
  std::vector<Id> changed;
  for (const auto& item : this->First)
  {
    if (this->Image.labels[static_cast<std::size_t>(item.first)] != item.second)
    {
      changed.push_back(item.first);
    }
  }
  return changed;
}

} // namespace lamina
