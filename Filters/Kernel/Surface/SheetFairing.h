// SPDX-License-Identifier: BSD-3-Clause
// Long waves of a surface levelled in one step.
#pragma once

#include "../Mesh/Adjacency.h"

#include <memory>

namespace lamina
{

/// The cotangent Laplacian of a surface as it is now, and two linear problems on it.
class SheetFairing
{
public:
  explicit SheetFairing(const TriangleComplex& surface);
  ~SheetFairing();

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
  double AreaOf(Id p) const;

private:
  struct System;

  const TriangleComplex& Surface;
  std::unique_ptr<System> Parts;
};

} // namespace lamina
