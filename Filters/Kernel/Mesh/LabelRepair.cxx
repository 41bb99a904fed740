// SPDX-License-Identifier: BSD-3-Clause
#include "LabelRepair.h"

#include <algorithm>
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
/// Careful changes up to this cost join and cut nothing, if they take from what is thin or make a bridge at
/// most.
constexpr double DearestThatKeeps = 1.7;
constexpr Id StepsOfGroup = 3000;
constexpr Id StepsOfPlace = 150;
/// For all places together: where searches find little, single changes do as well.
constexpr Id StepsOfAllPlaces = 20000;
constexpr Id StepsForEachFault = 3;

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
