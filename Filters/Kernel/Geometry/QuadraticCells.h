// SPDX-License-Identifier: BSD-3-Clause
// The Jacobian of cells with midside nodes.
#pragma once

#include "../Base/Types.h"

namespace lamina
{

/// The Bernstein coefficients of the Jacobian of the ten-node tetrahedron in VTK's node order (corners, then
/// the middles of 01 12 20 03 13 23): a polynomial of degree 3, 20 coefficients, in units of six volumes.
std::array<double, 20> QuadraticTetJacobian(const std::array<Vec3, 10>& nodes);
/// All coefficients are positive, which proves that the Jacobian is positive in the whole cell.
bool QuadraticTetIsValid(const std::array<Vec3, 10>& nodes);

/// The Jacobian of the fifteen-node wedge in VTK's node order (normal of 0, 1, 2 outwards; middles of 01 12
/// 20 34 45 53 03 14 25), signed so that a valid one has positive values, at r, s in the triangle and t in
/// [0, 1].
double QuadraticWedgeJacobian(const std::array<Vec3, 15>& nodes, double r, double s, double t);
/// The Bernstein coefficients of that polynomial, of degree 4 in the triangle and 5 in t, are all positive.
bool QuadraticWedgeIsValid(const std::array<Vec3, 15>& nodes);

} // namespace lamina
