// SPDX-License-Identifier: BSD-3-Clause
// What must hold for every core.
#pragma once

#include "Geometry/Quality.h"
#include "Volume/CoreTets.h"

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

} // namespace cores
