// SPDX-License-Identifier: BSD-3-Clause
// How much longer edges may be along a surface's direction of least curvature.
#pragma once

#include "../Base/Monitor.h"
#include "../Mesh/Adjacency.h"

namespace lamina
{

/// The metric of edges at a point: across `Stretch` a length counts as it is, along it less. The vector
/// points along the longer edges, either way; its length is sqrt(1 - 1 / ratio^2). Zero: all directions are
/// alike.
using Stretch = Vec3;

/// The squared length of edge e where the ends have stretches s and t.
inline double StretchedLength2(const Vec3& e, const Stretch& s, const Stretch& t)
{
  const double a = Dot(e, s);
  const double b = Dot(e, t);
  return Norm2(e) - 0.5 * (a * a + b * b);
}

/// Three stretches in one, whichever way they point.
Stretch MeanStretch(const Stretch& a, const Stretch& b, const Stretch& c);

/// The offset v as it looks where long edges count as short ones.
inline Vec3 Unstretched(const Vec3& v, const Stretch& s)
{
  const double s2 = Norm2(s);
  return s2 > 0 ? v - ((1 - std::sqrt(1 - s2)) * Dot(v, s) / s2) * s : v;
}

/// One stretch a point from the surface's curvatures and target lengths. The ratio is that at which an edge
/// along the least curvature rises over the surface as much as one across, at most `most`; where the surface
/// hardly bends within a target length there is none, as its directions are noise. Ratios and directions are
/// averaged over neighbours.
std::vector<Stretch> FindStretches(const TriangleComplex& surface, double most, Monitor& monitor);

} // namespace lamina
