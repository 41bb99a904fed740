// SPDX-License-Identifier: BSD-3-Clause
#include "Smoother.h"

#include "../Search/Clearance.h"
#include "../Search/SelfIntersection.h"
#include "FairingStep.h"

#include <algorithm>

namespace lamina
{

namespace
{

constexpr int halvings = 2; ///< a refused move is tried again at half its weight this often
/// The staircase itself goes first: on its steps no curvature can be measured.
constexpr int sweepsBeforeLevelling = 4;

/// Sweeps between two measurements of the clearances: few at first, while the staircase holds sheets close
/// together.
int SweepsOfPhase(int done)
{
  return done < sweepsBeforeLevelling ? 2 : (done < 12 ? 4 : 8);
}

} // namespace

Smoother::Smoother(TriangleComplex& surface, const SmoothSurfaceOptions& options, double unit, bool careful)
  : State(surface)
  , Guard(this->State, options.largestDrift * unit)
  , Options(options)
  , Unit(unit)
  , Careful(careful)
  , Classes(ColourEdges(this->State, ChooseEdges(this->State)))
{
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
  }
  return true;
}

/// Relaxes one edge at full weight or, where that is refused, at less. Returns whether it need not be asked
/// again in this phase: its move is refused at any weight.
bool Smoother::RelaxOne(const Edge& edge)
{
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
    const std::vector<Edge>& edges = this->Classes[c];
    std::vector<char>& stuck = this->Stuck[c];
    monitor.For(static_cast<Id>(edges.size()), 512,
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

/// The certificate of a phase: no two triangles intersect, else their points go back to the phase's start,
/// and those around them, until none do; at the start none did.
Id Smoother::RollBack(Monitor& monitor)
{
  std::vector<char> back(this->State.surface.points.size(), 0);
  Id count = 0;
  for (int round = 0; !monitor.Cancelled(); ++round)
  {
    const auto pairs = FindIntersections(this->State.surface.points, this->State.surface.triangles, monitor);
    if (pairs.empty())
    {
      break;
    }
    std::vector<Id> points;
    for (const auto& pair : pairs)
    {
      for (Id t : pair)
      {
        for (Id p : this->State.surface.triangles[static_cast<std::size_t>(t)])
        {
          points.push_back(p);
          if (round > 0) // the first was not enough: take the neighbours too
          {
            points.insert(points.end(), this->State.ring.Begin(p), this->State.ring.End(p));
          }
        }
      }
    }
    Id changed = 0;
    for (Id p : points)
    {
      char& done = back[static_cast<std::size_t>(p)];
      changed += done ? 0 : 1;
      done = 1;
      this->State.surface.points[static_cast<std::size_t>(p)] =
        this->Guard.PhaseStart()[static_cast<std::size_t>(p)];
    }
    count += changed;
    if (changed == 0)
    {
      break; // the input itself intersects there; the caller has been told before
    }
  }
  return count;
}

bool Smoother::Phase(int sweeps, SmoothSurfaceReport& report, Monitor& monitor)
{
  TriangleComplex& surface = this->State.surface;
  // Later moves are short: they need no wide berth, and measuring one costs time.
  const double reach = report.sweepsDone < sweepsBeforeLevelling ? this->Unit : 0.6 * this->Unit;
  std::vector<double> radii = PointClearances(surface.points, surface.triangles, reach, monitor);
  for (double& r : radii)
  {
    r *= 0.45;
  }
  this->Guard.StartPhase(std::move(radii));
  this->Stuck.clear();
  for (const std::vector<Edge>& edges : this->Classes)
  {
    this->Stuck.emplace_back(edges.size(), 0);
  }
  const SheetGraph graph = MakeSheetGraph(surface);
  const std::vector<double> targets = ShellVolumes(surface, graph);
  if (report.sweepsDone >= sweepsBeforeLevelling && this->Options.wavelength > 0)
  {
    const std::vector<char> held =
      LevelWaves(this->State, this->Guard, this->Options.wavelength * this->Unit, monitor);
    RestoreVolumes(surface, graph, targets, held);
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
  if (!this->Careful)
  {
    return !monitor.Cancelled();
  }
  const Id rolled = this->RollBack(monitor);
  report.pointsRolledBack += rolled;
  if (rolled > 0)
  {
    RestoreVolumes(surface, graph, targets);
  }
  return !monitor.Cancelled();
}

} // namespace lamina
