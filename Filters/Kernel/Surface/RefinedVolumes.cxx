// SPDX-License-Identifier: BSD-3-Clause
#include "RefinedVolumes.h"

#include "../Geometry/Quality.h"
#include "../Search/SelfIntersection.h"
#include "FacingPairs.h"
#include "FarPlaces.h"
#include "HiddenNodes.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace lamina
{

namespace
{

// How far points may go, in the tolerance of edits, which is three quarters of the whole.
constexpr double safeReach = 0.2;  ///< what edits leave
constexpr double widestReach = 1;  ///< in shells that need more: not every place is at its limit
constexpr double leastReach = 0.1; ///< less than this is not worth another round
constexpr int gentleRounds = 8;    ///< that halve the reach at faults; later ones hold what is there
constexpr int mostRounds = 24;
constexpr double held = 1e-9;       ///< of a volume
constexpr double goodQuality = 0.4; ///< of a triangle; a worse one may lose a little
constexpr double keptQuality = 0.95;

class Restorer
{
public:
  Restorer(TriangleComplex& surface, const SheetGraph& sheets, const std::vector<double>& targets,
           const InputSurface& input, Monitor& monitor)
    : Surface(surface)
    , Sheets(sheets)
    , Targets(targets)
    , Input(input)
    , Watch(monitor)
    , Star(TrianglesOfPoints(static_cast<Id>(surface.points.size()), surface.triangles))
    , Start(surface.points)
    , Hidden(HiddenFlags(surface, Star, monitor))
    , Far(surface, sheets, input)
  {
    this->FindReaches(input);
  }

  void Run()
  {
    if (this->Watch.Cancelled())
    {
      return;
    }
    this->Edges = MakeEdgeTable(this->Surface.triangles);
    if (this->Watch.Cancelled())
    {
      return;
    }
    this->Move(this->Targets);
    this->Widen(this->Missed());
    for (int round = 0; round < mostRounds && !this->Watch.Cancelled(); ++round)
    {
      this->Move(this->Targets);
      if (const std::vector<char> missed = this->Missed(); Any(missed))
      {
        this->Move(this->Shared(missed));
      }
      const std::vector<Id> faults = this->Faults();
      if (faults.empty())
      {
        return;
      }
      this->Shorten(faults, round < gentleRounds ? 0.5 : 0);
    }
    this->Surface.points = this->Start; // better an error of volume, which the report tells, than a fault
  }

private:
  static bool Any(const std::vector<char>& flags)
  {
    return std::find(flags.begin(), flags.end(), 1) != flags.end();
  }

  void FindReaches(const InputSurface& input)
  {
    this->Tolerance.assign(this->Start.size(), input.WidestTolerance());
    std::vector<int> sheet(this->Start.size(), -1);
    for (std::size_t t = 0; t < this->Surface.triangles.size(); ++t)
    {
      for (Id p : this->Surface.triangles[t])
      {
        sheet[static_cast<std::size_t>(p)] = this->Sheets.sheetOfTriangle[t];
      }
    }
    this->Watch.For(static_cast<Id>(this->Start.size()), 1024,
                    [&](Id begin, Id end)
                    {
                      for (Id i = begin; i < end; ++i)
                      {
                        const auto p = static_cast<std::size_t>(i);
                        const auto place = input.ClosestOnSheet(sheet[p], this->Start[p], 1e300);
                        this->Tolerance[p] = place.triangle < 0 ? 0 : input.Tolerance(place);
                      }
                    });
    for (double tolerance : this->Tolerance)
    {
      this->Reach.push_back(safeReach * tolerance);
    }
  }

  void Move(const std::vector<double>& goals)
  {
    this->Surface.points = this->Start;
    RestoreVolumes(this->Surface, this->Sheets, goals, this->Reach);
  }

  /// The shells whose volume is not what it was.
  std::vector<char> Missed() const
  {
    const std::vector<double> volumes = ShellVolumes(this->Surface, this->Sheets);
    std::vector<char> missed;
    for (std::size_t s = 0; s < volumes.size(); ++s)
    {
      missed.push_back(std::abs(volumes[s] - this->Targets[s]) > held * std::abs(this->Targets[s]) ? 1 : 0);
    }
    return missed;
  }

  /// Let the points of shells that need it go farther.
  void Widen(const std::vector<char>& missed)
  {
    for (std::size_t t = 0; t < this->Surface.triangles.size(); ++t)
    {
      for (int shell : this->Sheets.shellsOfSheet[static_cast<std::size_t>(this->Sheets.sheetOfTriangle[t])])
      {
        for (Id p : this->Surface.triangles[t])
        {
          if (shell >= 0 && missed[static_cast<std::size_t>(shell)])
          {
            this->Reach[static_cast<std::size_t>(p)] =
              widestReach * this->Tolerance[static_cast<std::size_t>(p)];
          }
        }
      }
    }
  }

  /// The goals if shells that missed theirs keep what they have got, and the largest of each material that
  /// did not takes the rest.
  std::vector<double> Shared(const std::vector<char>& missed) const
  {
    const std::vector<double> volumes = ShellVolumes(this->Surface, this->Sheets);
    std::vector<double> goals = this->Targets;
    std::map<int, std::size_t> largest;
    for (std::size_t s = 0; s < goals.size(); ++s)
    {
      const auto at = largest.insert({ this->Sheets.materialOfShell[s], s }).first;
      if (missed[at->second] > missed[s] ||
          (missed[at->second] == missed[s] && this->Targets[s] > this->Targets[at->second]))
      {
        at->second = s;
      }
    }
    for (std::size_t s = 0; s < goals.size(); ++s)
    {
      const std::size_t taker = largest.at(this->Sheets.materialOfShell[s]);
      if (missed[s] && s != taker)
      {
        goals[s] = volumes[s];
        goals[taker] += this->Targets[s] - volumes[s];
      }
    }
    return goals;
  }

  /// The triangles that a move has spoiled.
  std::vector<Id> Faults()
  {
    std::vector<Id> faults = this->Far.Find(this->Watch);
    const std::vector<Id> narrow =
      FindNarrow(this->Surface, this->Star, this->Sheets, this->Input, this->Watch);
    faults.insert(faults.end(), narrow.begin(), narrow.end());
    const std::vector<Id> folds = FindFolds(this->Surface, this->Start, this->Edges, this->Watch);
    faults.insert(faults.end(), folds.begin(), folds.end());
    for (const auto& pair : FindIntersections(this->Surface.points, this->Surface.triangles, this->Watch))
    {
      faults.insert(faults.end(), pair.begin(), pair.end());
    }
    const std::vector<char> hidden = HiddenFlags(this->Surface, this->Star, this->Watch);
    for (std::size_t p = 0; p < hidden.size(); ++p)
    {
      if (hidden[p] && !this->Hidden[p])
      {
        const ListRow row = Row(this->Star, static_cast<Id>(p));
        faults.insert(faults.end(), row.begin(), row.end());
      }
    }
    for (Id t = 0; t < static_cast<Id>(this->Surface.triangles.size()); ++t)
    {
      const double now = this->QualityOf(t, this->Surface.points);
      if (now < goodQuality && now < keptQuality * this->QualityOf(t, this->Start))
      {
        faults.push_back(t);
      }
    }
    const auto hasStayed = [&](Id t)
    {
      const Triangle& c = this->Surface.triangles[static_cast<std::size_t>(t)];
      return std::all_of(c.begin(), c.end(),
                         [&](Id p) { return this->Reach[static_cast<std::size_t>(p)] == 0; });
    };
    faults.erase(std::remove_if(faults.begin(), faults.end(), hasStayed), faults.end());
    return faults;
  }

  double QualityOf(Id t, const std::vector<Vec3>& points) const
  {
    const Triangle& c = this->Surface.triangles[static_cast<std::size_t>(t)];
    return TriangleQuality(points[static_cast<std::size_t>(c[0])], points[static_cast<std::size_t>(c[1])],
                           points[static_cast<std::size_t>(c[2])]);
  }

  /// Points around faults may go a share as far, in the end nowhere.
  void Shorten(const std::vector<Id>& faults, double share)
  {
    std::vector<char> isNear(this->Start.size(), 0);
    for (Id t : faults)
    {
      for (Id p : this->Surface.triangles[static_cast<std::size_t>(t)])
      {
        isNear[static_cast<std::size_t>(p)] = 1;
      }
    }
    for (std::size_t p = 0; p < isNear.size(); ++p)
    {
      if (isNear[p])
      {
        const double moved = Norm(this->Surface.points[p] - this->Start[p]);
        const double reach = share * std::min(this->Reach[p], moved);
        this->Reach[p] = reach < leastReach * this->Tolerance[p] ? 0 : reach;
      }
    }
  }

  TriangleComplex& Surface;
  const SheetGraph& Sheets;
  const std::vector<double>& Targets;
  const InputSurface& Input;
  Monitor& Watch;
  Lists Star;
  EdgeTable Edges;
  std::vector<Vec3> Start;
  std::vector<char> Hidden; ///< points that were so before any move
  FarPlaces Far;
  std::vector<double> Tolerance; ///< of edits, one a point
  std::vector<double> Reach;
};

} // namespace

void RestoreRefinedVolumes(TriangleComplex& surface, const SheetGraph& sheets,
                           const std::vector<double>& targets, const InputSurface& input, Monitor& monitor)
{
  Restorer(surface, sheets, targets, input, monitor).Run();
}

} // namespace lamina
