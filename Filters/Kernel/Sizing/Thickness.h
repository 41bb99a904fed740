// SPDX-License-Identifier: BSD-3-Clause
// The thickness of one material under each point of its boundary, by rays into it.
#pragma once

#include "../Base/Monitor.h"
#include "../Mesh/Adjacency.h"

namespace lamina
{

/// The points that touch `material`, ascending.
std::vector<Id> PointsOfMaterial(const TriangleComplex& surface, int material);

/// The thickness of `material` at the points `ids` of its boundary, at most `maximum`. Seven rays go inward,
/// along the angle-weighted normal and at coneAngle (degrees) around it; where one leaves the material, a
/// ball through the place that touches the boundary at the point has the diameter t / cos(angle to the
/// normal). The least diameter counts that does not lie far below the median, where rays graze roughness: it
/// is the wall's thickness in a slab and the diameter of a sphere or a tube. Openings and border planes (any
/// patch but 0) are no walls: a ray that leaves through one does not count, and points of them alone have no
/// rays and get the maximum. `star`: TrianglesOfPoints of the surface.
std::vector<double> MeasureThickness(const TriangleComplex& surface, const Lists& star, int material,
                                     const std::vector<Id>& ids, double maximum, double coneAngle,
                                     Monitor& monitor);

} // namespace lamina
