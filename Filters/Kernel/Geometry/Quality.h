// SPDX-License-Identifier: BSD-3-Clause
// Every measure of shape and validity, defined once.
#pragma once

#include "../Base/Types.h"

namespace lamina
{

/// 2 r/R of a triangle: 1 equilateral, 0 degenerate.
double TriangleQuality(const Vec3& a, const Vec3& b, const Vec3& c);
/// Signed volume; positive if d lies on the side the normal of (a, b, c) points to (VTK's order).
double TetVolume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
/// 3 r/R: 1 regular, 0 degenerate; negative for an inverted tet.
double TetQuality(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
/// The least sine of the six dihedral angles: 0.94 regular, small for angles near 0 and near 180 degrees;
/// negative for an inverted tet.
double TetLeastSine(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
/// Least and largest dihedral angle, degrees.
std::array<double, 2> TetDihedralAngles(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The nine Bernstein coefficients of the Jacobian of the isoparametric wedge in VTK's order (base normal
/// outwards), signed so that a valid wedge has positive ones: value [k][i], k degree along the height, i side
/// edge.
std::array<std::array<double, 3>, 3> WedgeJacobian(const std::array<Vec3, 6>& nodes);
/// Exact for the isoparametric cell: the Jacobian is positive everywhere, corners and edges included.
bool WedgeIsValid(const std::array<Vec3, 6>& nodes);
/// Every tet of every split of the wedge by diagonals of its sides is positive.
bool WedgeSplitsAreValid(const std::array<Vec3, 6>& nodes);
/// Volume of the isoparametric wedge.
double WedgeVolume(const std::array<Vec3, 6>& nodes);
/// The smaller of (triangle quality times edge orthogonality) and the scaled Jacobian normalised to 1 for a
/// right equilateral prism; not positive for an invalid one.
double WedgeQuality(const std::array<Vec3, 6>& nodes);

/// The Jacobian of the isoparametric pyramid is positive everywhere but at the apex.
bool PyramidIsValid(const std::array<Vec3, 5>& nodes);
/// Volume of the isoparametric pyramid (bilinear base).
double PyramidVolume(const std::array<Vec3, 5>& nodes);
/// 3 r/R of the worst tet of its better split by a diagonal of the base; not positive for an invalid one.
double PyramidQuality(const std::array<Vec3, 5>& nodes);

/// Of a face between two cells, as OpenFOAM measures them (its owner's centre is `near`). Degrees between the
/// face's normal and the line of the cells' centres, at most 90.
double FaceNonOrthogonality(const std::array<Vec3, 3>& face, const Vec3& near, const Vec3& far);
/// How far that line misses the face's centre, over the greater of a fifth of the centres' distance and the
/// face's extent in that direction; infinite where the line lies in the face's plane.
double FaceSkewness(const std::array<Vec3, 3>& face, const Vec3& near, const Vec3& far);

} // namespace lamina
