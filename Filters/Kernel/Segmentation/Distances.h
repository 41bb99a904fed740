// SPDX-License-Identifier: BSD-3-Clause
// Signed distances of simple bodies, negative inside, and smooth ways to join them.
#pragma once

#include "../Base/Types.h"

#include <algorithm>

namespace lamina
{

/// To an ellipsoid with axes along x, y, z: first-order near the surface, of the right sign everywhere.
inline double EllipsoidDistance(const Vec3& p, const Vec3& centre, const Vec3& radii)
{
  const Vec3 q = p - centre;
  const double k0 = Norm({ q.x / radii.x, q.y / radii.y, q.z / radii.z });
  const double k1 = Norm({ q.x / (radii.x * radii.x), q.y / (radii.y * radii.y), q.z / (radii.z * radii.z) });
  return k1 > 0 ? k0 * (k0 - 1) / k1 : -std::min({ radii.x, radii.y, radii.z });
}

/// To a rod from a to b whose radius goes linearly from ra to rb.
inline double RodDistance(const Vec3& p, const Vec3& a, const Vec3& b, double ra, double rb)
{
  const Vec3 axis = b - a;
  const double t = std::min(1.0, std::max(0.0, Dot(p - a, axis) / std::max(Norm2(axis), 1e-12)));
  return Norm(p - a - axis * t) - (ra + t * (rb - ra));
}

/// The lesser of two distances, rounded over the width k where they are alike. Never above the lesser.
inline double SmoothLesser(double a, double b, double k)
{
  const double h = std::max(k - std::abs(a - b), 0.0) / k;
  return std::min(a, b) - 0.25 * h * h * k;
}

inline double SmoothGreater(double a, double b, double k)
{
  return -SmoothLesser(-a, -b, k);
}

/// 0 below `from`, 1 above `to`, smooth between.
inline double SmoothStep(double from, double to, double x)
{
  const double t = std::min(1.0, std::max(0.0, (x - from) / (to - from)));
  return t * t * (3 - 2 * t);
}

} // namespace lamina
