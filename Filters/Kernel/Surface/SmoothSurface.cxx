// SPDX-License-Identifier: BSD-3-Clause
#include "SmoothSurface.h"

#include "../Mesh/Closedness.h"
#include "../Mesh/VolumeCorrection.h"
#include "../Search/Clearance.h"
#include "../Search/SelfIntersection.h"
#include "MoveGuard.h"

#include <algorithm>
#include <cstdint>

namespace lamina
{

namespace
{

/// Sweeps between two measurements of the clearances: few at first, while the staircase holds sheets close
/// together.
int SweepsOfPhase(int done)
{
  return done < 4 ? 2 : (done < 10 ? 6 : 10);
}

constexpr int halvings = 2; ///< a refused move is tried again at half its weight this often
constexpr int colours = 192;

/// What is relaxed: edges whose ends are of one kind, and points without such an edge (b = -1).
std::vector<Edge> ChooseEdges(const SmoothingState& s)
{
  const auto kind = [&](Id p) { return s.surface.junctionKind[static_cast<std::size_t>(p)]; };
  std::vector<Edge> chosen;
  std::vector<char> served(s.surface.points.size(), 0);
  for (std::size_t e = 0; e < s.table.edges.size(); ++e)
  {
    const Edge& edge = s.table.edges[e];
    const bool sheet = (kind(edge.a) & 3) == JunctionSheet;
    const bool curve = (kind(edge.a) & 3) == JunctionCurve && s.feature[e];
    if (kind(edge.a) == kind(edge.b) && (sheet || curve) &&
        s.freedom[static_cast<std::size_t>(edge.a)].dimensions > 1)
    {
      chosen.push_back(edge);
      served[static_cast<std::size_t>(edge.a)] = 1;
      served[static_cast<std::size_t>(edge.b)] = 1;
    }
  }
  for (std::size_t p = 0; p < served.size(); ++p)
  {
    if (!served[p] && (kind(static_cast<Id>(p)) & 3) != JunctionCorner &&
        s.star.Count(static_cast<Id>(p)) > 0)
    {
      chosen.push_back({ static_cast<Id>(p), -1 });
    }
  }
  return chosen;
}

using Mask = std::array<std::uint64_t, colours / 64>;

/// Edges of one colour neither move nor read a point that another of them moves: a sweep through the colours
/// in order gives the same result for any number of threads. A relaxation reads the triangles around its ends
/// and theirs.
std::vector<std::vector<Edge>> Colour(const SmoothingState& s, const std::vector<Edge>& edges)
{
  std::vector<Mask> written(s.surface.points.size(), Mask{});
  std::vector<Mask> read(s.surface.points.size(), Mask{});
  std::vector<std::vector<Edge>> classes(colours);
  std::vector<Id> reach;
  for (const Edge& edge : edges)
  {
    reach.clear();
    for (Id end : { edge.a, edge.b })
    {
      if (end < 0)
      {
        continue;
      }
      for (Id q : Row(s.ring, end))
      {
        reach.insert(reach.end(), s.ring.Begin(q), s.ring.End(q));
      }
    }
    std::sort(reach.begin(), reach.end());
    reach.erase(std::unique(reach.begin(), reach.end()), reach.end());
    int colour = -1;
    for (std::size_t w = 0; w < Mask{}.size() && colour < 0; ++w)
    {
      std::uint64_t taken = 0;
      for (Id p : reach)
      {
        taken |= written[static_cast<std::size_t>(p)][w];
      }
      for (Id end : { edge.a, edge.b })
      {
        taken |= end < 0 ? 0 : read[static_cast<std::size_t>(end)][w];
      }
      if (~taken != 0)
      {
        int bit = 0;
        while (taken >> bit & 1)
        {
          ++bit;
        }
        colour = static_cast<int>(64 * w) + bit;
      }
    }
    if (colour < 0)
    {
      // More than `colours` edges meet here: such an edge waits in a class of its own.
      classes.push_back({ edge });
      continue;
    }
    const auto word = static_cast<std::size_t>(colour / 64);
    const std::uint64_t flag = std::uint64_t{ 1 } << (colour % 64);
    for (Id p : reach)
    {
      read[static_cast<std::size_t>(p)][word] |= flag;
    }
    for (Id end : { edge.a, edge.b })
    {
      if (end >= 0)
      {
        written[static_cast<std::size_t>(end)][word] |= flag;
      }
    }
    classes[static_cast<std::size_t>(colour)].push_back(edge);
  }
  classes.erase(std::remove_if(classes.begin(), classes.end(), [](const auto& c) { return c.empty(); }),
                classes.end());
  return classes;
}

class Smoother
{
public:
  /// `careful`: certify every phase by the exact test and roll back what intersects.
  Smoother(TriangleComplex& surface, const SmoothSurfaceOptions& options, double unit, bool careful)
    : State(surface)
    , Guard(this->State, options.largestDrift * unit)
    , Options(options)
    , Unit(unit)
    , Careful(careful)
    , Classes(Colour(this->State, ChooseEdges(this->State)))
  {
  }

