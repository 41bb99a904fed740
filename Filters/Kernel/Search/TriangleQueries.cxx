// SPDX-License-Identifier: BSD-3-Clause
// A point's and a ray's way to one triangle.
#include "TriangleTree.h"

namespace lamina
{
namespace
{

/// Parameter in [0, 1] of the point of segment (a, b) closest to p.
double ClosestOnSegment(const Vec3& p, const Vec3& a, const Vec3& b)
{
  const Vec3 edge = b - a;
  const double length2 = Norm2(edge);
  return length2 > 0 ? std::clamp(Dot(p - a, edge) / length2, 0.0, 1.0) : 0.0;
}

} // namespace

double PointTriangleDistance2(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, Vec3& closest,
                              std::array<double, 3>& weights)
{
  const Vec3 n = Cross(b - a, c - a);
  const double area2 = Norm2(n);
  if (area2 > 0)
  {
    const double wa = Dot(Cross(c - b, p - b), n) / area2;
    const double wb = Dot(Cross(a - c, p - c), n) / area2;
    const double wc = 1 - wa - wb;
    if (wa >= 0 && wb >= 0 && wc >= 0)
    {
      weights = { { wa, wb, wc } };
      closest = wa * a + wb * b + wc * c;
      return Norm2(p - closest);
    }
  }
  // Outside the prism over the triangle: the nearest of the three edges.
  const std::array<const Vec3*, 3> corners{ { &a, &b, &c } };
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t j = (i + 1) % 3;
    const double t = ClosestOnSegment(p, *corners[i], *corners[j]);
    const Vec3 q = t < 1 ? *corners[i] + t * (*corners[j] - *corners[i]) : *corners[j];
    const double d2 = Norm2(p - q);
    if (d2 < best)
    {
      best = d2;
      closest = q;
      weights = { { 0, 0, 0 } };
      weights[i] = 1 - t;
      weights[j] = t;
    }
  }
  return best;
}

double RayTriangle(const Vec3& origin, const Vec3& direction, const Vec3& a, const Vec3& b, const Vec3& c)
{
  // Rounding must not let a ray through between two triangles: each is taken a trifle larger than it is.
  constexpr double slack = 1e-12;
  const double miss = std::numeric_limits<double>::quiet_NaN();
  const Vec3 u = b - a;
  const Vec3 v = c - a;
  const Vec3 h = Cross(direction, v);
  const double det = Dot(u, h);
  if (det == 0)
  {
    return miss;
  }
  const Vec3 s = origin - a;
  const Vec3 q = Cross(s, u);
  const double beta = Dot(s, h) / det;
  const double gamma = Dot(direction, q) / det;
  return beta >= -slack && gamma >= -slack && beta + gamma <= 1 + slack ? Dot(v, q) / det : miss;
}

} // namespace lamina
