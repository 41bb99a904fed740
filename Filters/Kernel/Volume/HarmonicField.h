// SPDX-License-Identifier: BSD-3-Clause
// Laplace's equation on the cells of a mesh by linear finite elements.
#pragma once

#include "../Base/ConjugateGradients.h"
#include "../Base/Result.h"
#include "../Mesh/VolumeMesh.h"

#include <optional>

namespace lamina
{

using HarmonicReport = ConjugateGradientsReport;

/// `values` holds one value a point, those of `known` points are kept, the others on `cells` become harmonic;
/// no flux passes where nothing is known. Every piece of the cells must have a known point. By conjugate
/// gradients, down to a residual of 1e-8 of the first.
Result<HarmonicReport> SolveHarmonic(const VolumeMesh& mesh, const std::vector<Id>& cells,
                                     const std::vector<char>& known, std::vector<double>& values,
                                     Monitor& monitor);

/// An error where the steps did not come near enough.
std::optional<Error> CheckSolved(const HarmonicReport& report);

} // namespace lamina
