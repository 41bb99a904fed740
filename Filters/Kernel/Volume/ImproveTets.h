// SPDX-License-Identifier: BSD-3-Clause
// Local improvement of the worst tetrahedra: edges removed, faces flipped, points moved.
#pragma once

#include "../Base/Monitor.h"

namespace lamina
{

/// Positive tets in VTK's order and what must not change about them.
struct TetSet
{
  std::vector<Vec3> points;
  std::vector<std::array<Id, 4>> tets;
  std::vector<int> groups; ///< one a tet; faces without a neighbour or between groups stay; empty: one group
  std::vector<char> fixed; ///< one a point: not 0 if it must not move; empty: all may move
  std::vector<int> layerIndex; ///< one a point: no edge is made between layers that differ by more than 1; -1
                               ///< free; empty: no such bound
};

struct ImproveTetsOptions
{
  double target = 0.2; ///< tets with 3r/R below are worked on, in (0, 1)
  int rounds = 8;      ///< passes over them, 1 or more
};

struct ImproveTetsReport
{
  Id edgesRemoved = 0;
  Id facesFlipped = 0;
  Id pointsMoved = 0;
  Id left = 0;             ///< tets still below the target
  double leastQuality = 1; ///< 3r/R
};

/// Each operation raises the least 3r/R of the tets it replaces; worst first, the same on any machine and
/// with any number of threads. The boundary, the groups' interfaces and the volume they enclose stay as they
/// are. Stops early, with a sound mesh, when cancelled.
ImproveTetsReport ImproveTets(TetSet& set, const ImproveTetsOptions& options, Monitor& monitor);

} // namespace lamina
