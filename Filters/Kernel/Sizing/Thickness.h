// SPDX-License-Identifier: BSD-3-Clause
// The thickness of one material under each point of its boundary, by rays into it.
#pragma once

#include "../Base/Monitor.h"
#include "../Mesh/TriangleComplex.h"

namespace lamina
{

/// The triangles around each point: those of p are triangles[start[p]] to triangles[start[p + 1] - 1].
struct TrianglesAround
{
  std::vector<std::size_t> start;
  std::vector<Id> triangles;
};
TrianglesAround FindTrianglesAround(const TriangleComplex& surface);

/// The points that touch `material`, ascending.
std::vector<Id> PointsOfMaterial(const TriangleComplex& surface, int material);

/// The thickness of `material` at the points `ids` of its boundary, at most `maximum`. Seven rays go inward,
/// along the angle-weighted normal and at coneAngle (degrees) around it; where one leaves the material, a
/// ball through the place that touches the boundary at the point has the diameter t / cos(angle to the
/// normal). The least diameter counts: it is the wall's thickness in a slab and the diameter of a sphere or a
/// tube, and as each is bounded by a real wall, too small a value costs some cells where too large a one
/// would cost layers. Openings are no walls.
std::vector<double> MeasureThickness(const TriangleComplex& surface, const TrianglesAround& around,
                                     int material, const std::vector<Id>& ids, double maximum,
                                     double coneAngle, Monitor& monitor);

} // namespace lamina
