// SPDX-License-Identifier: BSD-3-Clause
// Surfaces with known truth for the kernel tests.
#pragma once

#include "Mesh/TriangleComplex.h"

#include <functional>
#include <map>

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

} // namespace lamina::shapes
