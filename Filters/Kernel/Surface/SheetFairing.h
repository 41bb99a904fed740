// SPDX-License-Identifier: BSD-3-Clause
// Long waves of a surface levelled in one step.
#pragma once

#include "../Base/Monitor.h"
#include "SmoothingState.h"

#include <functional>

namespace lamina
{

/// The cotangent Laplacian of a surface as it is now, and two linear problems on it, solved by conjugate
/// gradients without a matrix of the second. Sums are taken in blocks, so that threads make no difference.
class SheetFairing
{
public:
  /// state: outlives this.
  SheetFairing(const SmoothingState& state, Monitor& monitor);

  /// Offsets of the points along `normals` (unit) that make the mean curvature vary least: they minimise
  /// d' M d + (wavelength / 2 pi)^4 H' M H, with H the mean curvature after the move, linearised (implicit
  /// fairing as in M. Desbrun, M. Meyer, P. Schroeder and A. H. Barr, SIGGRAPH 1999, with the square of the
  /// Laplacian), and M the area around each point. Waves much longer than `wavelength` stay, shorter ones go;
  /// where the mean curvature is constant nothing moves. If all points of a closed sheet are free the offsets
  /// add up to no volume, to first order. Points with `free` 0 stay.
  std::vector<double> Offsets(const std::vector<Vec3>& normals, const std::vector<char>& free,
                              double wavelength) const;

  /// Offsets that hold the given volumes, one a point, spread over about `distance`.
  std::vector<double> Spread(const std::vector<double>& volumes, const std::vector<char>& free,
                             double distance) const;

  /// A third of the area of the triangles around a point.
  double AreaOf(Id p) const { return this->Area[static_cast<std::size_t>(p)]; }

private:
  using Vector = std::vector<double>;
  using Apply = std::function<void(const Vector& x, Vector& y)>;

  void FillRow(Id p);
  template<typename Visit>
  void ForPoints(const Visit& visit) const;
  template<typename Term>
  double Sum(const Term& term) const;
  /// minus the integral of the Laplacian of x around point p
  double Stiff(const Vector& x, std::size_t p) const;
  Vector Solve(const Apply& apply, const Vector& diagonal, const Vector& right) const;

  const SmoothingState& State;
  Monitor& Watch;
  Vector Beside;   ///< entries of the stiffness matrix beside the diagonal, in the order of the rings
  Vector Diagonal; ///< of the stiffness matrix
  Vector Area;
};

} // namespace lamina