  /// The sweeps between two measurements of the clearances; false if cancelled.
  bool Phase(int sweeps, SmoothSurfaceReport& report, Monitor& monitor);

private:
  bool RelaxOne(const Edge& edge);
  Id Sweep(Monitor& monitor);
  Id RollBack(Monitor& monitor);

  SmoothingState State;
  MoveGuard Guard;
  const SmoothSurfaceOptions& Options;
  double Unit;
  bool Careful;
  std::vector<std::vector<Edge>> Classes;
  std::vector<std::vector<char>> Stuck; ///< edges of Classes that wait for the next phase
};

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
  const double reach = report.sweepsDone < 4 ? this->Unit : 0.6 * this->Unit;
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

} // namespace

Result<SmoothSurfaceReport> SmoothSurface(TriangleComplex& surface, const SmoothSurfaceOptions& options,
                                          Monitor& monitor)
{
  if (options.sweeps < 0)
  {
    return InvalidOption("the number of sweeps must be 0 or more, not " + std::to_string(options.sweeps));
  }
  if (!(options.relaxation > 0 && options.relaxation <= 1))
  {
    return InvalidOption("the relaxation must lie in (0, 1], not " + std::to_string(options.relaxation));
  }
  if (!(options.largestDrift > 0))
  {
    return InvalidOption("the largest drift must be positive, not " + std::to_string(options.largestDrift));
  }
  if (const std::optional<Error> error = CheckClosed(surface, true, monitor))
  {
    return *error;
  }
  SmoothSurfaceReport report;
  report.materials = MaterialsOf(surface);
  report.volumesBefore = MaterialVolumes(surface, report.materials);
  if (surface.junctionKind.size() != surface.points.size())
  {
    ClassifyJunctions(surface);
  }
  const double unit = MeanEdgeLength(surface);
  if (options.sweeps > 0 && unit > 0)
  {
    if (const auto error = CheckEmbedded(surface.points, surface.triangles, "the surface to smooth", monitor))
    {
      return *error;
    }
    const SheetGraph graph = MakeSheetGraph(surface);
    const std::vector<double> targets = ShellVolumes(surface, graph);
    // The bounds on moves have never failed to keep surfaces apart so far, but only the exact test proves it:
    // where it finds fault, all is done again with a test after every phase.
    const std::vector<Vec3> start = surface.points;
    for (bool careful : { false, true })
    {
      surface.points = start;
      report.sweepsDone = 0;
      report.movesRefused = 0;
      Smoother smoother(surface, options, unit, careful);
      while (report.sweepsDone < options.sweeps)
      {
        const int sweeps = std::min(SweepsOfPhase(report.sweepsDone), options.sweeps - report.sweepsDone);
        if (!smoother.Phase(sweeps, report, monitor))
        {
          surface.points = start;
          return Cancelled();
        }
      }
      if (FindIntersections(surface.points, surface.triangles, monitor).empty())
      {
        break;
      }
    }
    // Takes out the rounding errors of millions of moves, unless even that would make triangles meet.
    const std::vector<Vec3> smoothed = surface.points;
    RestoreVolumes(surface, graph, targets);
    if (!FindIntersections(surface.points, surface.triangles, monitor).empty())
    {
      surface.points = smoothed;
    }
  }
  report.volumesAfter = MaterialVolumes(surface, report.materials);
  for (std::size_t m = 0; m < report.materials.size(); ++m)
  {
    report.largestVolumeChange =
      std::max(report.largestVolumeChange, std::abs(report.volumesAfter[m] - report.volumesBefore[m]) /
                                             std::abs(report.volumesBefore[m]));
  }
  monitor.Progress(1, "smoothed");
  return report;
}

} // namespace lamina
