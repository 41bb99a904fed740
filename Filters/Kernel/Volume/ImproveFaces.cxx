// SPDX-License-Identifier: BSD-3-Clause
#include "ImproveFaces.h"

#include "../Mesh/TetFaces.h"
#include "FrontCells.h"
#include "TetCavity.h"

#include <algorithm>

namespace lamina
{
namespace
{

using Tet = std::array<Id, 4>;

constexpr Id Grain = 4096;
constexpr std::size_t CancelEvery = 32;

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

/// For each tet how bad the worst of its faces is.
std::vector<double> WorstFaces(const TetSet& set, Monitor& monitor)
{
  const auto neighbours = FindTetNeighbours(set.tets, static_cast<Id>(set.points.size()), monitor);
  const auto at = [&](Id p) { return set.points[Index(p)]; };
  const auto centreOf = [&](const Tet& c) { return 0.25 * (at(c[0]) + at(c[1]) + at(c[2]) + at(c[3])); };
  std::vector<double> worst(set.tets.size(), 0);
  monitor.For(
    static_cast<Id>(worst.size()), Grain,
    [&](Id begin, Id end)
    {
      for (Id t = begin; t < end; ++t)
      {
        const Tet& own = set.tets[Index(t)];
        const Vec3 centre = centreOf(own);
        for (std::size_t k = 0; k < 4; ++k)
        {
          const Triangle face = TetFace(own, k);
          const std::array<Vec3, 3> places{ { at(face[0]), at(face[1]), at(face[2]) } };
          const Id other = neighbours[Index(t)][k];
          const bool isInside = other >= 0 && set.groups[Index(other)] == set.groups[Index(t)];
          const Vec3* behind = other < 0 && set.front != nullptr ? set.front->CentreBehind(face) : nullptr;
          double& sum = worst[Index(t)];
          sum = isInside ? std::max(sum, FaceExcess(places, centre, centreOf(set.tets[Index(other)]))) : sum;
          sum = behind != nullptr ? std::max(sum, FaceExcess(places, centre, *behind)) : sum;
        }
      }
    });
  return worst;
}

/// Tets with a face beyond the share, worst first.
std::vector<Id> FindOblique(const std::vector<double>& worst, double share)
{
  std::vector<Id> bad;
  for (std::size_t t = 0; t < worst.size(); ++t)
  {
    bad.insert(bad.end(), worst[t] > share ? 1 : 0, static_cast<Id>(t));
  }
  std::stable_sort(bad.begin(), bad.end(), [&](Id a, Id b) { return worst[Index(a)] > worst[Index(b)]; });
  return bad;
}

/// The tets that share a point with these: what an operation on them touches must be known.
std::vector<Id> RingOf(const TetSet& set, const std::vector<Id>& tets)
{
  std::vector<char> isNear(set.points.size(), 0);
  for (Id t : tets)
  {
    for (Id p : set.tets[Index(t)])
    {
      isNear[Index(p)] = 1;
    }
  }
  std::vector<Id> ring;
  for (std::size_t t = 0; t < set.tets.size(); ++t)
  {
    const Tet& c = set.tets[t];
    const bool touches = std::any_of(c.begin(), c.end(), [&](Id p) { return isNear[Index(p)] != 0; });
    ring.insert(ring.end(), touches ? 1 : 0, static_cast<Id>(t));
  }
  return ring;
}

/// One pass; false if nothing could be done.
bool Pass(TetSet& set, const ImproveFacesOptions& options, const std::vector<Id>& bad, Monitor& monitor)
{
  TetCavity cavity(set, RingOf(set, bad));
  bool isBetter = false;
  for (std::size_t i = 0; i < bad.size(); ++i)
  {
    if (i % CancelEvery == 0 && monitor.Cancelled())
    {
      break;
    }
    // An operation on a neighbour may have replaced or mended it.
    if (set.tets[Index(bad[i])][0] >= 0 && cavity.WorstFace(bad[i]) > options.share)
    {
      isBetter = cavity.BetterFaces(bad[i], options.enough) || isBetter;
    }
  }
  DropReplaced(set);
  return isBetter;
}

} // namespace

ImproveFacesReport ImproveFaces(TetSet& set, const ImproveFacesOptions& options, Monitor& monitor)
{
  ImproveFacesReport report;
  set.groups.resize(set.tets.size(), 0);
  set.fixed.resize(set.points.size(), 0);
  std::vector<double> worst = WorstFaces(set, monitor);
  std::vector<Id> bad = FindOblique(worst, options.share);
  report.found = static_cast<Id>(bad.size());
  bool isBetter = true;
  for (int round = 0; round < options.rounds && isBetter && !bad.empty() && !monitor.Cancelled(); ++round)
  {
    monitor.Progress(round / static_cast<double>(options.rounds), "Improving the worst faces");
    isBetter = Pass(set, options, bad, monitor);
    worst = WorstFaces(set, monitor);
    bad = FindOblique(worst, options.share);
  }
  report.left = static_cast<Id>(bad.size());
  report.worst = worst.empty() ? 0 : *std::max_element(worst.begin(), worst.end());
  return report;
}

} // namespace lamina
