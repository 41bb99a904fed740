// SPDX-License-Identifier: BSD-3-Clause
// Faces that finite volumes dislike, made better after the tetrahedra are.
#pragma once

#include "ImproveTets.h"

namespace lamina
{

struct ImproveFacesOptions
{
  /// Faces beyond this share of the limits (85 degrees of non-orthogonality, a skewness of 4) are worked on.
  double share = 0.94;
  double enough = 0.22; ///< 3r/R (or what counts so) that tets may sink to for them; worse ones do not sink
  int rounds = 4;       ///< passes over them, 1 or more
};

struct ImproveFacesReport
{
  Id found = 0;     ///< tets with such a face before
  Id left = 0;      ///< and after
  double worst = 0; ///< the worst face's share of the limits
};

/// Flips and moves that lower the worst face of all that they touch, between two tets of a group or a tet and
/// the prism behind (FaceExcess()). No tet becomes worse than it was and than `enough`. Stops early, with a
/// sound mesh, when cancelled.
ImproveFacesReport ImproveFaces(TetSet& set, const ImproveFacesOptions& options, Monitor& monitor);

} // namespace lamina
