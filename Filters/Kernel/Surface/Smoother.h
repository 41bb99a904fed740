// SPDX-License-Identifier: BSD-3-Clause
// The phases of volume-conserving smoothing, and the sweeps in them.
#pragma once

#include "../Base/Monitor.h"
#include "../Mesh/VolumeCorrection.h"
#include "EdgeColours.h"
#include "MoveGuard.h"
#include "SmoothSurface.h"

namespace lamina
{

class Smoother
{
public:
  /// unit: the mean edge length; `careful`: certify every phase by the exact test and roll back what
  /// intersects.
  Smoother(TriangleComplex& surface, const SmoothSurfaceOptions& options, double unit, bool careful);

  /// All phases; false if cancelled.
  bool Run(SmoothSurfaceReport& report, Monitor& monitor);

private:
  bool Phase(int sweeps, SmoothSurfaceReport& report, Monitor& monitor);
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

} // namespace lamina
