// SPDX-License-Identifier: BSD-3-Clause
#include "Predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Intersections_3/Segment_3_Triangle_3.h>
#include <CGAL/Intersections_3/Triangle_3_Triangle_3.h>

#include <algorithm>

namespace lamina
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Corners = std::array<Vec3, 3>;

Kernel::Point_3 ToKernel(const Vec3& p)
{
  return { p.x, p.y, p.z };
}

Kernel::Triangle_3 ToKernel(const Corners& t)
{
  return { ToKernel(t[0]), ToKernel(t[1]), ToKernel(t[2]) };
}

bool IsCollinear(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Vec3 u = b - a;
  const Vec3 v = c - a;
  // Far from zero the rounded cross product decides; a component's error is below 8 units in the last place
  // of its terms.
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const double p = u[j] * v[k];
    const double q = u[k] * v[j];
    if (std::abs(p - q) > 2e-15 * (std::abs(p) + std::abs(q)) && std::abs(p) + std::abs(q) > 1e-250)
    {
      return false;
    }
  }
  return CGAL::collinear(ToKernel(a), ToKernel(b), ToKernel(c));
}

bool IsCollinear(const Corners& t)
{
  return IsCollinear(t[0], t[1], t[2]);
}

/// True if the bounding boxes of the point sets are apart.
template<std::size_t N, std::size_t M>
bool AreApart(const std::array<Vec3, N>& s, const std::array<Vec3, M>& t)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto less = [axis](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; };
    const auto [sLow, sHigh] = std::minmax_element(s.begin(), s.end(), less);
    const auto [tLow, tHigh] = std::minmax_element(t.begin(), t.end(), less);
    if ((*sHigh)[axis] < (*tLow)[axis] || (*tHigh)[axis] < (*sLow)[axis])
    {
      return true;
    }
  }
  return false;
}

/// True if all of `set` lies strictly on one side of triangle t's plane.
template<std::size_t N>
bool IsOnOneSide(const std::array<Vec3, N>& set, const Corners& t)
{
  const int first = Orientation(t[0], t[1], t[2], set[0]);
  return first != 0 && std::all_of(set.begin() + 1, set.end(),
                                   [&](const Vec3& p) { return Orientation(t[0], t[1], t[2], p) == first; });
}

/// Both proper (not collinear).
bool ProperTrianglesTouch(const Corners& s, const Corners& t)
{
  return !AreApart(s, t) && !IsOnOneSide(s, t) && !IsOnOneSide(t, s) &&
         CGAL::do_intersect(ToKernel(s), ToKernel(t));
}

/// t proper.
bool SegmentTouches(const Vec3& p, const Vec3& q, const Corners& t)
{
  const std::array<Vec3, 2> segment{ { p, q } };
  if (AreApart(segment, t) || IsOnOneSide(segment, t))
  {
    return false;
  }
  if (p == q)
  {
    // A point: it is in the plane, and it is in the triangle if it makes a degenerate touching triangle of
    // any kind.
    return Kernel::Triangle_3(ToKernel(t)).has_on(ToKernel(p));
  }
  return CGAL::do_intersect(Kernel::Segment_3(ToKernel(p), ToKernel(q)), ToKernel(t));
}

/// True if a plane through the common corner s[0] = t[0] parts the other corners of s from those of t, beyond
/// doubt.
bool ArePartedAtCorner(const Corners& s, const Corners& t)
{
  const Vec3 a = s[1] - s[0];
  const Vec3 b = s[2] - s[0];
  const Vec3 c = t[1] - t[0];
  const Vec3 d = t[2] - t[0];
  const auto sum = [](const Vec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); };
  // Differences are exact to half a unit in the last place, products of them to a few: this is far above.
  const double unsure = 1e-14 * (sum(a) + sum(b) + sum(c) + sum(d));
  const auto parts = [&](const Vec3& normal)
  {
    const double least = unsure * sum(normal);
    return Dot(a, normal) > least && Dot(b, normal) > least && Dot(c, normal) < -least &&
           Dot(d, normal) < -least;
  };
  // The normal of the plane: from the middle of one cone to that of the other, or about so.
  return parts((a + b) - (c + d)) ||
         parts(Normalized(Normalized(a) + Normalized(b)) - Normalized(Normalized(c) + Normalized(d)));
}

