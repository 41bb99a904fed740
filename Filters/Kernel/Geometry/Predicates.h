// SPDX-License-Identifier: BSD-3-Clause
// Exact predicates (CGAL's filtered kernel): the only place where decisions about signs are made.
// All coordinates must be finite. A triangle without area touches whatever its bounding box touches: the
// answers err on the side of trouble.
#pragma once

#include "../Base/Types.h"

namespace lamina
{

/// Sign of the volume of tetrahedron (a, b, c, d): +1 if d lies on the side the normal of (a, b, c) points
/// to.
int Orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// True if the closed triangles (a0, a1, a2) and (b0, b1, b2) have a point in common.
bool TrianglesTouch(const Vec3& a0, const Vec3& a1, const Vec3& a2, const Vec3& b0, const Vec3& b1,
                    const Vec3& b2);

/// True if the closed segment (p, q) and the closed triangle (a, b, c) have a point in common.
bool SegmentTouchesTriangle(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c);

/// True if triangles s and t of one complex meet anywhere but in the corners and edge that they share.
bool TrianglesIntersect(const std::vector<Vec3>& points, const Triangle& s, const Triangle& t);

} // namespace lamina
