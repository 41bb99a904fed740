// SPDX-License-Identifier: BSD-3-Clause
#include "ImproveTets.h"

#include "../Geometry/Predicates.h"
#include "../Geometry/Quality.h"
#include "FrontCells.h"
#include "TetCavity.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace lamina
{
namespace
{

using Tet = std::array<Id, 4>;

constexpr Id Grain = 16384;
constexpr std::size_t CancelEvery = 32;
constexpr double LittleGain = 0.02;
/// Tets below are tried again and again, as what is round them may have changed.
constexpr double NeverHopeless = 0.17;
constexpr double SameQuality = 1e-3;
constexpr std::size_t ManyOf = 100; ///< one tet in as many is many
constexpr double FewBettered = 0.1;

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

std::vector<double> Qualities(const TetSet& set, Monitor& monitor)
{
  std::vector<double> qualities(set.tets.size());
  monitor.For(static_cast<Id>(qualities.size()), Grain,
              [&](Id begin, Id end)
              {
                for (Id t = begin; t < end; ++t)
                {
                  const Tet& c = set.tets[Index(t)];
                  qualities[Index(t)] = WorthOfTet(set, c);
                }
              });
  return qualities;
}

/// The tets below the target, worst first.
std::vector<Id> FindBad(const TetSet& set, double target, Monitor& monitor)
{
  const auto qualities = Qualities(set, monitor);
  std::vector<Id> bad;
  for (std::size_t t = 0; t < qualities.size(); ++t)
  {
    if (qualities[t] < target)
    {
      bad.push_back(static_cast<Id>(t));
    }
  }
  std::stable_sort(bad.begin(), bad.end(),
                   [&](Id a, Id b) { return qualities[Index(a)] < qualities[Index(b)]; });
  return bad;
}

Id CountOf(const ImproveTetsReport& report)
{
  return report.edgesRemoved + report.facesFlipped + report.cavitiesFilled + report.pointsMoved +
         report.pointsRemoved + report.pointsAdded;
}

void Note(TetCavity::Done done, ImproveTetsReport& report)
{
  report.edgesRemoved += done == TetCavity::Done::EdgeRemoved;
  report.facesFlipped += done == TetCavity::Done::FaceFlipped;
  report.cavitiesFilled += done == TetCavity::Done::CavityFilled;
  report.pointsRemoved += done == TetCavity::Done::PointRemoved;
  report.pointsAdded += done == TetCavity::Done::PointAdded;
}

/// Qualities below which points are put in or taken out, and points of layers taken out.
struct Limits
{
  double points = 0;
  double layers = 0;
};

/// Tets on which putting in and taking out points has failed, and how good they were then.
using Hopeless = std::map<Tet, double>;

/// Tets that nothing could be done about, and what that depended on: as long as none of it changes, nothing
/// can be done.
class Vain
{
public:
  /// Where changes are noted.
  ChangeClock clock;

  bool Holds(const Tet& tet, const TetCavity& cavity) const
  {
    const auto found = this->Tried.find(tet);
    if (found == this->Tried.end())
    {
      return false;
    }
    const Attempt& a = found->second;
    const auto hasChanged = [&](Id p) { return this->clock.HasChangedSince(p, a.time); };
    return std::none_of(tet.begin(), tet.end(), hasChanged) &&
           std::none_of(a.seen.begin(), a.seen.end(), hasChanged) &&
           std::all_of(a.seen.begin(), a.seen.begin() + a.known, [&](Id p) { return cavity.IsKnown(p); }) &&
           std::none_of(a.seen.begin() + a.known, a.seen.end(), [&](Id p) { return cavity.IsKnown(p); });
  }

  /// `seen`: points of the tets that were looked at.
  void Add(const Tet& tet, std::vector<Id> seen, const TetCavity& cavity)
  {
    std::sort(seen.begin(), seen.end());
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
    const auto unknown =
      std::stable_partition(seen.begin(), seen.end(), [&](Id p) { return cavity.IsKnown(p); });
    const auto known = unknown - seen.begin();
    this->Tried[tet] = { this->clock.Now(), std::move(seen), known };
  }
  /// Other things may be done from now on.
  void Forget() { this->Tried.clear(); }

private:
  struct Attempt
  {
    std::size_t time = 0;
    std::vector<Id> seen; ///< the known ones first
    std::ptrdiff_t known = 0;
  };
  std::map<Tet, Attempt> Tried;
};

/// The first operation that betters the tet, the cheapest first. Points are put in or taken out where moves
/// gain little.
void Better(TetCavity& cavity, const TetSet& set, Id tet, const Limits& limits, Hopeless& hopeless,
            ImproveTetsReport& report)
{
  const auto quality = [&]() { return cavity.Quality(set.tets[Index(tet)]); };
  const double before = quality();
  auto done = cavity.Reconnect(tet);
  if (done == TetCavity::Done::Nothing)
  {
    report.pointsMoved += cavity.MovePoints(tet);
    const double now = quality();
    const Tet own = set.tets[Index(tet)];
    const auto failed = set.front != nullptr ? hopeless.find(own) : hopeless.end();
    const bool isHopeless =
      now > NeverHopeless && failed != hopeless.end() && std::abs(failed->second - now) < SameQuality;
    if (now < std::min(limits.points, before + LittleGain) && !isHopeless)
    {
      done = cavity.Refill(tet);
      done = done == TetCavity::Done::Nothing
               ? cavity.Collapse(tet, now < limits.layers, report.takenFromLayers)
               : done;
      done = done == TetCavity::Done::Nothing ? cavity.Insert(tet) : done;
      if (set.front != nullptr && done == TetCavity::Done::Nothing)
      {
        hopeless[own] = now;
      }
    }
  }
  Note(done, report);
}

/// One pass over the bad tets; false if nothing could be done.
bool Pass(TetSet& set, double target, const Limits& limits, const std::vector<Id>& bad, Hopeless& hopeless,
          Vain& vain, ImproveTetsReport& report, Monitor& monitor)
{
  TetCavity cavity(set, bad, &vain.clock);
  const Id before = CountOf(report);
  for (std::size_t i = 0; i < bad.size(); ++i)
  {
    if (i % CancelEvery == 0 && monitor.Cancelled())
    {
      break;
    }
    // An operation on a neighbour may have replaced or mended it.
    const Tet own = set.tets[Index(bad[i])];
    const double quality = own[0] < 0 ? 1 : cavity.Quality(own);
    if (quality < target && !vain.Holds(own, cavity))
    {
      std::vector<Id> seen;
      cavity.Watch(&seen);
      const std::size_t time = vain.clock.Now();
      Better(cavity, set, bad[i], limits, hopeless, report);
      if (vain.clock.Now() == time)
      {
        vain.Add(own, std::move(seen), cavity);
      }
    }
  }
  DropReplaced(set);
  return CountOf(report) > before;
}

} // namespace

ImproveTetsReport ImproveTets(TetSet& set, const ImproveTetsOptions& options, Monitor& monitor)
{
  ImproveTetsReport report;
  set.groups.resize(set.tets.size(), 0);
  set.fixed.resize(set.points.size(), 0);
  double target = options.target;
  auto bad = FindBad(set, target, monitor);
  Hopeless hopeless;
  Vain vain;
  bool wasLate = false;
  for (int round = 0; round < options.rounds && !bad.empty() && !monitor.Cancelled(); ++round)
  {
    monitor.Progress(round / static_cast<double>(options.rounds), "Improving the worst tetrahedra");
    const bool isLate = round >= options.rounds * 2 / 3;
    const Limits limits{ options.pointsBelow, isLate ? options.layersBelow : 0 };
    if (isLate && !wasLate && !set.layerIndex.empty()) // layers may now be crossed
    {
      vain.Forget();
    }
    wasLate = isLate;
    const bool hasMoved = Pass(set, target, limits, bad, hopeless, vain, report, monitor);
    const double before = static_cast<double>(bad.size());
    bad = FindBad(set, target, monitor);
    if (options.modestTarget > 0 && bad.size() > set.tets.size() / ManyOf &&
        static_cast<double>(bad.size()) > (1 - FewBettered) * before)
    {
      target = options.modestTarget;
      bad = FindBad(set, target, monitor);
    }
    if (!hasMoved && isLate)
    {
      break;
    }
    round = hasMoved || isLate ? round : options.rounds * 2 / 3 - 1;
  }
  report.left = static_cast<Id>(bad.size());
  for (const Tet& c : set.tets)
  {
    const auto at = [&](std::size_t k) { return set.points[Index(c[k])]; };
    report.leastQuality = std::min(report.leastQuality, TetQuality(at(0), at(1), at(2), at(3)));
  }
  return report;
}

} // namespace lamina
