// SPDX-License-Identifier: BSD-3-Clause
#include "VisibleDirection.h"

#include <algorithm>
#include <limits>

namespace lamina
{

namespace
{

constexpr double slack = 1e-12; ///< on cosines, so that normals on the cone count as inside

VisibleDirection OfTwo(const Vec3& a, const Vec3& b)
{
  const Vec3 m = Normalized(a + b);
  return { m, std::min(Dot(m, a), Dot(m, b)) };
}

VisibleDirection OfThree(const Vec3& a, const Vec3& b, const Vec3& c)
{
  // The axis has equal dot products with all three: it stands on the plane of their tips.
  Vec3 m = Normalized(Cross(b - a, c - a));
  if (Norm2(m) == 0)
  {
    return OfTwo(a, b);
  }
  if (Dot(m, a) < 0)
  {
    m = -m;
  }
  return { m, std::min({ Dot(m, a), Dot(m, b), Dot(m, c) }) };
}

} // namespace

VisibleDirection FindVisibleDirection(const std::vector<Vec3>& n)
{
  if (n.empty())
  {
    return {};
  }
  VisibleDirection best{ n[0], 1 };
  const auto outside = [&best](const Vec3& v) { return Dot(best.direction, v) < best.leastCosine - slack; };
  for (std::size_t i = 1; i < n.size(); ++i)
  {
    if (!outside(n[i]))
    {
      continue;
    }
    best = { n[i], 1 };
    for (std::size_t j = 0; j < i; ++j)
    {
      if (!outside(n[j]))
      {
        continue;
      }
      best = OfTwo(n[i], n[j]);
      for (std::size_t k = 0; k < j; ++k)
      {
        if (outside(n[k]))
        {
          best = OfThree(n[i], n[j], n[k]);
        }
      }
    }
  }
  // Beyond a half-space the construction means nothing: say what the direction really sees.
  double least = 1;
  for (const Vec3& v : n)
  {
    least = std::min(least, Dot(best.direction, v));
  }
  best.leastCosine = least;
  return best;
}

VisibleDirection FindWeightedDirection(const std::vector<Vec3>& a)
{
  // The best direction points to the point nearest to the origin of the vectors' convex hull, which lies on a
  // corner, an edge or a face of it.
  VisibleDirection best;
  const auto attempt = [&](const Vec3& towards)
  {
    const Vec3 m = Normalized(towards);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < a.size() && least > best.leastCosine; ++i)
    {
      least = std::min(least, Dot(m, a[i]));
    }
    if (least > best.leastCosine && Norm2(m) > 0)
    {
      best = { m, least };
    }
  };
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    attempt(a[i]);
    for (std::size_t j = 0; j < i; ++j)
    {
      const Vec3 side = a[j] - a[i];
      const double length2 = Norm2(side);
      attempt(length2 > 0 ? a[i] - (Dot(a[i], side) / length2) * side : a[i]);
      for (std::size_t k = 0; k < j; ++k)
      {
        const Vec3 normal = Cross(side, a[k] - a[i]);
        attempt(Dot(normal, a[i]) < 0 ? -1.0 * normal : normal);
      }
    }
  }
  return best;
}

} // namespace lamina
