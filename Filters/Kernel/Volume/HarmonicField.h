// SPDX-License-Identifier: BSD-3-Clause
// Laplace's equation on the cells of a mesh by linear finite elements.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "../Mesh/VolumeMesh.h"

namespace lamina
{

struct HarmonicReport
{
  int iterations = 0;
  double residual = 0; ///< over that of the start
};

/// `values` holds one value a point, those of `known` points are kept, the others on `cells` become harmonic;
/// no flux passes where nothing is known. Every piece of the cells must have a known point. By conjugate
/// gradients (M. R. Hestenes, E. Stiefel, Journal of Research of the National Bureau of Standards 49, 1952),
/// preconditioned by the diagonal, down to a residual of 1e-8 of the first.
Result<HarmonicReport> SolveHarmonic(const VolumeMesh& mesh, const std::vector<Id>& cells,
                                     const std::vector<char>& known, std::vector<double>& values,
                                     Monitor& monitor);

} // namespace lamina
