// SPDX-License-Identifier: BSD-3-Clause
// The few worst tetrahedra that no single operation betters.
#pragma once

#include "ImproveTets.h"

namespace lamina
{

struct ImproveStuckOptions
{
  double gate = 0.13; ///< tets of a lower shape (ShapeOfTet()) are worked on
  /// Of tets round them that may change, 1 or more: the first number of them by which something is bettered.
  std::vector<int> rings{ 3, 2 };
  double target = 0.3; ///< of the improvement of what is taken out
  int rounds = 3;      ///< passes over them, 1 or more
};

struct ImproveStuckReport
{
  Id tried = 0;    ///< surroundings that were worked on
  Id bettered = 0; ///< those that became better
};

/// Where ImproveTets() has come to a stop: the surroundings of each tet below the gate are taken out, a point
/// is put into the middle of the tet, of one of its edges or faces, at whatever cost, and all is improved
/// from there; the best outcome is put back if its worst tet is better than what was the worst. What is kept
/// by ImproveTets() stays here, too, but the prisms behind a front are not looked at. Where that is not
/// enough points of layers leave these (their `layerIndex` becomes -1): those of the tet, then all round it
/// that may move.
ImproveStuckReport ImproveStuck(TetSet& set, const ImproveStuckOptions& options, Monitor& monitor);

} // namespace lamina
