// SPDX-License-Identifier: BSD-3-Clause
// How the smoother brings the regions to their volumes and holds them.
#include "Smoother.h"

#include "FairingStep.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamina
{

namespace
{

constexpr double spreadOver = 1.5; ///< voxels, what is given back
/// Volumes are held relative to this many voxels at least.
constexpr double voxelsOfPiece = 100;
constexpr double missedFrom = 1e-12;
constexpr int mostGivingUps = 6;    ///< rounds in which small pieces keep what they have
constexpr double largestStep = 0.2; ///< of a volume at once

} // namespace

/// What the repair of the labels took is put back where it was, so that thin parts do not wait for their
/// share of what is spread over all.
void Smoother::GiveBack(Monitor& monitor)
{
  this->GaveBack = true;
  const TriangleComplex& surface = this->State.surface;
  if (surface.missing.empty())
  {
    return;
  }
  const auto owed = [&](Id triangle)
  {
    // Mostly what one side lacks the other has too much of, and one move serves both.
    const auto t = static_cast<std::size_t>(triangle);
    const double first = surface.missing[t][0];
    const double second = -surface.missing[t][1];
    const bool agree = first * second > 0;
    const double both = agree ? (std::abs(first) > std::abs(second) ? first : second) : first + second;
    const double area = 0.5 * Norm(AreaVector2(this->Guard.BeforeAll(), surface.triangles[t]));
    return both * area * std::sqrt(area);
  };
  SpreadVolumes(this->State, this->Guard, owed, spreadOver * VoxelPerMeanEdge * this->Unit, monitor);
}

/// Newton's method for the volumes of all regions, in steps that the guard allows. Points flagged in `held`
/// (or none if it is empty) stay. Small pieces whose volume is out of reach would keep their neighbours from
/// theirs: they only keep what they have then, and so on, as what that frees may take others from theirs.
/// What is not reached is left for the next phase, and not tried again before it.
void Smoother::HoldVolumes(const std::vector<char>& held, Patience patience, Monitor& monitor)
{
  std::vector<double>& goals = this->Wanted;
  for (int round = 0; round < mostGivingUps; ++round)
  {
    if (this->ReachVolumes(goals, held, patience, monitor))
    {
      return;
    }
    const std::vector<double> volumes = ShellVolumes(this->State.surface, this->Goal.regions);
    bool gaveUp = false;
    bool someLeft = false;
    for (std::size_t r = 0; r < goals.size(); ++r)
    {
      const bool isMissed = std::abs(goals[r] - volumes[r]) > missedFrom * this->WeightOf(goals[r]);
      const bool isSmall = std::abs(goals[r]) < this->WeightOf(0);
      goals[r] = isMissed && isSmall ? volumes[r] : goals[r];
      gaveUp = gaveUp || (isMissed && isSmall);
      someLeft = someLeft || (isMissed && !isSmall);
    }
    if (!gaveUp || !someLeft)
    {
      return;
    }
  }
}

/// What an error of a volume is measured by: the volume, or that of so many voxels.
double Smoother::WeightOf(double volume) const
{
  const double voxel = VoxelPerMeanEdge * this->Unit;
  return std::max(std::abs(volume), voxelsOfPiece * voxel * voxel * voxel);
}

bool Smoother::ReachVolumes(const std::vector<double>& goals, std::vector<char> held, Patience patience,
                            Monitor& monitor)
{
  std::vector<Vec3>& points = this->State.surface.points;
  held.resize(points.size(), 0);
  std::vector<Vec3> best = points;
  double least = std::numeric_limits<double>::infinity();
  int slow = 0;
  for (int round = 0; round < patience.rounds && slow < 2 && !monitor.Cancelled(); ++round)
  {
    std::vector<double> wanted = ShellVolumes(this->State.surface, this->Goal.regions);
    double worst = 0;
    for (std::size_t r = 0; r < wanted.size(); ++r)
    {
      const double rest = goals[r] - wanted[r];
      worst = std::max(worst, std::abs(rest) / this->WeightOf(goals[r]));
      const double most = largestStep * std::abs(wanted[r]);
      wanted[r] = std::min(most, std::max(-most, rest));
    }
    slow = worst < patience.progress * least ? 0 : slow + 1;
    if (worst < least)
    {
      least = worst;
      best = points;
    }
    if (worst < 1e-15)
    {
      break;
    }
    std::vector<Vec3> moves = VolumeMoves(this->State, this->Goal.regions, wanted, held, monitor);
    MoveSafely(this->State, this->Guard, std::move(moves), held, monitor);
  }
  points = std::move(best);
  return least < missedFrom;
}

} // namespace lamina
