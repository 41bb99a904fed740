// SPDX-License-Identifier: BSD-3-Clause
// How near the parts of a surface stand to each other.
#pragma once

#include "../Base/Monitor.h"
#include "../Mesh/Adjacency.h"
#include "../Mesh/TriangleComplex.h"

namespace lamina
{

/// Least distances, at most the cutoff they were measured with.
struct SheetGaps
{
  /// Of the triangles at a point to any triangle without a common corner. If every point stays within less
  /// than half of its value, no two such triangles can meet.
  std::vector<double> any;
  /// The same to triangles that face them: the shortest connection leaves both by more than 45 degrees. So do
  /// two sheets, or the sides of a strand; triangles side by side on a sheet do not.
  std::vector<double> facing;
};

/// Measure around every point. table and star belong to `triangles`.
SheetGaps MeasureGaps(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                      const EdgeTable& table, const Lists& star, double cutoff, Monitor& monitor);

/// Per point the least gap of a surface whose sheets may meet at sharp curves: as `facing`, but only to
/// triangles that see these through one material and are not joined to them by a short way (Facing.h); at
/// most its reach.
std::vector<double> MeasureTrueGaps(const TriangleComplex& surface, const EdgeTable& table, const Lists& star,
                                    const std::vector<double>& reaches, Monitor& monitor);

} // namespace lamina