/// The corners of s, those that t has too before the others; returns how many t has.
std::size_t SharedFirst(const std::vector<Vec3>& points, const Triangle& s, const Triangle& t,
                        Corners& corners)
{
  std::size_t first = 0;
  std::size_t last = 0;
  Triangle others;
  for (Id p : s)
  {
    if (p == t[0] || p == t[1] || p == t[2])
    {
      corners[first++] = points[static_cast<std::size_t>(p)];
    }
    else
    {
      others[last++] = p;
    }
  }
  for (std::size_t i = 0; i < last; ++i)
  {
    corners[first + i] = points[static_cast<std::size_t>(others[i])];
  }
  return first;
}

} // namespace

int Orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  const Vec3 u = b - a;
  const Vec3 v = c - a;
  const Vec3 w = d - a;
  const double xy = u.x * v.y;
  const double yx = u.y * v.x;
  const double yz = u.y * v.z;
  const double zy = u.z * v.y;
  const double zx = u.z * v.x;
  const double xz = u.x * v.z;
  const double det = w.x * (yz - zy) + w.y * (zx - xz) + w.z * (xy - yx);
  const double size = std::abs(w.x) * (std::abs(yz) + std::abs(zy)) +
                      std::abs(w.y) * (std::abs(zx) + std::abs(xz)) +
                      std::abs(w.z) * (std::abs(xy) + std::abs(yx));
  // The classic forward bound is 7 half-ulps (7.8e-16) of `size`; near underflow it does not hold.
  if (std::abs(det) > 1e-15 * size && size > 1e-250)
  {
    return det > 0 ? 1 : -1;
  }
  return static_cast<int>(CGAL::orientation(ToKernel(a), ToKernel(b), ToKernel(c), ToKernel(d)));
}

bool TrianglesTouch(const Vec3& a0, const Vec3& a1, const Vec3& a2, const Vec3& b0, const Vec3& b1,
                    const Vec3& b2)
{
  const Corners s{ { a0, a1, a2 } };
  const Corners t{ { b0, b1, b2 } };
  return !AreApart(s, t) && (IsCollinear(s) || IsCollinear(t) || ProperTrianglesTouch(s, t));
}

bool SegmentTouchesTriangle(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Corners t{ { a, b, c } };
  return !AreApart(std::array<Vec3, 2>{ { p, q } }, t) && (IsCollinear(t) || SegmentTouches(p, q, t));
}

bool TrianglesIntersect(const std::vector<Vec3>& points, const Triangle& s, const Triangle& t)
{
  // Shared corners first, the others behind them.
  Corners p;
  Corners q;
  const std::size_t shared = SharedFirst(points, s, t, p);
  SharedFirst(points, t, s, q);
  if (shared == 0 && AreApart(p, q))
  {
    return false;
  }
  if (shared == 1 && ArePartedAtCorner(p, q))
  {
    return false;
  }
  if (shared == 3 || IsCollinear(p) || IsCollinear(q))
  {
    return true;
  }
  if (shared == 0)
  {
    return ProperTrianglesTouch(p, q);
  }
  if (shared == 1)
  {
    // Two triangles that meet in their corner and elsewhere meet on the way from the corner to the nearer
    // opposite edge.
    return SegmentTouches(p[1], p[2], q) || SegmentTouches(q[1], q[2], p);
  }
  // The shared edge may be listed in either sense: go by p's, q[2] is the other apex all the same.
  return Orientation(p[0], p[1], p[2], q[2]) == 0 &&
         CGAL::coplanar_orientation(ToKernel(p[0]), ToKernel(p[1]), ToKernel(p[2]), ToKernel(q[2])) ==
           CGAL::POSITIVE;
}

} // namespace lamina
