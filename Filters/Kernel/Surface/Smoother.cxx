// SPDX-License-Identifier: BSD-3-Clause
#include "Smoother.h"

#include "../Search/SelfIntersection.h"
#include "../Search/SheetGaps.h"
#include "FairingStep.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace lamina
{

namespace
{

constexpr int halvings = 2; ///< a refused move is tried again at half its weight this often
/// The staircase itself goes first: on its steps no curvature can be measured.
constexpr int sweepsBeforeLevelling = 4;
/// What the labels' repair took is given back when the steps' corners are gone.
constexpr int sweepsBeforeGivingBack = 2;
/// Sheets stay this far apart, in voxels, or this share of their first distance if that is less.
constexpr double leastDistance = 0.25;
constexpr double shareOfClearance = 0.45; ///< that a point may move in a phase
constexpr double leastShareOfDistance = 0.5;
/// Between phases a rest of volume may wait for the next one, at the end it may not.
constexpr Patience patience{ 10, 0.5 };
constexpr Patience lastPatience{ 40, 0.9 };
/// Before this many sweeps the moves do not tell yet whether more of them help.
constexpr int sweepsBeforeSettled = 12;

/// Sweeps between two measurements of the clearances: few at first, while the staircase holds sheets close
/// together.
int SweepsOfPhase(int done)
{
  return done < sweepsBeforeLevelling ? 2 : (done < 12 ? 4 : 8);
}

} // namespace

Smoother::Smoother(TriangleComplex& surface, const SmoothSurfaceOptions& options, const SmoothingGoal& goal,
                   double unit, bool careful)
  : State(surface)
  , Guard(this->State, { options.largestDrift * unit, options.largestDisplacement * unit })
  , Options(options)
  , Goal(goal)
  , Unit(unit)
  , Careful(careful)
{
  for (std::size_t p = 0; p < goal.pinned.size(); ++p)
  {
    this->State.freedom[p] = goal.pinned[p] ? Freedom{ 0, {} } : this->State.freedom[p];
  }
  this->Classes = ColourEdges(this->State, ChooseEdges(this->State));
}

bool Smoother::Run(SmoothSurfaceReport& report, Monitor& monitor)
{
  while (report.sweepsDone < this->Options.sweeps)
  {
    const int sweeps = std::min(SweepsOfPhase(report.sweepsDone), this->Options.sweeps - report.sweepsDone);
    if (!this->Phase(sweeps, report, monitor))
    {
      return false;
    }
    if (report.sweepsDone >= sweepsBeforeSettled &&
        this->MovePerSweep(sweeps) < this->Options.settled * VoxelPerMeanEdge * this->Unit)
    {
      break;
    }
  }
  this->Wanted = this->Goal.volumes;
  this->HoldVolumes({}, lastPatience, monitor);
  return this->Finish(monitor);
}

/// The last phase has no next one to test what it did.
bool Smoother::Finish(Monitor& monitor)
{
  if (this->Floors.empty())
  {
    return !monitor.Cancelled();
  }
  constexpr int rounds = 8;
  const double floor = leastDistance * VoxelPerMeanEdge * this->Unit;
  std::vector<Vec3>& points = this->State.surface.points;
  std::vector<char> held(points.size(), 0);
  for (int round = 0; !monitor.Cancelled(); ++round)
  {
    const std::vector<Vec3> before = points;
    this->KeepApart(floor, monitor);
    if (points == before || round == rounds) // at the end some volumes may be missed, and are reported
    {
      break;
    }
    for (std::size_t p = 0; p < points.size(); ++p)
    {
      held[p] = held[p] || !(points[p] == before[p]) ? 1 : 0;
    }
    this->HoldVolumes(held, lastPatience, monitor);
  }
  return !monitor.Cancelled();
}

/// The root mean square of the points' moves over the last phase, for each of its sweeps.
double Smoother::MovePerSweep(int sweeps) const
{
  const std::vector<Vec3>& points = this->State.surface.points;
  double sum = 0;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    sum += Norm2(points[p] - this->Guard.PhaseStart()[p]);
  }
  return std::sqrt(sum / static_cast<double>(points.size())) / sweeps;
}

