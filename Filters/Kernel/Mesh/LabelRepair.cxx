// SPDX-License-Identifier: BSD-3-Clause
#include "LabelRepair.h"

#include <algorithm>
#include <queue>
#include <set>
#include <tuple>
#include <unordered_map>

namespace lamina
{

namespace
{

/// Larger groups of faulty places are not searched as one: the search grows exponentially.
constexpr std::size_t MostInGroup = 8;
/// In larger groups the changes that mend most go first, if careful ones are not enough.
constexpr std::size_t ManyInGroup = 24;
/// Still larger ones (noise) are mended part by part, so that time and memory stay in proportion.
constexpr std::size_t MostInPart = 8192;
/// The share of the lattice points of its box that a group of noise takes up at least.
constexpr double DensityOfNoise = 0.25;
/// How often searches may change a voxel: twice in the end, and in attempts that were taken back.
constexpr int MostSearched = 4;
/// Careful changes up to this cost join and cut nothing, if they take from what is thin or make a bridge at
/// most.
constexpr double DearestThatKeeps = 1.7;
constexpr Id StepsOfGroup = 3000;
constexpr Id StepsOfPlace = 150;
constexpr Id StepsInNoise = 40;
/// For all places together: where searches find little, single changes do as well.
constexpr Id StepsOfAllPlaces = 20000;
constexpr Id StepsForEachFault = 3;
constexpr Id StepsOfImprovement = 400;
constexpr Id StepsOfAllImprovements = 20000;

/// At most so many voxels are told to Improve().
constexpr std::size_t MostRough = 4096;
constexpr double ShareOfGroups = 0.8;
constexpr const char* Doing = "repairing the topology";

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
                         const MaterialContacts& known, PointFlags faulty)
  : Image(image)
  , First(image.labels)
  , Lattice(lattice)
  , Known(known)
  , Faulty(std::move(faulty))
  , Cost(lattice, this->First, known)
  , Search(image.labels, this->First, lattice, this->Cost, this->Faulty)
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
  this->Top = std::get<2>(order.back());
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

void LabelRepair::Set(const Place& voxel, int label)
{
  int& own = this->LabelOf(voxel);
  this->First.Keep(this->Lattice.VoxelIndex(voxel));
  this->Log.push_back({ voxel, own, label });
  own = label;
  for (int q = 0; q < 8; ++q)
  {
    const Place point = LabelLattice::CornerOf(voxel, q);
    this->Faulty.Set(point, this->Lattice.FaultsAt(point).All() > 0);
  }
}

void LabelRepair::NoteRough(const Place& voxel)
{
  if (this->Rough.size() < MostRough)
  {
    this->Rough.push_back(this->Lattice.VoxelIndex(voxel));
  }
}

/// Make the changes of a search, unless a voxel had its share of them.
bool LabelRepair::Apply(const std::vector<LabelChange>& changes)
{
  const bool spent =
    std::any_of(changes.begin(), changes.end(),
                [this](const LabelChange& change)
                { return this->First.Searched(this->Lattice.VoxelIndex(change.voxel)) >= MostSearched; });
  if (spent || changes.empty())
  {
    return false;
  }
  for (const LabelChange& change : changes)
  {
    ++this->First.Searched(this->Lattice.VoxelIndex(change.voxel));
    this->Spent += this->Cost.Of(change, CarefulPrices);
    this->Set(change.voxel, change.to);
  }
  return true;
}

/// Faulty places at most two apart can be mended by one voxel, or get in each other's way.
std::vector<LabelRepair::Place> LabelRepair::GroupFrom(const Place& start, PointFlags& grouped) const
{
  std::vector<Place> group{ start };
  grouped.Set(start, true);
  for (std::size_t next = 0; next < group.size() && group.size() < MostInPart; ++next)
  {
    for (const Place& point : this->FaultyNear(group[next], 2, 124))
    {
      if (!grouped.At(point))
      {
        grouped.Set(point, true);
        group.push_back(point);
      }
    }
  }
  return group;
}

void LabelRepair::MendGroups(Monitor& monitor)
{
  PointFlags grouped(this->Lattice.Points());
  for (Id slot = this->Faulty.Next(0); slot != this->Faulty.End() && !monitor.Cancelled();
       slot = this->Faulty.Next(slot + 1))
  {
    if (!grouped.At(slot))
    {
      this->MendGroup(this->GroupFrom(this->Faulty.PlaceOf(slot), grouped), monitor);
      this->Log.clear();
      monitor.Progress(ShareOfGroups * static_cast<double>(slot) / static_cast<double>(this->Faulty.End()),
                       Doing);
    }
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
  const std::size_t noted = this->Rough.size();
  const double spent = this->Spent;
  const bool noise = IsNoise(group);
  const bool done = !noise && this->MendCarefully(group, monitor);
  const double careful = this->Spent - spent;
  this->Rough.resize(noted);
  const std::vector<LabelChange> changes = this->TakeBackFrom(begin);
  this->Spent = spent;
  const Care rough{ {}, 1e300, noise ? StepsInNoise : StepsOfPlace };
  if (group.size() > ManyInGroup)
  {
    this->MendGreedily(group, rough, monitor);
  }
  const bool mended = this->MendPlaces(group, begin, rough, monitor);
  if (done && (!mended || careful < this->Spent - spent))
  {
    this->TakeBackFrom(begin);
    this->Rough.resize(noted);
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
  const Care care{ CarefulPrices, DearestThatKeeps, StepsOfPlace };
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

Id LabelRepair::Run(Monitor& monitor)
{
  monitor.Progress(0, Doing);
  this->PlaceSteps = StepsOfAllPlaces + StepsForEachFault * this->Faulty.Count();
  this->MendGroups(monitor);
  monitor.Progress(ShareOfGroups, Doing);
  this->MendOneByOne(monitor);
  this->TakeBack(monitor);
  this->Improve(monitor);
  this->TakeBack(monitor);
  monitor.Progress(1, Doing);
  return this->Faulty.Count();
}

std::vector<Id> LabelRepair::Changed() const
{
  std::size_t count = 0;
  this->First.ForEachChanged([&](Id) { ++count; });
  std::vector<Id> changed;
  changed.reserve(count);
  this->First.ForEachChanged([&](Id voxel) { changed.push_back(voxel); });
  return changed;
}

} // namespace lamina
