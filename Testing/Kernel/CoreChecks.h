// SPDX-License-Identifier: BSD-3-Clause
// What must hold for every core.
#pragma once

#include "Geometry/Quality.h"
#include "Mesh/TetFaces.h"
#include "Volume/CoreTets.h"
#include "Volume/FrontCells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace cores
{

using namespace lamina;

inline double EnclosedVolume(const TriangleComplex& surface, int material)
{
  double sum = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const auto corner = [&](std::size_t k)
    { return surface.points[static_cast<std::size_t>(surface.triangles[t][k])]; };
    const double v = Dot(Cross(corner(0), corner(1)), corner(2)) / 6;
    sum += surface.materials[t].first == material ? v : (surface.materials[t].second == material ? -v : 0);
  }
  return sum;
}

inline std::map<int, double> MeshVolumes(const VolumeMesh& mesh)
{
  std::map<int, double> volumes;
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    const Id* p = mesh.Cell(c);
    const auto at = [&](int k) { return mesh.points[static_cast<std::size_t>(p[k])]; };
    const double v = TetVolume(at(0), at(1), at(2), at(3));
    EXPECT_GT(v, 0);
    volumes[mesh.materials[static_cast<std::size_t>(c)]] += v;
  }
  return volumes;
}

inline void ExpectFills(const TriangleComplex& surface, const VolumeMesh& mesh, std::vector<int> materials)
{
  const auto volumes = MeshVolumes(mesh);
  EXPECT_EQ(volumes.size(), materials.size());
  for (int material : materials)
  {
    const double expected = EnclosedVolume(surface, material);
    ASSERT_EQ(volumes.count(material), 1u) << material;
    EXPECT_NEAR(volumes.at(material), expected, 1e-11 * expected);
  }
  ASSERT_GE(mesh.points.size(), surface.points.size());
  EXPECT_TRUE(std::equal(surface.points.begin(), surface.points.end(), mesh.points.begin()));
  EXPECT_EQ(mesh.interfaceNodeIds.size(), mesh.points.size());
  EXPECT_EQ(mesh.layerIndex.size(), mesh.points.size());
}

/// No face of a core, towards another of its cells or a prism behind the front, is beyond the limits of
/// finite volumes: 85 degrees of non-orthogonality, a skewness of 4.
inline void ExpectFacesWithinLimits(const TriangleComplex& front, const VolumeMesh& core)
{
  std::vector<std::array<Id, 4>> tets;
  std::vector<Vec3> centres;
  for (Id c = 0; c < core.CellCount(); ++c)
  {
    const Id* p = core.Cell(c);
    tets.push_back({ { p[0], p[1], p[2], p[3] } });
    centres.emplace_back();
    for (int k = 0; k < 4; ++k)
    {
      centres.back() += 0.25 * core.points[static_cast<std::size_t>(p[k])];
    }
  }
  ThreadMonitor monitor;
  const FrontCells behind(front);
  const auto neighbours = FindTetNeighbours(tets, static_cast<Id>(core.points.size()), monitor);
  for (std::size_t t = 0; t < tets.size(); ++t)
  {
    for (std::size_t k = 0; k < 4; ++k)
    {
      const Triangle ids = TetFace(tets[t], k);
      const auto at = [&](std::size_t i) { return core.points[static_cast<std::size_t>(ids[i])]; };
      const auto other = static_cast<std::size_t>(neighbours[t][k]);
      const bool isInside = neighbours[t][k] >= 0 && core.materials[other] == core.materials[t];
      const Vec3* far = isInside ? &centres[other] : behind.CentreBehind(ids);
      if (far != nullptr)
      {
        EXPECT_LT(FaceNonOrthogonality({ { at(0), at(1), at(2) } }, centres[t], *far), 85);
        EXPECT_LT(FaceSkewness({ { at(0), at(1), at(2) } }, centres[t], *far), 4);
      }
    }
  }
}

} // namespace cores
