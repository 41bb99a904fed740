// SPDX-License-Identifier: BSD-3-Clause
// Laplace's equation on the cells of a mesh by quadratic finite elements.
#pragma once

#include "HarmonicField.h"

namespace lamina
{

/// As SolveHarmonic, but with a value on every edge beside those on the points, so that the error of a smooth
/// solution falls with the cube of the cells' size. `values` are where the steps start, best the linear
/// solution, and the result on the points. Edges of `walls`, triangles whose points are known, are known as
/// the means of their ends.
Result<HarmonicReport> SolveQuadraticHarmonic(const VolumeMesh& mesh, const std::vector<Id>& cells,
                                              const std::vector<char>& known,
                                              const std::vector<Triangle>& walls, std::vector<double>& values,
                                              Monitor& monitor);

} // namespace lamina
