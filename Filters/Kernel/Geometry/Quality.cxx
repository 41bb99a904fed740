// SPDX-License-Identifier: BSD-3-Clause
#include "Quality.h"

#include <algorithm>
#include <limits>

namespace lamina
{
namespace
{

constexpr double DegreesPerRadian = 57.295779513082320877;
constexpr double TwoOverSqrt3 = 1.1547005383792515290;

double Determinant(const Vec3& a, const Vec3& b, const Vec3& c)
{
  return Dot(Cross(a, b), c);
}

/// Cosine of the angle between two vectors, 0 if one has no length.
double Cosine(const Vec3& a, const Vec3& b)
{
  const double norms = Norm(a) * Norm(b);
  return norms > 0 ? Dot(a, b) / norms : 0;
}

/// Least cosine between a side edge and the inward normals of the two triangles.
double LeastOrthogonality(const std::array<Vec3, 6>& p)
{
  const Vec3 bottom = Cross(p[2] - p[0], p[1] - p[0]);
  const Vec3 top = Cross(p[5] - p[3], p[4] - p[3]);
  double least = 1;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Vec3 side = p[i + 3] - p[i];
    least = std::min({ least, Cosine(side, bottom), Cosine(side, top) });
  }
  return least;
}

/// Least over the corners of the Jacobian of unit edge vectors, 1 for a right equilateral prism.
double ScaledJacobian(const std::array<Vec3, 6>& p)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 6; ++i)
  {
    const std::size_t base = i < 3 ? 0 : 3;
    const std::size_t k = i - base;
    const Vec3 next = Normalized(p[base + (k + 1) % 3] - p[i]);
    const Vec3 previous = Normalized(p[base + (k + 2) % 3] - p[i]);
    const Vec3 side = Normalized(p[k + 3] - p[k]);
    least = std::min(least, Determinant(previous, next, side));
  }
  return TwoOverSqrt3 * least;
}

/// The Jacobian of the map (1-z) * Q(u, v) + z * apex, Q the bilinear base, is (1-z)^2 g(u, v). The terms of
/// g in u^2 v and u v^2 are determinants with a repeated column, so g is bilinear and lies between its values
/// at the corners: the determinant of the two base edges and the edge to the apex there.
std::array<double, 4> PyramidJacobian(const std::array<Vec3, 5>& p)
{
  std::array<double, 4> g;
  for (std::size_t i = 0; i < 4; ++i)
  {
    g[i] = Determinant(p[(i + 1) % 4] - p[i], p[(i + 3) % 4] - p[i], p[4] - p[i]);
  }
  return g;
}

} // namespace

double TriangleQuality(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const double u = Norm(b - a);
  const double v = Norm(c - b);
  const double w = Norm(a - c);
  const double product = (u + v + w) * u * v * w;
  // 2 r/R = 16 A^2 / ((u + v + w) u v w), and the cross product is 2 A.
  return product > 0 ? 4 * Norm2(Cross(b - a, c - a)) / product : 0;
}

double TetVolume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  return Determinant(b - a, c - a, d - a) / 6;
}

double TetQuality(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  const Vec3 u = b - a;
  const Vec3 v = c - a;
  const Vec3 w = d - a;
  const Vec3 uv = Cross(u, v);
  const Vec3 vw = Cross(v, w);
  const Vec3 wu = Cross(w, u);
  const double det = Dot(uv, w);
  // r = 3 V / surface; R = |u^2 (v x w) + v^2 (w x u) + w^2 (u x v)| / (12 V); det = 6 V.
  const double twiceSurface = Norm(uv) + Norm(vw) + Norm(wu) + Norm(uv + vw + wu);
  const double radius = Norm(Norm2(u) * vw + Norm2(v) * wu + Norm2(w) * uv);
  const double product = twiceSurface * radius;
  return product > 0 ? 6 * det * std::abs(det) / product : 0;
}

double TetLeastSine(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  // With a volume V, faces A and B at an edge l: sin = 3 V l / (2 A B).
  const Vec3 u = b - a;
  const Vec3 v = c - a;
  const Vec3 w = d - a;
  const Vec3 uv = Cross(u, v);
  const Vec3 vw = Cross(v, w);
  const Vec3 wu = Cross(w, u);
  const double det = Dot(uv, w);
  // Squares of twice the faces opposite to d, b, c and a.
  const double sd = Norm2(uv);
  const double sb = Norm2(vw);
  const double sc = Norm2(wu);
  const double sa = Norm2(uv + vw + wu);
  if (!(sa * sb * sc * sd > 0))
  {
    return 0;
  }
  const double least =
    std::min({ Norm2(u) / (sc * sd), Norm2(v) / (sb * sd), Norm2(w) / (sb * sc), Norm2(v - u) / (sa * sd),
               Norm2(w - u) / (sa * sc), Norm2(w - v) / (sa * sb) });
  return det * std::sqrt(least);
}

std::array<double, 2> TetDihedralAngles(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  const std::array<Vec3, 4> p{ { a, b, c, d } };
  constexpr std::size_t edges[6][4] = { { 0, 1, 2, 3 }, { 0, 2, 1, 3 }, { 0, 3, 1, 2 },
                                        { 1, 2, 0, 3 }, { 1, 3, 0, 2 }, { 2, 3, 0, 1 } };
  std::array<double, 2> range{ { 180, 0 } };
  for (const auto& e : edges)
  {
    const Vec3 axis = p[e[1]] - p[e[0]];
    const Vec3 m = Cross(axis, p[e[2]] - p[e[0]]);
    const Vec3 n = Cross(axis, p[e[3]] - p[e[0]]);
    const double angle = DegreesPerRadian * std::atan2(Norm(Cross(m, n)), Dot(m, n));
    range = { { std::min(range[0], angle), std::max(range[1], angle) } };
  }
  return range;
}

