// SPDX-License-Identifier: BSD-3-Clause
#include "Columns.h"

#include "ColumnGrowth.h"

#include <algorithm>
#include <utility>

namespace lamina
{

namespace
{

constexpr double FairQuality = 0.4; ///< prisms below are faired

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
  for (int round = 0; round < MostRounds && !watch.Cancelled(); ++round)
  {
    this->LimitSlopes();
    watch.Progress(static_cast<double>(round) / MostRounds, "growing layers");
    if (this->MendCells(round) == 0 && this->MendFronts(round) == 0)
    {
      return true;
    }
  }
  return false;
}

void ColumnGrowth::Fair(Monitor& watch)
{
  const auto stopped = [this]() { return std::count(this->C.height.begin(), this->C.height.end(), 0.0); };
  const Columns before = this->C;
  const auto stoppedBefore = stopped();
  const bool sound = this->FairColumns(FairQuality) == 0 || this->Mend(watch);
  if (!sound || stopped() > stoppedBefore)
  {
    this->C = before;
  }
}

Result<Columns> ColumnGrowth::Run()
{
  this->SetFractions();
  this->FindDirections();
  this->SmoothDirections();
  this->SetHeights();
  SubMonitor mending(this->Watch, 0, 0.8);
  const bool sound = this->Mend(mending);
  if (sound && this->Options.cells == ColumnCells::Prisms)
  {
    SubMonitor fairing(this->Watch, 0.8, 1);
    this->Fair(fairing);
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
