// SPDX-License-Identifier: BSD-3-Clause
// Edits that uncover hidden nodes.
#include "EditCorners.h"
#include "EditableSurface.h"

#include <algorithm>

namespace lamina
{

bool EditableSurface::Uncover(Id p, double gain)
{
  double blocked = 0;
  if (this->Star(p).empty() || this->Visibility(p, nullptr, &blocked) >= goodSight)
  {
    return false;
  }
  this->Mending = true;
  this->Mended = p;
  this->MostBlocked = (1 - gain) * blocked;
  const bool done =
    this->UncoverByMove(p) || this->UncoverByMerge(p) || this->UncoverBySwap(p) || this->UncoverBySearch(p);
  this->Mending = false;
  this->Mended = -1;
  return done;
}

bool EditableSurface::UncoverByMove(Id p)
{
  if (this->Classes[static_cast<std::size_t>(p)] != OnSheet)
  {
    return false;
  }
  Vec3 mean;
  double worst = 1;
  for (Id t : this->Star(p))
  {
    worst = std::min(worst, this->Quality(t));
    for (Id q : this->Corners(t))
    {
      mean += q == p ? Vec3{} : this->Point(q);
    }
  }
  mean *= 0.5 / static_cast<double>(this->Star(p).size());
  for (double step : { 0.5, 1.0, 0.25 })
  {
    if (this->TryMove(p, this->Point(p) + step * (mean - this->Point(p)), std::min(0.3, worst)))
    {
      return true;
    }
  }
  return false;
}

bool EditableSurface::UncoverByMerge(Id p)
{
  const std::vector<Id> ring = this->RingOf(p);
  return std::any_of(ring.begin(), ring.end(), [&](Id q) { return this->Merge(p, q, true); });
}

bool EditableSurface::UncoverBySwap(Id p)
{
  const std::vector<Id> star = this->Star(p);
  for (Id t : star)
  {
    const Triangle c = this->Corners(t);
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (this->Swap(c[k], c[(k + 1) % 3]))
      {
        return true;
      }
    }
  }
  return false;
}

bool EditableSurface::IsOnPatch(Id p) const
{
  const std::vector<Id>& star = this->Star(p);
  return std::any_of(star.begin(), star.end(),
                     [this](Id t)
                     {
                       const int sheet = this->Sheets[static_cast<std::size_t>(t)];
                       return this->Input.Surface().Patch(
                                this->PairOfSheet[static_cast<std::size_t>(sheet)]) != 0;
                     });
}

/// Try many small moves of p and the points around it.
bool EditableSurface::UncoverBySearch(Id p)
{
  std::vector<Id> points = this->RingOf(p);
  points.insert(points.begin(), p);
  for (const double step : searchSteps)
  {
    for (Id q : points)
    {
      if (this->TryAround(q, step * this->Target(q), std::min(0.35, this->WorstQuality(q)), false))
      {
        return true;
      }
    }
  }
  return false;
}

/// The points that share a triangle with p, ascending, without p.
std::vector<Id> EditableSurface::RingOf(Id p) const
{
  std::vector<Id> ring;
  for (Id t : this->Star(p))
  {
    for (Id q : this->Corners(t))
    {
      if (q != p)
      {
        ring.push_back(q);
      }
    }
  }
  std::sort(ring.begin(), ring.end());
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  return ring;
}

} // namespace lamina
