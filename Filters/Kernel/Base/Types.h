// SPDX-License-Identifier: BSD-3-Clause
// The kernel's elementary types: ids that fit VTK's, and a 3-vector of doubles.
#pragma once

#include <array>
#include <cmath>
#include <vector>

namespace lamina
{

/// Ids and counts. The same type as vtkIdType on 64-bit systems, so that arrays can be handed over.
using Id = long long;

/// A point or vector in world coordinates (lengths in the image's unit, usually mm).
struct Vec3
{
  double x = 0;
  double y = 0;
  double z = 0;

  double& operator[](int i) { return (&x)[i]; }
  double operator[](int i) const { return (&x)[i]; }
  Vec3& operator+=(const Vec3& b)
  {
    x += b.x;
    y += b.y;
    z += b.z;
    return *this;
  }
  Vec3& operator-=(const Vec3& b)
  {
    x -= b.x;
    y -= b.y;
    z -= b.z;
    return *this;
  }
  Vec3& operator*=(double s)
  {
    x *= s;
    y *= s;
    z *= s;
    return *this;
  }
};
static_assert(sizeof(Vec3) == 3 * sizeof(double), "points are contiguous xyz doubles");

inline Vec3 operator+(Vec3 a, const Vec3& b)
{
  return a += b;
}
inline Vec3 operator-(Vec3 a, const Vec3& b)
{
  return a -= b;
}
inline Vec3 operator*(Vec3 a, double s)
{
  return a *= s;
}
inline Vec3 operator*(double s, Vec3 a)
{
  return a *= s;
}
inline Vec3 operator-(const Vec3& a)
{
  return { -a.x, -a.y, -a.z };
}
inline bool operator==(const Vec3& a, const Vec3& b)
{
  return a.x == b.x && a.y == b.y && a.z == b.z;
}
inline double Dot(const Vec3& a, const Vec3& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3 Cross(const Vec3& a, const Vec3& b)
{
  return { a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}
inline double Norm2(const Vec3& a)
{
  return Dot(a, a);
}
inline double Norm(const Vec3& a)
{
  return std::sqrt(Norm2(a));
}
/// The unit vector along a; the zero vector stays zero.
inline Vec3 Normalized(const Vec3& a)
{
  const double n = Norm(a);
  return n > 0 ? a * (1.0 / n) : Vec3{};
}
inline bool IsFinite(const Vec3& a)
{
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

/// Three point ids of a triangle, counter-clockwise seen from the side its normal points to.
using Triangle = std::array<Id, 3>;

} // namespace lamina
