// SPDX-License-Identifier: BSD-3-Clause
// How far the points of a surface may move before parts of it that share no corner could meet.
#pragma once

#include "../Base/Monitor.h"
#include "TriangleTree.h"

namespace lamina
{

/// The shortest connection of segments (p, p2) and (q, q2), towards the first.
Vec3 SegmentConnection(const Vec3& p, const Vec3& p2, const Vec3& q, const Vec3& q2);

/// Squared distance of two triangles that do not intersect.
double TriangleTriangleDistance2(const std::array<Vec3, 3>& s, const std::array<Vec3, 3>& t);

/// Distance of triangle t to the nearest one of the tree without a common corner, at most `cutoff`.
double TriangleClearance(const TriangleTree& tree, const std::vector<Vec3>& points,
                         const std::vector<Triangle>& triangles, Id t, double cutoff);

/// Per point the least distance of its triangles to any triangle without a common corner, at most `cutoff`.
/// If every point stays within less than half of its value, no two such triangles can meet.
std::vector<double> PointClearances(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                                    double cutoff, Monitor& monitor);
/// The same with a cutoff for every point; a triangle takes the largest of its corners'.
std::vector<double> PointClearances(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                                    const std::vector<double>& cutoffs, Monitor& monitor);

} // namespace lamina
