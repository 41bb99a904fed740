// SPDX-License-Identifier: BSD-3-Clause
#include "ImproveStuck.h"

#include "../Mesh/TetFaces.h"
#include "TetCavity.h"
#include "TetPatch.h"

#include <algorithm>
#include <map>

namespace lamina
{
namespace
{

using Tet = std::array<Id, 4>;

constexpr Id Grain = 4096;
constexpr double LeastGain = 1e-3;

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

double ShapeOf(const TetSet& set, const Tet& c)
{
  const auto& p = set.points;
  return ShapeOfTet(p[Index(c[0])], p[Index(c[1])], p[Index(c[2])], p[Index(c[3])]);
}

double LeastShape(const TetSet& set)
{
  double least = 1;
  for (const Tet& tet : set.tets)
  {
    least = std::min(least, ShapeOf(set, tet));
  }
  return least;
}

/// The tets below the gate, worst first.
std::vector<Id> FindPoor(const TetSet& set, double gate, Monitor& monitor)
{
  std::vector<double> shapes(set.tets.size());
  monitor.For(static_cast<Id>(shapes.size()), Grain,
              [&](Id begin, Id end)
              {
                for (Id t = begin; t < end; ++t)
                {
                  shapes[Index(t)] = ShapeOf(set, set.tets[Index(t)]);
                }
              });
  std::vector<Id> poor;
  for (std::size_t t = 0; t < shapes.size(); ++t)
  {
    poor.insert(poor.end(), shapes[t] < gate ? 1 : 0, static_cast<Id>(t));
  }
  std::stable_sort(poor.begin(), poor.end(), [&](Id a, Id b) { return shapes[Index(a)] < shapes[Index(b)]; });
  return poor;
}

/// The parts of a tet that may be split by a point in their middle: all of it, its edges, its faces.
std::vector<std::vector<Id>> PartsOf(const Tet& tet)
{
  std::vector<std::vector<Id>> parts{ { tet.begin(), tet.end() } };
  for (std::size_t i = 0; i < 4; ++i)
  {
    for (std::size_t j = i + 1; j < 4; ++j)
    {
      parts.push_back({ tet[i], tet[j] });
    }
  }
  for (std::size_t k = 0; k < 4; ++k)
  {
    const Triangle face = TetFace(tet, k);
    parts.push_back({ face.begin(), face.end() });
  }
  return parts;
}

/// Which points of layers are free to go where they like.
enum class Freed
{
  None,
  OfTheTet,
  All
};

void FreePoints(TetSet& patch, const Tet& worst, Freed freed)
{
  for (std::size_t p = 0; p < patch.layerIndex.size(); ++p)
  {
    const bool isOfTet = std::find(worst.begin(), worst.end(), static_cast<Id>(p)) != worst.end();
    if (patch.fixed[p] == 0 && (freed == Freed::All || (freed == Freed::OfTheTet && isOfTet)))
    {
      patch.layerIndex[p] = -1;
    }
  }
}

/// The best that can be made of a patch round its worst tet; `least` is raised to its worst shape. False: no
/// better than it was.
bool Work(TetSet& patch, const Tet& worst, const ImproveStuckOptions& options, double& least,
          Monitor& monitor)
{
  ImproveTetsOptions all;
  all.target = options.target;
  all.pointsBelow = options.target;
  all.layersBelow = 0; // it is decided here which points leave their layers
  const TetSet before = patch;
  bool isBetter = false;
  const auto attempt = [&](TetSet& trial)
  {
    ImproveTets(trial, all, monitor);
    const double now = LeastShape(trial);
    if (now > least + LeastGain)
    {
      least = now;
      patch = std::move(trial);
      isBetter = true;
    }
  };
  for (const Freed freed : { Freed::None, Freed::OfTheTet, Freed::All })
  {
    if (freed != Freed::None && before.layerIndex.empty())
    {
      break;
    }
    TetSet start = before;
    FreePoints(start, worst, freed);
    TetSet trial = start;
    attempt(trial);
    for (const std::vector<Id>& part : PartsOf(worst))
    {
      if (least >= options.gate || monitor.Cancelled())
      {
        return isBetter;
      }
      trial = start;
      if (SplitPart(trial, part))
      {
        attempt(trial);
      }
    }
  }
  return isBetter;
}

/// What came of the work on one tet.
enum class Outcome
{
  Better,
  Vain,
  Known,   ///< it was in vain before, and nothing has changed
  Replaced ///< something in its surroundings has changed in this round
};

/// Works on the surroundings of a tet; where that is in vain on smaller ones, in which the search goes
/// another way.
Outcome WorkRound(TetSet& set, Id tet, const ImproveStuckOptions& options, TetPatches& patches,
                  std::map<Tet, double>& failed, Monitor& monitor)
{
  const Tet corners = set.tets[Index(tet)];
  TetSet patch;
  Tet worst = corners;
  for (int rings : options.rings)
  {
    if (!patches.Take(tet, rings, patch, worst))
    {
      return Outcome::Replaced;
    }
    double least = LeastShape(patch);
    if (rings == options.rings.front())
    {
      const auto known = failed.find(corners);
      if (known != failed.end() && known->second == least)
      {
        return Outcome::Known;
      }
      failed[corners] = least;
    }
    if (Work(patch, worst, options, least, monitor) && !monitor.Cancelled())
    {
      patches.PutBack(patch);
      return Outcome::Better;
    }
  }
  return Outcome::Vain;
}

} // namespace

ImproveStuckReport ImproveStuck(TetSet& set, const ImproveStuckOptions& options, Monitor& monitor)
{
  ImproveStuckReport report;
  set.groups.resize(set.tets.size(), 0);
  set.fixed.resize(set.points.size(), 0);
  std::map<Tet, double> failed; ///< tets that nothing helped, by the least shape round them
  for (int round = 0; round < options.rounds && !monitor.Cancelled(); ++round)
  {
    const double done = round / static_cast<double>(options.rounds);
    SubMonitor within(monitor, done, done); // improvements of patches are no progress of their own
    const std::vector<Id> poor = FindPoor(set, options.gate, monitor);
    if (poor.empty())
    {
      break;
    }
    TetPatches patches(set);
    const Id before = report.bettered;
    for (std::size_t i = 0; i < poor.size() && !monitor.Cancelled(); ++i)
    {
      if (set.tets[Index(poor[i])][0] < 0)
      {
        continue;
      }
      const Outcome outcome = WorkRound(set, poor[i], options, patches, failed, within);
      report.tried += outcome == Outcome::Better || outcome == Outcome::Vain ? 1 : 0;
      report.bettered += outcome == Outcome::Better ? 1 : 0;
    }
    DropReplaced(set);
    if (report.bettered == before)
    {
      break;
    }
  }
  return report;
}

} // namespace lamina