std::array<std::array<double, 3>, 3> WedgeJacobian(const std::array<Vec3, 6>& p)
{
  // At height z the section's edges are mixtures of those of the two triangles, so the normal is a quadratic
  // in z and the side vector a mixture of the three side edges. The swapped edges make up for the base normal
  // pointing out.
  const Vec3 e0 = p[2] - p[0];
  const Vec3 f0 = p[1] - p[0];
  const Vec3 e1 = p[5] - p[3];
  const Vec3 f1 = p[4] - p[3];
  const std::array<Vec3, 3> normals{ { Cross(e0, f0), 0.5 * (Cross(e0, f1) + Cross(e1, f0)),
                                       Cross(e1, f1) } };
  std::array<std::array<double, 3>, 3> coefficients;
  for (std::size_t k = 0; k < 3; ++k)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      coefficients[k][i] = Dot(normals[k], p[i + 3] - p[i]);
    }
  }
  return coefficients;
}

bool WedgeIsValid(const std::array<Vec3, 6>& nodes)
{
  const auto b = WedgeJacobian(nodes);
  for (std::size_t i = 0; i < 3; ++i)
  {
    // The quadratic b0 (1-z)^2 + 2 b1 z (1-z) + b2 z^2 is positive on [0, 1]. Written so that NaN is invalid.
    const bool positive = b[0][i] > 0 && b[2][i] > 0 && b[1][i] > -std::sqrt(b[0][i]) * std::sqrt(b[2][i]);
    if (!positive)
    {
      return false;
    }
  }
  return true;
}

bool WedgeSplitsAreValid(const std::array<Vec3, 6>& p)
{
  // Base and top with normals that point from base to top.
  const std::array<Vec3, 3> b{ { p[0], p[2], p[1] } };
  const std::array<Vec3, 3> t{ { p[3], p[5], p[4] } };
  // Tets are a triangle and a corner of the other, or edges of both that share a side edge (at j).
  bool isPositive = true;
  for (std::size_t i = 0; i < 3 && isPositive; ++i)
  {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    isPositive = TetVolume(b[0], b[1], b[2], t[i]) > 0 && TetVolume(t[0], t[2], t[1], b[i]) > 0 &&
                 TetVolume(b[i], b[j], t[k], t[j]) > 0 && TetVolume(b[k], b[j], t[j], t[i]) > 0;
  }
  return isPositive;
}

double WedgeVolume(const std::array<Vec3, 6>& nodes)
{
  double sum = 0;
  for (const auto& row : WedgeJacobian(nodes))
  {
    sum += row[0] + row[1] + row[2];
  }
  return sum / 18;
}

double WedgeQuality(const std::array<Vec3, 6>& p)
{
  const double shape = std::min(TriangleQuality(p[0], p[1], p[2]), TriangleQuality(p[3], p[4], p[5]));
  const double quality = std::min(shape * LeastOrthogonality(p), ScaledJacobian(p));
  return WedgeIsValid(p) ? quality : std::min(0.0, quality);
}

bool PyramidIsValid(const std::array<Vec3, 5>& nodes)
{
  const auto g = PyramidJacobian(nodes);
  return std::all_of(g.begin(), g.end(), [](double value) { return value > 0; });
}

double PyramidVolume(const std::array<Vec3, 5>& nodes)
{
  // The integral of (1-z)^2 is 1/3, that of a bilinear form the mean of its corners.
  const auto g = PyramidJacobian(nodes);
  return (g[0] + g[1] + g[2] + g[3]) / 12;
}

double PyramidQuality(const std::array<Vec3, 5>& p)
{
  const double byFirst = std::min(TetQuality(p[0], p[1], p[2], p[4]), TetQuality(p[0], p[2], p[3], p[4]));
  const double bySecond = std::min(TetQuality(p[0], p[1], p[3], p[4]), TetQuality(p[1], p[2], p[3], p[4]));
  const double quality = std::max(byFirst, bySecond);
  return PyramidIsValid(p) ? quality : std::min(0.0, quality);
}

double FaceNonOrthogonality(const std::array<Vec3, 3>& face, const Vec3& near, const Vec3& far)
{
  constexpr double degrees = 57.295779513082323;
  const Vec3 area = Cross(face[1] - face[0], face[2] - face[0]);
  const Vec3 line = far - near;
  // By the tangent: a cosine says little of small angles.
  return degrees * std::atan2(Norm(Cross(area, line)), std::abs(Dot(area, line)));
}

double FaceSkewness(const std::array<Vec3, 3>& face, const Vec3& near, const Vec3& far)
{
  constexpr double leastShare = 0.2; // of the centres' distance
  const Vec3 area = Cross(face[1] - face[0], face[2] - face[0]);
  const Vec3 line = far - near;
  const Vec3 centre = (face[0] + face[1] + face[2]) * (1.0 / 3);
  const double through = Dot(area, line);
  if (through == 0)
  {
    return std::numeric_limits<double>::infinity();
  }
  const Vec3 miss = (centre - near) - (Dot(area, centre - near) / through) * line;
  const double length = Norm(miss);
  double extent = leastShare * Norm(line);
  for (const Vec3& corner : face)
  {
    extent = length > 0 ? std::max(extent, std::abs(Dot(miss, corner - centre)) / length) : extent;
  }
  return length / extent;
}

} // namespace lamina
