// SPDX-License-Identifier: BSD-3-Clause
// Tetrahedra to better, and what must not change about them.
#pragma once

#include "Geometry/Predicates.h"
#include "Geometry/Quality.h"
#include "Mesh/TetFaces.h"
#include "Volume/ImproveTets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace shaken
{

using namespace lamina;

/// An n^3 grid of cubes of five tets each, alternating, its inner points shaken; lower half group 1, upper
/// group 2.
inline TetSet ShakenGrid(int n, double shake)
{
  TetSet set;
  std::mt19937 generator(6);
  std::uniform_real_distribution<double> noise(-shake, shake);
  const auto id = [n](int i, int j, int k) { return static_cast<Id>(i + (n + 1) * (j + (n + 1) * k)); };
  for (int k = 0; k <= n; ++k)
  {
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i <= n; ++i)
      {
        const bool isInner = i > 0 && j > 0 && k > 0 && i < n && j < n && k < n && 2 * k != n;
        const Vec3 move{ noise(generator), noise(generator), noise(generator) };
        set.points.push_back(Vec3{ 1.0 * i, 1.0 * j, 1.0 * k } + (isInner ? 1.0 : 0.0) * move);
        set.fixed.push_back(isInner ? 0 : 1);
        set.layerIndex.push_back(k);
      }
    }
  }
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        // A corner of the cube by three bits, mirrored in every second cube so that diagonals agree.
        const int m = (i + j + k) % 2;
        const auto c = [&](int x, int y, int z) { return id(i + (x ^ m), j + y, k + z); };
        const std::array<std::array<Id, 4>, 5> tets{
          { { { c(0, 0, 0), c(1, 0, 0), c(0, 1, 0), c(0, 0, 1) } },
            { { c(1, 1, 0), c(0, 1, 0), c(1, 0, 0), c(1, 1, 1) } },
            { { c(1, 0, 1), c(0, 0, 1), c(1, 1, 1), c(1, 0, 0) } },
            { { c(0, 1, 1), c(1, 1, 1), c(0, 0, 1), c(0, 1, 0) } },
            { { c(1, 0, 0), c(0, 1, 0), c(0, 0, 1), c(1, 1, 1) } } }
        };
        for (auto tet : tets)
        {
          const auto& p = set.points;
          const auto at = [&](std::size_t v) { return p[static_cast<std::size_t>(tet[v])]; };
          if (m == 1)
          {
            std::swap(tet[2], tet[3]);
          }
          if (Orientation(at(0), at(1), at(2), at(3)) > 0)
          {
            set.groups.push_back(2 * k < n ? 1 : 2);
            set.tets.push_back(tet);
          }
        }
      }
    }
  }
  return set;
}

inline std::array<double, 2> Volumes(const TetSet& set, double& least)
{
  std::array<double, 2> volumes{ { 0, 0 } };
  least = 1;
  for (std::size_t t = 0; t < set.tets.size(); ++t)
  {
    const auto at = [&](std::size_t v) { return set.points[static_cast<std::size_t>(set.tets[t][v])]; };
    volumes[static_cast<std::size_t>(set.groups[t] - 1)] += TetVolume(at(0), at(1), at(2), at(3));
    least = std::min(least, TetQuality(at(0), at(1), at(2), at(3)));
  }
  return volumes;
}

/// Faces without a neighbour or between groups.
inline std::set<Triangle> Walls(const TetSet& set)
{
  ThreadMonitor monitor;
  const auto neighbours = FindTetNeighbours(set.tets, static_cast<Id>(set.points.size()), monitor);
  std::set<Triangle> walls;
  for (std::size_t t = 0; t < set.tets.size(); ++t)
  {
    for (std::size_t k = 0; k < 4; ++k)
    {
      const Id other = neighbours[t][k];
      EXPECT_NE(other, -2);
      if (other < 0 || set.groups[static_cast<std::size_t>(other)] != set.groups[t])
      {
        Triangle face = TetFace(set.tets[t], k);
        std::sort(face.begin(), face.end());
        walls.insert(face);
      }
    }
  }
  return walls;
}

} // namespace shaken
