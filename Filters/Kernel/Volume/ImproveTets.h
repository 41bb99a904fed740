// SPDX-License-Identifier: BSD-3-Clause
// Local improvement of the worst tetrahedra: edges removed, faces flipped, points moved, put in and taken
// out.
#pragma once

#include "../Base/Monitor.h"

namespace lamina
{

class FrontCells;

/// Positive tets in VTK's order and what must not change about them.
struct TetSet
{
  std::vector<Vec3> points;
  std::vector<std::array<Id, 4>> tets;
  std::vector<int> groups; ///< one a tet; faces without a neighbour or between groups stay; empty: one group
  std::vector<char> fixed; ///< one a point: not 0 if it must not move; empty: all may move
  std::vector<int> layerIndex; ///< one a point: no edge is made between layers that differ by more than 1; -1
                               ///< free; empty: no such bound
  /// The prisms behind the faces of a front, with which the tets on it should go well (FrontCells.h); null:
  /// none. Their faces must not change.
  const FrontCells* front = nullptr;
};

struct ImproveTetsOptions
{
  double target = 0.25; ///< tets with 3r/R below, or angles that count so, are worked on, in (0, 1)
  /// The target instead where tets are poor by the hundred and a round betters few of them: such shapes were
  /// asked for; 0: the target stays.
  double modestTarget = 0;
  double pointsBelow = 0.2; ///< where nothing else helps, points are put in or taken out below; 0: never
  /// In the last rounds points of layers may be taken out where tets are still below, at the cost of a layer
  /// there; 0: never.
  double layersBelow = 0.12;
  int rounds = 12; ///< passes over them, 1 or more
};

struct ImproveTetsReport
{
  Id edgesRemoved = 0;
  Id facesFlipped = 0;
  Id cavitiesFilled = 0;
  Id pointsMoved = 0;
  Id pointsRemoved = 0; ///< they stay in the list of points, unused
  Id pointsAdded = 0;   ///< at the end of the list, free, of no layer
  std::vector<Id>
    takenFromLayers;       ///< points of layers among those removed, without another of theirs instead
  Id left = 0;             ///< tets still below the target
  double leastQuality = 1; ///< 3r/R
};

/// Each operation raises the least shape of the tets it replaces: 3r/R, or the least sine of a dihedral angle
/// if that is the greater lack (8 degrees, or 172, count as 3r/R of 0.2), or their fit to the prisms behind.
/// Worst first, the same on any machine and with any number of threads. The boundary, the groups' interfaces
/// and the volume they enclose stay as they are. Points of layers are drawn into others of their layer only,
/// but for the last rounds. After L. A. Freitag, C. Ollivier-Gooch: Tetrahedral mesh improvement using
/// swapping and smoothing, International Journal for Numerical Methods in Engineering 40 (1997); for points
/// put in, B. M. Klingner, J. R. Shewchuk: Aggressive tetrahedral mesh improvement, 16th International
/// Meshing Roundtable (2007); for cavities filled anew, C. Marot, K. Verhetsel, J.-F. Remacle: Reviving the
/// search for optimal tetrahedralizations, 28th International Meshing Roundtable (2020). Stops early, with a
/// sound mesh, when cancelled.
ImproveTetsReport ImproveTets(TetSet& set, const ImproveTetsOptions& options, Monitor& monitor);

} // namespace lamina