/// Relaxes one edge at full weight or, where that is refused, at less. Returns whether it need not be asked
/// again in this phase: its move is refused at any weight.
bool Smoother::RelaxOne(Relaxable which)
{
  const Edge edge = EndsOf(this->State, which);
  double weight = this->Options.relaxation;
  for (int attempt = 0; attempt <= halvings; ++attempt, weight /= 2)
  {
    Relaxation r;
    if (!RelaxEdge(this->State, edge.a, edge.b, weight, r))
    {
      return true;
    }
    const double negligible = 1e-4 * this->Unit;
    if (Norm2(r.moveA) + Norm2(r.moveB) < negligible * negligible)
    {
      return false;
    }
    if (this->Guard.Allows(r))
    {
      this->State.surface.points[static_cast<std::size_t>(r.a)] += r.moveA;
      if (r.b >= 0)
      {
        this->State.surface.points[static_cast<std::size_t>(r.b)] += r.moveB;
      }
      return false;
    }
  }
  return true;
}

Id Smoother::Sweep(Monitor& monitor)
{
  Id refused = 0;
  for (std::size_t c = 0; c < this->Classes.size(); ++c)
  {
    const std::vector<Relaxable>& edges = this->Classes[c];
    std::vector<char>& stuck = this->Stuck[c];
    monitor.For(static_cast<Id>(edges.size()), 256,
                [&](Id begin, Id end)
                {
                  for (Id i = begin; i < end; ++i)
                  {
                    char& idle = stuck[static_cast<std::size_t>(i)];
                    idle = idle || this->RelaxOne(edges[static_cast<std::size_t>(i)]) ? 1 : 0;
                  }
                });
    refused += std::count(stuck.begin(), stuck.end(), 1);
  }
  return refused;
}

std::vector<std::array<Id, 2>> NewIntersections(const TriangleComplex& surface,
                                                const std::vector<std::array<Id, 2>>& known, Monitor& monitor)
{
  const auto all = FindIntersections(surface.points, surface.triangles, monitor);
  std::vector<std::array<Id, 2>> added;
  std::set_difference(all.begin(), all.end(), known.begin(), known.end(), std::back_inserter(added));
  return added;
}

