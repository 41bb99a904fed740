// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/QuadraticCells.h"
#include "Geometry/Quality.h"
#include "Shapes.h"
#include "Volume/QuadraticMesh.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace lamina;

namespace
{

constexpr int TetEdges[6][2] = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 1, 3 }, { 2, 3 } };

std::array<Vec3, 10> StraightTet()
{
  std::array<Vec3, 10> n{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };
  for (std::size_t e = 0; e < 6; ++e)
  {
    n[4 + e] =
      0.5 * (n[static_cast<std::size_t>(TetEdges[e][0])] + n[static_cast<std::size_t>(TetEdges[e][1])]);
  }
  return n;
}

std::array<Vec3, 15> StraightWedge()
{
  std::array<Vec3, 15> n{ { { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 0, 0, 1 }, { 0, 1, 1 }, { 1, 0, 1 } } };
  const auto& edges = EdgeNodes(CellType::Wedge);
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    n[6 + e] = 0.5 * (n[static_cast<std::size_t>(edges[e][0])] + n[static_cast<std::size_t>(edges[e][1])]);
  }
  return n;
}

/// A ball of tets from its middle to a sphere's triangles.
VolumeMesh Ball(const TriangleComplex& sphere)
{
  VolumeMesh mesh;
  mesh.points = sphere.points;
  const Id middle = static_cast<Id>(mesh.points.size());
  mesh.points.push_back({ 0, 0, 0 });
  for (const Triangle& t : sphere.triangles)
  {
    mesh.AddCell(CellType::Tetrahedron, std::array<Id, 4>{ { t[0], t[2], t[1], middle } }, 1, 0);
  }
  return mesh;
}

} // namespace

TEST(QuadraticCells, StraightTetHasAConstantJacobian)
{
  for (double c : QuadraticTetJacobian(StraightTet()))
  {
    EXPECT_NEAR(c, 1, 1e-14);
  }
  // Node 4 along its edge: the Jacobian vanishes at a corner where it comes to a quarter.
  auto n = StraightTet();
  n[4] = { 0.2501, 0, 0 };
  EXPECT_TRUE(QuadraticTetIsValid(n));
  n[4] = { 0.2499, 0, 0 };
  EXPECT_FALSE(QuadraticTetIsValid(n));
}

TEST(QuadraticCells, StraightWedgeIsThatOfSixNodes)
{
  auto n = StraightWedge();
  EXPECT_NEAR(QuadraticWedgeJacobian(n, 0.2, 0.3, 0.7), 1, 1e-14);
  EXPECT_TRUE(QuadraticWedgeIsValid(n));
  n[6] = { 0, 0.2501, 0 };
  EXPECT_TRUE(QuadraticWedgeIsValid(n));
  n[6] = { 0, 0.2499, 0 };
  EXPECT_FALSE(QuadraticWedgeIsValid(n));
  // A bulge of the base into the roof.
  n = StraightWedge();
  n[6].z = n[7].z = n[8].z = 0.9;
  EXPECT_FALSE(QuadraticWedgeIsValid(n));
}

TEST(QuadraticMesh, NodesOnASphereHalveNoJacobianAndFillIt)
{
  TriangleComplex coarse;
  shapes::AddSphere(coarse, { 0, 0, 0 }, 1, 2, { 1, 0 });
  TriangleComplex fine;
  shapes::AddSphere(fine, { 0, 0, 0 }, 1, 5, { 1, 0 });
  const VolumeMesh mesh = Ball(coarse);
  ThreadMonitor monitor(2);
  MeshPatches patches;
  ASSERT_TRUE(FindPatches(mesh, nullptr, {}, patches, monitor));
  QuadraticNodes nodes;
  const auto report = AddMiddleNodes(mesh, patches, &fine, {}, nodes, monitor);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->middleNodes, 192 + 66); // edges of the sphere and spokes
  EXPECT_EQ(report->curvedEdges, 192);
  EXPECT_EQ(report->straightenedEdges, 0);
  // The volume is the mean coefficient of the Jacobian over 6: compare with the ball's.
  double linear = 0;
  double quadratic = 0;
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    std::array<Vec3, 10> n;
    for (std::size_t k = 0; k < 4; ++k)
    {
      n[k] = mesh.points[static_cast<std::size_t>(mesh.Cell(c)[k])];
    }
    for (std::size_t k = 0; k < 6; ++k)
    {
      const Id node =
        nodes.connectivity[static_cast<std::size_t>(nodes.offsets[static_cast<std::size_t>(c)]) + k];
      n[4 + k] = nodes.points[static_cast<std::size_t>(node) - mesh.points.size()];
    }
    EXPECT_TRUE(QuadraticTetIsValid(n));
    linear += TetVolume(n[0], n[1], n[2], n[3]);
    for (double x : QuadraticTetJacobian(n))
    {
      quadratic += x / 120;
    }
  }
  const double ball = 4.0 / 3 * 3.14159265358979323846;
  EXPECT_GT(1 - linear / ball, 0.03);
  EXPECT_LT(std::abs(1 - quadratic / ball), 0.003);
}

TEST(QuadraticMesh, EdgesGoBackWhereACellWouldTurnOver)
{
  // A flat tet whose base is drawn towards a bulge higher than its apex.
  VolumeMesh mesh;
  mesh.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.3, 0.3, 0.05 } };
  mesh.AddCell(CellType::Tetrahedron, std::array<Id, 4>{ { 0, 1, 2, 3 } }, 1, 0);
  TriangleComplex roof;
  roof.points = { { -5, -5, 0.1 }, { 5, -5, 0.1 }, { 0, 9, 0.1 } };
  roof.triangles = { { { 0, 1, 2 } } };
  roof.materials = { { 1, 0 } };
  ThreadMonitor monitor;
  MeshPatches patches;
  ASSERT_TRUE(FindPatches(mesh, nullptr, {}, patches, monitor));
  QuadraticNodes nodes;
  const auto report = AddMiddleNodes(mesh, patches, &roof, {}, nodes, monitor);
  ASSERT_TRUE(report);
  EXPECT_GT(report->straightenedEdges, 0);
  EXPECT_EQ(report->curvedEdges, 0);
  EXPECT_TRUE(nodes.points[0] == 0.5 * (mesh.points[0] + mesh.points[1]));
  QuadraticMeshOptions options;
  options.largestOffset = 0.7;
  EXPECT_EQ(AddMiddleNodes(mesh, patches, &roof, options, nodes, monitor).GetError().kind,
            Failure::InvalidOption);
}
