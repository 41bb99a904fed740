// SPDX-License-Identifier: BSD-3-Clause
#include "Clearance.h"

#include <algorithm>

namespace lamina
{

namespace
{

double Clamp01(double t)
{
  return std::min(1.0, std::max(0.0, t));
}

} // namespace

std::array<double, 2> SegmentParameters(const Vec3& p, const Vec3& p2, const Vec3& q, const Vec3& q2)
{
  const Vec3 u = p2 - p;
  const Vec3 v = q2 - q;
  const Vec3 w = p - q;
  const double a = Norm2(u);
  const double b = Dot(u, v);
  const double c = Norm2(v);
  const double d = Dot(u, w);
  const double e = Dot(v, w);
  const double det = a * c - b * b;
  double s = det > 1e-14 * a * c ? Clamp01((b * e - c * d) / det) : 0.0;
  double t = c > 0 ? (b * s + e) / c : 0.0;
  if (t < 0 || t > 1)
  {
    t = Clamp01(t);
    s = a > 0 ? Clamp01((b * t - d) / a) : 0.0;
  }
  return { { s, t } };
}

Vec3 SegmentConnection(const Vec3& p, const Vec3& p2, const Vec3& q, const Vec3& q2)
{
  const auto at = SegmentParameters(p, p2, q, q2);
  return p - q + at[0] * (p2 - p) - at[1] * (q2 - q);
}

double TriangleTriangleDistance2(const std::array<Vec3, 3>& s, const std::array<Vec3, 3>& t)
{
  double best = std::numeric_limits<double>::infinity();
  Vec3 closest;
  std::array<double, 3> weights;
  for (std::size_t i = 0; i < 3; ++i)
  {
    best = std::min(best, PointTriangleDistance2(s[i], t[0], t[1], t[2], closest, weights));
    best = std::min(best, PointTriangleDistance2(t[i], s[0], s[1], s[2], closest, weights));
    for (std::size_t j = 0; j < 3; ++j)
    {
      best = std::min(best, Norm2(SegmentConnection(s[i], s[(i + 1) % 3], t[j], t[(j + 1) % 3])));
    }
  }
  return best;
}

double TriangleClearance(const TriangleTree& tree, const std::vector<Vec3>& points,
                         const std::vector<Triangle>& triangles, Id t, double cutoff)
{
  const auto corners = [&](Id id)
  {
    const Triangle& c = triangles[static_cast<std::size_t>(id)];
    return std::array<Vec3, 3>{ { points[static_cast<std::size_t>(c[0])],
                                  points[static_cast<std::size_t>(c[1])],
                                  points[static_cast<std::size_t>(c[2])] } };
  };
  const std::array<Vec3, 3> own = corners(t);
  Box box;
  for (const Vec3& p : own)
  {
    box.Add(p);
  }
  const Box tight = box;
  box.Grow(cutoff);
  double best2 = cutoff * cutoff;
  tree.ForOverlaps(
    box,
    [&](Id other)
    {
      if (ShareCorner(triangles[static_cast<std::size_t>(t)], triangles[static_cast<std::size_t>(other)]))
      {
        return true;
      }
      const std::array<Vec3, 3> theirs = corners(other);
      double gap2 = 0; // of the two boxes, to spare most exact distances
      for (int c = 0; c < 3; ++c)
      {
        const double low = std::min({ theirs[0][c], theirs[1][c], theirs[2][c] });
        const double high = std::max({ theirs[0][c], theirs[1][c], theirs[2][c] });
        const double gap = std::max({ 0.0, low - tight.high[c], tight.low[c] - high });
        gap2 += gap * gap;
      }
      if (gap2 < best2)
      {
        best2 = std::min(best2, TriangleTriangleDistance2(own, theirs));
      }
      return true;
    });
  return std::sqrt(best2);
}

std::vector<double> PointClearances(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                                    double cutoff, Monitor& monitor)
{
  return PointClearances(points, triangles, std::vector<double>(points.size(), cutoff), monitor);
}

std::vector<double> PointClearances(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                                    const std::vector<double>& cutoffs, Monitor& monitor)
{
  const TriangleTree tree(points, triangles);
  std::vector<double> ofTriangle(triangles.size());
  monitor.For(static_cast<Id>(triangles.size()), 512,
              [&](Id begin, Id end)
              {
                for (Id t = begin; t < end; ++t)
                {
                  double cutoff = 0;
                  for (Id p : triangles[static_cast<std::size_t>(t)])
                  {
                    cutoff = std::max(cutoff, cutoffs[static_cast<std::size_t>(p)]);
                  }
                  ofTriangle[static_cast<std::size_t>(t)] =
                    TriangleClearance(tree, points, triangles, t, cutoff);
                }
              });
  std::vector<double> ofPoint = cutoffs;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (Id p : triangles[t])
    {
      double& least = ofPoint[static_cast<std::size_t>(p)];
      least = std::min(least, ofTriangle[t]);
    }
  }
  return ofPoint;
}

} // namespace lamina
