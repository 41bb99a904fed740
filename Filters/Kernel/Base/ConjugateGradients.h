// SPDX-License-Identifier: BSD-3-Clause
// Symmetric positive systems of equations, solved step by step.
#pragma once

#include "Monitor.h"

#include <functional>
#include <vector>

namespace lamina
{

struct LinearSystem
{
  using Vector = std::vector<double>;

  std::function<void(const Vector& x, Vector& y)> multiply; ///< y = matrix times x
  const Vector& diagonal;                                   ///< of the matrix
  const Vector& right;
};

struct ConjugateGradientsOptions
{
  double tolerance = 1e-8; ///< residual over that of the start, in the preconditioner's norm
  int mostIterations = 20000;
  const char* stage = "Solving"; ///< for the monitor
};

struct ConjugateGradientsReport
{
  int iterations = 0;
  double residual = 0; ///< over that of the start
};

/// Conjugate gradients (M. R. Hestenes, E. Stiefel, Journal of Research of the National Bureau of Standards
/// 49, 1952) from x on, preconditioned by the diagonal. Sums are taken in blocks, so that threads make no
/// difference. Stops early if cancelled.
ConjugateGradientsReport ConjugateGradients(const LinearSystem& system,
                                            const ConjugateGradientsOptions& options, std::vector<double>& x,
                                            Monitor& monitor);

} // namespace lamina
