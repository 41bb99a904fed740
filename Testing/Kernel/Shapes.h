// SPDX-License-Identifier: BSD-3-Clause
// Surfaces with known truth for the kernel tests.
#pragma once

#include "Mesh/TriangleComplex.h"

#include <functional>
#include <map>
#include <random>

namespace lamina::shapes
{

/// Adds a triangulated sphere (a subdivided octahedron; normal from pair.first outwards to pair.second).
/// Its points lie on the sphere; 8 * 4^level triangles.
inline void AddSphere(TriangleComplex& surface, const Vec3& centre, double radius, int level,
                      MaterialPair pair)
{
  std::vector<Vec3> unit{ { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
  std::vector<Triangle> faces{ { { 0, 2, 4 } }, { { 2, 1, 4 } }, { { 1, 3, 4 } }, { { 3, 0, 4 } },
                               { { 2, 0, 5 } }, { { 1, 2, 5 } }, { { 3, 1, 5 } }, { { 0, 3, 5 } } };
  for (int l = 0; l < level; ++l)
  {
    std::map<std::pair<Id, Id>, Id> middles;
    const auto middle = [&](Id a, Id b)
    {
      const auto key = std::minmax(a, b);
      const auto [at, isNew] =
        middles.emplace(std::pair<Id, Id>(key.first, key.second), static_cast<Id>(unit.size()));
      if (isNew)
      {
        unit.push_back(Normalized(unit[static_cast<std::size_t>(a)] + unit[static_cast<std::size_t>(b)]));
      }
      return at->second;
    };
    std::vector<Triangle> finer;
    for (const Triangle& f : faces)
    {
      const Id a = middle(f[0], f[1]);
      const Id b = middle(f[1], f[2]);
      const Id c = middle(f[2], f[0]);
      finer.insert(finer.end(),
                   { { { f[0], a, c } }, { { a, f[1], b } }, { { c, b, f[2] } }, { { a, b, c } } });
    }
    faces = finer;
  }
  const Id offset = static_cast<Id>(surface.points.size());
  for (const Vec3& p : unit)
  {
    surface.points.push_back(centre + radius * p);
  }
  for (const Triangle& f : faces)
  {
    surface.triangles.push_back({ { f[0] + offset, f[1] + offset, f[2] + offset } });
    surface.materials.push_back(pair);
  }
}

/// Adds the boundary of an axis-parallel box, every side cut into n[axis] steps; normal outwards, from first
/// to second.
inline void AddBox(TriangleComplex& surface, const Vec3& low, const Vec3& high, const std::array<int, 3>& n,
                   MaterialPair pair)
{
  std::map<std::array<int, 3>, Id> ids;
  const auto node = [&](const std::array<int, 3>& at)
  {
    const auto [entry, isNew] = ids.emplace(at, static_cast<Id>(surface.points.size()));
    if (isNew)
    {
      Vec3 p;
      for (std::size_t k = 0; k < 3; ++k)
      {
        const double s = at[k] / static_cast<double>(n[k]);
        p[static_cast<int>(k)] = (1 - s) * low[static_cast<int>(k)] + s * high[static_cast<int>(k)];
      }
      surface.points.push_back(p);
    }
    return entry->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    for (int side = 0; side < 2; ++side)
    {
      for (int i = 0; i < n[u]; ++i)
      {
        for (int j = 0; j < n[v]; ++j)
        {
          const auto corner = [&](int di, int dj)
          {
            std::array<int, 3> at{};
            at[axis] = side * n[axis];
            at[u] = i + di;
            at[v] = j + dj;
            return node(at);
          };
          const Id a = corner(0, 0);
          const Id b = corner(1, 0);
          const Id c = corner(1, 1);
          const Id d = corner(0, 1);
          surface.triangles.push_back(side == 1 ? Triangle{ { a, b, c } } : Triangle{ { a, c, b } });
          surface.triangles.push_back(side == 1 ? Triangle{ { a, c, d } } : Triangle{ { a, d, c } });
          surface.materials.insert(surface.materials.end(), 2, pair);
        }
      }
    }
  }
}

/// Adds a closed cylinder along z from z = 0 to `height`, `around` points around and `along` steps up; flat
/// ends.
inline void AddCylinder(TriangleComplex& surface, const Vec3& base, double radius, double height, int around,
                        int along, MaterialPair pair)
{
  const Id offset = static_cast<Id>(surface.points.size());
  for (int k = 0; k <= along; ++k)
  {
    for (int i = 0; i < around; ++i)
    {
      const double angle = 2 * 3.14159265358979323846 * i / around;
      surface.points.push_back(
        base + Vec3{ radius * std::cos(angle), radius * std::sin(angle), height * k / along });
    }
  }
  const Id bottom = static_cast<Id>(surface.points.size());
  surface.points.push_back(base);
  surface.points.push_back(base + Vec3{ 0, 0, height });
  const auto add = [&](Id a, Id b, Id c)
  {
    surface.triangles.push_back({ { a, b, c } });
    surface.materials.push_back(pair);
  };
  for (int i = 0; i < around; ++i)
  {
    const int j = (i + 1) % around;
    for (int k = 0; k < along; ++k)
    {
      const Id a = offset + k * around + i;
      const Id b = offset + k * around + j;
      add(a, b, b + around);
      add(a, b + around, a + around);
    }
    add(bottom, offset + j, offset + i);
    add(bottom + 1, offset + along * around + i, offset + along * around + j);
  }
}

/// Adds a smooth surface over a periodic parameter grid of `around` x `along` nodes, every other row shifted
/// by half a step and every node moved by up to `jitter` steps along the surface: its points lie on it
/// exactly. place(s, t), s and t in [0, 1), turns counter-clockwise seen from pair.second. Not periodic in t:
/// rows 0 and `along` are left as they are, open.
inline void AddParametric(TriangleComplex& surface, int around, int along, bool periodicT, double jitter,
                          MaterialPair pair, const std::function<Vec3(double, double)>& place,
                          unsigned int seed = 1)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> move(-jitter, jitter);
  const Id offset = static_cast<Id>(surface.points.size());
  const int rows = periodicT ? along : along + 1;
  for (int k = 0; k < rows; ++k)
  {
    const bool isRim = !periodicT && (k == 0 || k == along);
    for (int i = 0; i < around; ++i)
    {
      const double s = i + 0.5 * (k % 2) + move(generator);
      const double t = k + (isRim ? 0 : move(generator));
      surface.points.push_back(place(s / around, t / along));
    }
  }
  const auto node = [&](int i, int k) { return offset + (k % rows) * around + i % around; };
  for (int k = 0; k < along; ++k)
  {
    for (int i = 0; i < around; ++i)
    {
      const int up = i + k % 2; // the node half a step on in the next row
      const Id a = node(i, k);
      const Id b = node(i + 1, k);
      const Id c = node(up, k + 1);
      const Id d = node(up + around - 1, k + 1);
      surface.triangles.push_back({ { a, b, c } });
      surface.triangles.push_back({ { a, c, d } });
      surface.materials.insert(surface.materials.end(), 2, pair);
    }
  }
}

/// Adds a torus around the z axis, of equilateral triangles about `edge` wide, irregular.
inline void AddTorus(TriangleComplex& surface, double ring, double tube, double edge, double jitter,
                     MaterialPair pair)
{
  constexpr double Pi = 3.14159265358979323846;
  const int along = static_cast<int>(std::round(2 * Pi * tube / edge / 2)) * 2;
  const int around = static_cast<int>(std::round(2 * Pi * ring / edge));
  AddParametric(
    surface, around, along, true, jitter, pair,
    [=](double s, double t)
    {
      const double r = ring + tube * std::cos(2 * Pi * t);
      return Vec3{ r * std::cos(2 * Pi * s), r * std::sin(2 * Pi * s), tube * std::sin(2 * Pi * t) };
    });
}

/// Adds an open tube along z, of equilateral triangles about `edge` wide, irregular.
inline void AddTube(TriangleComplex& surface, const Vec3& base, double radius, double height, double edge,
                    double jitter, MaterialPair pair)
{
  constexpr double Pi = 3.14159265358979323846;
  const int around = static_cast<int>(std::round(2 * Pi * radius / edge));
  const int along = static_cast<int>(std::round(height / (edge * std::sqrt(0.75)) / 2)) * 2;
  AddParametric(
    surface, around, along, false, jitter, pair,
    [=](double s, double t) {
      return base + Vec3{ radius * std::cos(2 * Pi * s), radius * std::sin(2 * Pi * s), height * t };
    });
}

/// Adds the closed surface of a full cylinder: a tube and two flat ends. The rims are nodes of both.
inline void AddClosedTube(TriangleComplex& surface, const Vec3& base, double radius, double height,
                          double edge, double jitter, MaterialPair pair)
{
  const Id first = static_cast<Id>(surface.points.size());
  AddTube(surface, base, radius, height, edge, jitter, pair);
  const Id last = static_cast<Id>(surface.points.size());
  constexpr double Pi = 3.14159265358979323846;
  const Id around = static_cast<Id>(std::round(2 * Pi * radius / edge));
  surface.points.push_back(base);
  surface.points.push_back(base + Vec3{ 0, 0, height });
  for (Id i = 0; i < around; ++i)
  {
    const Id j = (i + 1) % around;
    surface.triangles.push_back({ { last, first + j, first + i } });
    surface.triangles.push_back({ { last + 1, last - around + i, last - around + j } });
    surface.materials.insert(surface.materials.end(), 2, pair);
  }
}

/// Moves the points of a sphere along it by up to `jitter` times the angle given.
inline void JitterSphere(TriangleComplex& surface, const Vec3& centre, double radius, double jitter,
                         unsigned int seed = 3)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> move(-jitter, jitter);
  for (Vec3& p : surface.points)
  {
    const Vec3 moved = Normalized(p - centre) + Vec3{ move(generator), move(generator), move(generator) };
    p = centre + radius * Normalized(moved);
  }
}

} // namespace lamina::shapes
