// SPDX-License-Identifier: BSD-3-Clause
// What a smoothed surface promises to the stages after it, measured.
#pragma once

#include "../Base/Monitor.h"
#include "../Mesh/TriangleComplex.h"

namespace lamina
{

struct SurfaceCertificate
{
  Id intersectingPairs = 0; ///< exact
  /// Least distance between triangles that face each other (SheetGaps): one mean edge length if all are
  /// farther apart, 0 if any intersect.
  double leastClearance = 0;
  /// Least angle between triangles that share an edge, inside the material between them, in degrees.
  double leastAngle = 0;
};

/// The same of a surface without intersections.
double LeastClearance(const TriangleComplex& surface, Monitor& monitor);
double LeastAngle(const TriangleComplex& surface);

/// Measure all three. Without two triangles at an edge the angle is 180.
SurfaceCertificate Certify(const TriangleComplex& surface, Monitor& monitor);

} // namespace lamina
