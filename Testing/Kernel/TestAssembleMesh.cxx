// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/PointTable.h"
#include "Volume/AssembleMesh.h"

#include <gtest/gtest.h>

#include <limits>

using namespace lamina;

namespace
{

VolumeMesh Tet(const Vec3& apex, int material, int layer)
{
  VolumeMesh mesh;
  mesh.points = { { 9, 9, 9 }, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, apex }; // the first is not used
  mesh.AddCell(CellType::Tetrahedron, std::array<Id, 4>{ { 1, 2, 3, 4 } }, material, layer);
  return mesh;
}

} // namespace

TEST(AssembleMesh, EqualPointsBecomeOne)
{
  VolumeMesh upper = Tet({ 0, 0, 1 }, 1, 2);
  upper.layerIndex = { -1, 0, 3, -1, 1 };
  upper.interfaceNodeIds = { -1, 5, -1, 7, -1 };
  VolumeMesh lower = Tet({ -0.0, 0, -1 }, 2, 0);
  lower.points[1] = { -0.0, 0, 0 };
  std::swap(lower.connectivity[1], lower.connectivity[2]);
  lower.layerIndex = { -1, 4, 2, -1, 0 };
  lower.interfaceNodeIds = { -1, -1, 6, 7, -1 };
  ThreadMonitor monitor;
  VolumeMesh mesh;
  AssembleMeshOptions options;
  options.scale = 0.5;
  const auto report = AssembleMesh({ &upper, &lower }, options, mesh, monitor);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->points, 5);
  EXPECT_EQ(report->cells, 2);
  EXPECT_EQ(report->mergedPoints, 3);
  EXPECT_EQ(mesh.connectivity, (std::vector<Id>{ 0, 1, 2, 3, 0, 2, 1, 4 }));
  EXPECT_EQ(mesh.offsets, (std::vector<Id>{ 0, 4, 8 }));
  EXPECT_EQ(mesh.materials, (std::vector<int>{ 1, 2 }));
  EXPECT_EQ(mesh.layers, (std::vector<int>{ 2, 0 }));
  EXPECT_EQ(mesh.layerIndex, (std::vector<int>{ 0, 2, -1, 1, 0 }));
  EXPECT_EQ(mesh.interfaceNodeIds, (std::vector<Id>{ 5, 6, 7, -1, -1 }));
  EXPECT_EQ(mesh.points[4], (Vec3{ 0, 0, -0.5 }));
}

TEST(AssembleMesh, NearbyPointsStayApart)
{
  VolumeMesh upper = Tet({ 0, 0, 1 }, 1, 0);
  VolumeMesh lower = Tet({ 0, 0, -1 }, 1, 0);
  std::swap(lower.connectivity[1], lower.connectivity[2]);
  lower.points[2].x = std::nextafter(1.0, 2.0);
  ThreadMonitor monitor;
  VolumeMesh mesh;
  const auto report = AssembleMesh({ &upper, &lower }, {}, mesh, monitor);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->points, 6);
  EXPECT_EQ(report->mergedPoints, 2);
  EXPECT_TRUE(AssembleMesh({}, {}, mesh, monitor));
  EXPECT_EQ(mesh.CellCount(), 0);
}

TEST(AssembleMesh, BadInputIsNamed)
{
  ThreadMonitor monitor;
  VolumeMesh mesh;
  VolumeMesh part = Tet({ 0, 0, 1 }, 1, 0);
  AssembleMeshOptions options;
  options.scale = 0;
  EXPECT_EQ(AssembleMesh({ &part }, options, mesh, monitor).GetError().kind, Failure::InvalidOption);
  EXPECT_FALSE(AssembleMesh({ nullptr }, {}, mesh, monitor));
  part.connectivity[2] = 17;
  EXPECT_FALSE(AssembleMesh({ &part }, {}, mesh, monitor));
  part = Tet({ 0, 0, std::numeric_limits<double>::infinity() }, 1, 0);
  EXPECT_NE(AssembleMesh({ &part }, {}, mesh, monitor).GetError().message.find("point 4"), std::string::npos);
  part = Tet({ 0, 0, 1 }, 1, 0);
  part.materials.clear();
  EXPECT_FALSE(AssembleMesh({ &part }, {}, mesh, monitor));
}

TEST(PointTable, FindsWhatItHolds)
{
  PointTable table;
  for (int i = 0; i < 1000; ++i)
  {
    EXPECT_EQ(table.Insert({ 0.1 * i, -0.3 * i, 1.0 }), i);
  }
  for (int i = 0; i < 1000; ++i)
  {
    EXPECT_EQ(table.Insert({ 0.1 * i, -0.3 * i, 1.0 }), i);
    EXPECT_EQ(table.Find({ 0.1 * i, -0.3 * i, 1.0 }), i);
    EXPECT_EQ(table.Find({ 0.1 * i, -0.3 * i, 1.1 }), -1);
  }
}
