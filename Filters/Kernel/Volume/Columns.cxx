// SPDX-License-Identifier: BSD-3-Clause
#include "Columns.h"

#include "ColumnGrowth.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace lamina
{

namespace
{

constexpr double FairQuality = 0.4; ///< prisms below are faired
constexpr int MostAttempts = 4; ///< at fairing, each without the places where the one before cost a column
constexpr int FrozenRings = 3;

} // namespace

void ColumnGrowth::SetFractions()
{
  this->C.layers = this->Options.layers;
  double sum = 0;
  double step = 1;
  this->C.fraction = { 0 };
  for (int k = 0; k < this->C.layers; ++k, step *= this->Options.growth)
  {
    sum += step;
    this->C.fraction.push_back(sum);
  }
  for (double& f : this->C.fraction)
  {
    f /= sum > 0 ? sum : 1;
  }
}

bool ColumnGrowth::Mend(Monitor& watch)
{
  this->Dirty.assign(this->W.triangles.size(), 1);
  this->Lowered.resize(this->W.points.size());
  std::iota(this->Lowered.begin(), this->Lowered.end(), Id{ 0 });
  FrontCheck front(this->W);
  for (int round = 0; round < MostRounds && !watch.Cancelled(); ++round)
  {
    this->LimitSlopes();
    watch.Progress(static_cast<double>(round) / MostRounds, "growing layers");
    if (this->MendCells(round) == 0 && this->MendFronts(front, round) == 0)
    {
      return true;
    }
  }
  return false;
}

void ColumnGrowth::Try(const std::function<Id()>& change, Monitor& watch)
{
  const Columns before = this->C;
  this->Frozen.assign(this->W.points.size(), 0);
  for (int attempt = 0; attempt < MostAttempts; ++attempt)
  {
    if (change() == 0)
    {
      return;
    }
    const bool sound = this->Mend(watch);
    const bool lost = sound && this->FreezeLost(before);
    if (sound && !lost)
    {
      return;
    }
    this->C = before;
    if (!sound)
    {
      return;
    }
  }
}

std::vector<Id> ColumnGrowth::PoorlyStanding() const
{
  const auto isExcused = [&](Id v)
  { return this->C.Stopped(v) || this->MustBeGood[static_cast<std::size_t>(v)] == 0; };
  const auto sight = [&](Id v) { return this->Sight(v, this->C.direction[static_cast<std::size_t>(v)]); };
  std::vector<Id> worst(this->W.triangles.size(), -1);
  this->Watch.For(
    static_cast<Id>(worst.size()), 256,
    [&](Id begin, Id end)
    {
      for (Id t = begin; t < end; ++t)
      {
        const Triangle& c = this->W.triangles[static_cast<std::size_t>(t)];
        if (std::none_of(c.begin(), c.end(), isExcused) && this->WorstOf(t, 1) <= this->Options.leastQuality)
        {
          worst[static_cast<std::size_t>(t)] =
            *std::min_element(c.begin(), c.end(), [&](Id v, Id w) { return sight(v) < sight(w); });
        }
      }
    });
  worst.erase(std::remove(worst.begin(), worst.end(), -1), worst.end());
  return worst;
}

bool ColumnGrowth::StopPoor(Monitor& watch)
{
  for (int attempt = 0; attempt < MostAttempts && !watch.Cancelled(); ++attempt)
  {
    const std::vector<Id> poor = this->PoorlyStanding();
    if (poor.empty())
    {
      break;
    }
    for (Id v : poor)
    {
      this->C.hidden[static_cast<std::size_t>(v)] = 1;
      this->C.height[static_cast<std::size_t>(v)] = 0;
    }
    if (!this->Mend(watch))
    {
      return false;
    }
  }
  return true;
}

bool ColumnGrowth::FreezeLost(const Columns& before)
{
  std::vector<Id> ring = this->PoorlyStanding();
  for (std::size_t v = 0; v < before.height.size(); ++v)
  {
    if (this->C.height[v] == 0 && before.height[v] > 0)
    {
      ring.push_back(static_cast<Id>(v));
    }
  }
  const bool hasLost = !ring.empty();
  for (int rings = 0; rings < FrozenRings; ++rings)
  {
    std::vector<Id> next;
    for (Id v : ring)
    {
      for (Id t : Row(this->W.star, v))
      {
        for (Id p : this->W.triangles[static_cast<std::size_t>(t)])
        {
          char& frozen = this->Frozen[static_cast<std::size_t>(p)];
          next.insert(next.end(), frozen == 0 ? 1 : 0, p);
          frozen = 1;
        }
      }
    }
    ring = std::move(next);
  }
  return hasLost;
}

Result<Columns> ColumnGrowth::Run()
{
  this->SetFractions();
  this->FindDirections();
  for (std::size_t v = 0; v < this->Options.stopped.size(); ++v)
  {
    this->C.hidden[v] |= this->Options.stopped[v];
  }
  this->SmoothDirections();
  this->SetHeights();
  SubMonitor mending(this->Watch, 0, 0.8);
  bool sound = this->Mend(mending);
  if (sound && this->Options.cells == ColumnCells::Prisms)
  {
    sound = this->StopPoor(mending);
  }
  if (sound && this->Options.cells == ColumnCells::Prisms)
  {
    SubMonitor fairing(this->Watch, 0.8, 1);
    this->Try([this]() { return this->FairColumns(FairQuality); }, fairing);
    this->Try([this]() { return this->SmoothFront(); }, fairing);
  }
  if (this->Watch.Cancelled())
  {
    return Cancelled();
  }
  if (sound)
  {
    return std::move(this->C);
  }
  std::vector<Vec3> places;
  for (std::size_t t = 0; t < this->Dirty.size(); ++t)
  {
    if (this->Dirty[t])
    {
      places.push_back(this->W.points[static_cast<std::size_t>(this->W.triangles[t][0])]);
    }
  }
  return Unreachable("no valid layers of material " + std::to_string(this->W.material) + " could be found" +
                       DescribePlaces(places) + ": refine the surface there, or ask for fewer layers",
                     places);
}

Result<Columns> GrowColumns(const Wall& wall, const ColumnOptions& options, Monitor& monitor)
{
  return ColumnGrowth(wall, options, monitor).Run();
}

} // namespace lamina
