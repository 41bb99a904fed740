// SPDX-License-Identifier: BSD-3-Clause
// What the rounds left: hidden nodes and bad triangles.
#include "Refinement.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace lamina
{

/// Nodes whose faces no direction sees well: nothing good can grow there.
void Refinement::UncoverNodes(const Uncovering& how)
{
  constexpr int mostRounds = 40;
  constexpr double helped = 0.005;
  std::map<Id, Id> triedAt; // the clock when a node could not be made better
  std::map<Id, int> splits; // of edges at a node
  std::map<Id, double> sightAtSplit;
  std::vector<Id>& candidates = this->LeftHidden;
  if (!how.onlyLeft)
  {
    candidates.resize(static_cast<std::size_t>(this->Surface.PointCount()));
    std::iota(candidates.begin(), candidates.end(), Id{ 0 });
  }
  for (int round = 0; round < mostRounds && !candidates.empty() && !this->Watch.Cancelled(); ++round)
  {
    std::vector<std::pair<double, Id>> hidden;
    for (Id p : candidates)
    {
      const double sight = this->Surface.Star(p).empty() ? 1 : this->Surface.Visibility(p);
      if (sight < (round == 0 ? how.from : how.enough))
      {
        hidden.push_back({ sight, p });
      }
    }
    std::sort(hidden.begin(), hidden.end());
    candidates.clear();
    bool better = false;
    for (const auto& node : hidden)
    {
      const Id p = node.second;
      candidates.push_back(p);
      const auto inVain = triedAt.find(p);
      if (inVain != triedAt.end() && this->Surface.ChangedAround(p) <= inVain->second)
      {
        continue;
      }
      int done = 0;
      while (done < 4 && !this->Watch.Cancelled() && this->Surface.Uncover(p, how.gain))
      {
        ++done;
      }
      better = better || done > 0;
      const double sight = done < 4 && splits[p] < how.mostSplits ? this->Surface.Visibility(p) : 1;
      const bool inVainBefore = how.onlyLeft && splits[p] > 0 && sight < sightAtSplit[p] + helped;
      if (sight < how.enough && !inVainBefore && this->SplitBeside(p, how))
      {
        ++splits[p];
        sightAtSplit[p] = sight;
        better = true;
      }
      else if (done < 4)
      {
        triedAt[p] = this->Surface.Clock();
      }
    }
    if (!better)
    {
      return;
    }
  }
}

/// Splits the relatively longest edge at p that stays long enough, if there is one.
bool Refinement::SplitBeside(Id p, const Uncovering& how)
{
  double longest = how.shortest;
  Id end = -1;
  for (Id t : this->Surface.Star(p))
  {
    for (Id q : this->Surface.Corners(t))
    {
      if (q != p && this->Surface.RelativeLength(p, q) > longest &&
          (how.leastQuality == 0 || this->Surface.QualityOfHalves(p, q) >= how.leastQuality))
      {
        longest = this->Surface.RelativeLength(p, q);
        end = q;
      }
    }
  }
  if (end >= 0)
  {
    this->Surface.Split(p, end);
  }
  return end >= 0;
}

/// Bad triangles that the rounds left: merge away their shortest edge or move a corner.
void Refinement::MendShapes()
{
  constexpr double good = 0.4;
  constexpr int mostMoves = 10;
  constexpr int splitFrom = 2; // rounds, when all else was tried
  for (int round = 0; round < 5; ++round)
  {
    std::vector<std::pair<double, Id>> bad;
    for (Id t = 0; t < this->Surface.TriangleCount(); ++t)
    {
      if (this->Surface.IsAlive(t) && this->Surface.Quality(t) < good)
      {
        bad.push_back({ this->Surface.Quality(t), t });
      }
    }
    if (bad.empty() || this->Watch.Cancelled())
    {
      return;
    }
    std::sort(bad.begin(), bad.end());
    for (const auto& item : bad)
    {
      if (!this->Surface.IsAlive(item.second) || this->Surface.Quality(item.second) > good || this->Stopped())
      {
        continue;
      }
      Triangle c = this->Surface.Corners(item.second);
      std::size_t shortest = 0;
      for (std::size_t k = 1; k < 3; ++k)
      {
        if (this->Surface.Length(c[k], c[(k + 1) % 3]) <
            this->Surface.Length(c[shortest], c[(shortest + 1) % 3]))
        {
          shortest = k;
        }
      }
      for (std::size_t k = 0; k < 3; ++k)
      {
        if (this->Surface.Merge(c[(shortest + k) % 3], c[(shortest + k + 1) % 3], true))
        {
          break;
        }
      }
    }
    this->SwapAll();
    for (const auto& item : bad)
    {
      if (!this->Surface.IsAlive(item.second))
      {
        continue;
      }
      for (Id p : Triangle(this->Surface.Corners(item.second)))
      {
        this->Surface.Relax(p);
        for (int i = 0; i < mostMoves && this->Surface.Quality(item.second) < good; ++i)
        {
          if (!this->Surface.Reshape(p))
          {
            break;
          }
        }
      }
      if (round >= splitFrom && this->Surface.Quality(item.second) < good)
      {
        this->Surface.SplitFlat(item.second);
      }
    }
  }
}

} // namespace lamina
