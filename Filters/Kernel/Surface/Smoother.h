// SPDX-License-Identifier: BSD-3-Clause
// The phases of volume-conserving smoothing, and the sweeps in them.
#pragma once

#include "../Base/Monitor.h"
#include "../Search/SheetGaps.h"
#include "EdgeColours.h"
#include "MoveGuard.h"
#include "Regions.h"
#include "SmoothSurface.h"

namespace lamina
{

/// The edge of a cube whose faces are cut in two has this share of the triangles' mean edge length.
constexpr double VoxelPerMeanEdge = 3 / (2 + 1.4142135623730951);

/// What smoothing holds, and what it must not touch.
struct SmoothingGoal
{
  SheetGraph regions;
  std::vector<double> volumes; ///< of the regions at the end
  /// One a point, or empty: points that must not move, where the surface is faulty.
  std::vector<char> pinned;
  /// Pairs of triangles that intersected before all.
  std::vector<std::array<Id, 2>> intersecting;
};

/// The pairs of triangles that intersect, without those that are known.
std::vector<std::array<Id, 2>> NewIntersections(const TriangleComplex& surface,
                                                const std::vector<std::array<Id, 2>>& known,
                                                Monitor& monitor);

/// How long Newton's method goes on for volumes.
struct Patience
{
  int rounds;
  double progress; ///< an error that stays above this share of the least so far, twice, ends it
};

class Smoother
{
public:
  /// unit: the mean edge length; `careful`: certify every phase by the exact test and roll back what
  /// intersects.
  Smoother(TriangleComplex& surface, const SmoothSurfaceOptions& options, const SmoothingGoal& goal,
           double unit, bool careful);

  /// All phases; false if cancelled.
  bool Run(SmoothSurfaceReport& report, Monitor& monitor);
  /// Where the points were before all; to be taken when the smoother is done with.
  std::vector<Vec3> TakeStart() { return this->Guard.TakeOrigin(); }

private:
  void StartPhase(double reach, Monitor& monitor);
  bool Phase(int sweeps, SmoothSurfaceReport& report, Monitor& monitor);
  bool RelaxOne(Relaxable which);
  Id Sweep(Monitor& monitor);
  Id RollBack(Monitor& monitor);
  void Widen(std::vector<Id>& points, int times) const;
  bool PutBack(std::vector<Id> points, Monitor& monitor);
  SheetGaps KeepApart(double cutoff, Monitor& monitor);
  bool Finish(Monitor& monitor);
  void GiveBack(Monitor& monitor);
  double WeightOf(double volume) const;
  void HoldVolumes(const std::vector<char>& held, Patience patience, Monitor& monitor);
  bool ReachVolumes(const std::vector<double>& goals, std::vector<char> held, Patience patience,
                    Monitor& monitor);
  double MovePerSweep(int sweeps) const;

  SmoothingState State;
  MoveGuard Guard;
  const SmoothSurfaceOptions& Options;
  const SmoothingGoal& Goal;
  double Unit;
  std::vector<double> Floors; ///< of the clearances around the points
  /// What the regions' volumes should be; what small ones have, from when theirs was out of reach in this
  /// phase.
  std::vector<double> Wanted;
  bool GaveBack = false;
  bool Careful;
  std::vector<std::vector<Relaxable>> Classes;
  std::vector<std::vector<char>> Stuck; ///< edges of Classes that wait for the next phase
};

} // namespace lamina