/// Adds the neighbours of the points, so many times.
void Smoother::Widen(std::vector<Id>& points, int times) const
{
  for (int ring = 0; ring < times; ++ring)
  {
    for (const Id p : std::vector<Id>(points))
    {
      points.insert(points.end(), this->State.ring.Begin(p), this->State.ring.End(p));
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
  }
}

/// The certificate of a phase: no two triangles intersect, else their points go back to the phase's start,
/// and those around them, until none do; at the start none did.
Id Smoother::RollBack(Monitor& monitor)
{
  Id count = 0;
  for (int round = 0; !monitor.Cancelled(); ++round)
  {
    std::vector<Id> points;
    for (const auto& pair : NewIntersections(this->State.surface, this->Goal.intersecting, monitor))
    {
      for (Id t : pair)
      {
        const Triangle& corners = this->State.surface.triangles[static_cast<std::size_t>(t)];
        points.insert(points.end(), corners.begin(), corners.end());
      }
    }
    if (points.empty())
    {
      break;
    }
    this->Widen(points, round); // the first was not enough: take the neighbours too
    count += static_cast<Id>(points.size());
    const bool isAll = points.size() == this->State.surface.points.size();
    if (!this->PutBack(std::move(points), monitor) && isAll)
    {
      break;
    }
  }
  return count;
}

/// Puts points back to where the phase began, and those whose triangles that would turn over; false if all
/// were there.
bool Smoother::PutBack(std::vector<Id> points, Monitor& monitor)
{
  const std::vector<Vec3>& start = this->Guard.PhaseStart();
  bool changed = false;
  while (!points.empty())
  {
    for (const Id p : points)
    {
      Vec3& x = this->State.surface.points[static_cast<std::size_t>(p)];
      changed = changed || !(x == start[static_cast<std::size_t>(p)]);
      x = start[static_cast<std::size_t>(p)];
    }
    points = this->Guard.Offending(start, monitor);
  }
  return changed;
}

/// Measures the gaps around the points. Where sheets have come too near since the phase began, points go back
/// until they have not: the bounds of the guard look at what faced each other then.
SheetGaps Smoother::KeepApart(double cutoff, Monitor& monitor)
{
  const TriangleComplex& surface = this->State.surface;
  for (int round = 0;; ++round)
  {
    SheetGaps gaps =
      MeasureGaps(surface.points, surface.triangles, this->State.table, this->State.star, cutoff, monitor);
    std::vector<Id> close;
    for (std::size_t p = 0; p < this->Floors.size(); ++p)
    {
      if (gaps.facing[p] < (1 - 1e-9) * this->Floors[p])
      {
        close.push_back(static_cast<Id>(p));
      }
    }
    if (close.empty() || monitor.Cancelled())
    {
      return gaps;
    }
    this->Widen(close, round);
    const bool isAll = close.size() == surface.points.size();
    if (!this->PutBack(std::move(close), monitor) && isAll)
    {
      return gaps;
    }
  }
}

/// Measures how far the points may move in this phase.
void Smoother::StartPhase(double reach, Monitor& monitor)
{
  this->Wanted = this->Goal.volumes;
  // Sheets just out of sight must not come too near either.
  const double floor = leastDistance * VoxelPerMeanEdge * this->Unit;
  const SheetGaps gaps = this->KeepApart(2 * shareOfClearance * reach + floor, monitor);
  if (this->Floors.empty())
  {
    for (const double gap : gaps.facing)
    {
      this->Floors.push_back(std::min(floor, leastShareOfDistance * gap));
    }
  }
  std::vector<double> radii(gaps.any.size());
  for (std::size_t p = 0; p < radii.size(); ++p)
  {
    const double berth = 0.5 * std::max(0.0, gaps.facing[p] - this->Floors[p]);
    radii[p] = std::min(shareOfClearance * std::min(gaps.any[p], reach), berth);
  }
  this->Guard.StartPhase(std::move(radii));
  this->Stuck.clear();
  for (const std::vector<Relaxable>& edges : this->Classes)
  {
    this->Stuck.emplace_back(edges.size(), 0);
  }
}

bool Smoother::Phase(int sweeps, SmoothSurfaceReport& report, Monitor& monitor)
{
  // Later moves are short: they need no wide berth, and measuring one costs time.
  const double reach =
    report.sweepsDone < sweepsBeforeLevelling ? 1 : (report.sweepsDone < sweepsBeforeSettled ? 0.6 : 0.4);
  this->StartPhase(reach * this->Unit, monitor);
  if (report.sweepsDone >= sweepsBeforeGivingBack && !this->GaveBack)
  {
    this->GiveBack(monitor);
  }
  if (report.sweepsDone >= sweepsBeforeLevelling && this->Options.wavelength > 0)
  {
    this->HoldVolumes(LevelWaves(this->State, this->Guard, this->Options.wavelength * this->Unit, monitor),
                      patience, monitor);
  }
  for (int i = 0; i < sweeps; ++i)
  {
    report.movesRefused += this->Sweep(monitor);
    if (monitor.Cancelled())
    {
      return false;
    }
    ++report.sweepsDone;
    monitor.Progress(static_cast<double>(report.sweepsDone) / this->Options.sweeps, "smoothing");
  }
  const bool staircase =
    report.sweepsDone < sweepsBeforeLevelling && report.sweepsDone < this->Options.sweeps;
  if (!staircase)
  {
    this->HoldVolumes({}, patience, monitor);
  }
  if (this->Careful)
  {
    const Id rolled = this->RollBack(monitor);
    report.pointsRolledBack += rolled;
    const std::vector<Vec3> certified = this->State.surface.points;
    if (rolled > 0)
    {
      this->HoldVolumes({}, patience, monitor);
      if (!NewIntersections(this->State.surface, this->Goal.intersecting, monitor).empty())
      {
        this->State.surface.points = certified;
      }
    }
  }
  return !monitor.Cancelled();
}

} // namespace lamina
