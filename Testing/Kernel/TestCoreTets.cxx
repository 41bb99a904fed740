// SPDX-License-Identifier: BSD-3-Clause
#include "CoreChecks.h"
#include "Mesh/TetFaces.h"
#include "Shapes.h"

using namespace lamina;
using namespace cores;

namespace
{

std::vector<CoreTetsOptions> BothWays()
{
  CoreTetsOptions child;
  child.program = LAMINA_TETGEN_PROGRAM;
  return { CoreTetsOptions{}, child };
}

} // namespace

TEST(CoreTets, SphereIsFilled)
{
  TriangleComplex surface;
  shapes::AddSphere(surface, { 1, 2, 3 }, 2, 3, { 7, 0 });
  std::vector<VolumeMesh> meshes;
  for (const CoreTetsOptions& options : BothWays())
  {
    ThreadMonitor monitor(meshes.empty() ? 1 : 3);
    VolumeMesh mesh;
    const auto report = MeshCoreTets(surface, {}, options, mesh, monitor);
    ASSERT_TRUE(report) << report.GetError().message;
    ExpectFills(surface, mesh, { 7 });
    EXPECT_EQ(report->tets, mesh.CellCount());
    EXPECT_GT(report->leastQuality, 0.1);
    EXPECT_EQ(report->aboveGate, 1);
    meshes.push_back(mesh);
  }
  EXPECT_EQ(meshes[0].points, meshes[1].points);
  EXPECT_EQ(meshes[0].connectivity, meshes[1].connectivity);
}

TEST(CoreTets, EveryTriangleIsAFaceOfTheMaterialsBesideIt)
{
  // A ball of 1 in a shell of 2 in background, with a cavity in the ball and a separate box of 2.
  TriangleComplex surface;
  shapes::AddSphere(surface, { 0, 0, 0 }, 1, 3, { 1, 2 });
  shapes::AddSphere(surface, { 0, 0, 0 }, 1.5, 3, { 2, 0 });
  TriangleComplex cavity;
  shapes::AddSphere(cavity, { 0.1, 0, 0 }, 0.4, 2, { 1, 0 });
  const Id offset = static_cast<Id>(surface.points.size());
  surface.points.insert(surface.points.end(), cavity.points.begin(), cavity.points.end());
  for (const Triangle& t : cavity.triangles)
  {
    surface.triangles.push_back({ { t[0] + offset, t[2] + offset, t[1] + offset } });
    surface.materials.push_back({ 1, 0 });
  }
  shapes::AddBox(surface, { 3, 0, 0 }, { 4, 1, 1 }, { { 3, 3, 3 } }, { 2, 0 });
  ThreadMonitor monitor(2);
  VolumeMesh mesh;
  const auto report = MeshCoreTets(surface, {}, {}, mesh, monitor);
  ASSERT_TRUE(report) << report.GetError().message;
  ExpectFills(surface, mesh, { 1, 2 });
  // Each triangle has the tet of its first material behind it and that of its second, if any, in front.
  const FaceTable table(surface.triangles, static_cast<Id>(mesh.points.size()));
  std::vector<std::array<int, 2>> seen(surface.triangles.size(), std::array<int, 2>{ { 0, 0 } });
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    const std::array<Id, 4> tet{ { mesh.Cell(c)[0], mesh.Cell(c)[1], mesh.Cell(c)[2], mesh.Cell(c)[3] } };
    for (std::size_t k = 0; k < 4; ++k)
    {
      const Id f = table.Find(TetFace(tet, k));
      if (f >= 0)
      {
        const bool isFirst = TurnAlike(surface.triangles[static_cast<std::size_t>(f)], TetFace(tet, k));
        seen[static_cast<std::size_t>(f)][isFirst ? 0 : 1] = mesh.materials[static_cast<std::size_t>(c)];
      }
    }
  }
  for (std::size_t f = 0; f < seen.size(); ++f)
  {
    EXPECT_EQ(seen[f][0], surface.materials[f].first);
    EXPECT_EQ(seen[f][1], surface.materials[f].second);
  }
}

TEST(CoreTets, InteriorPointsAndSizesAreHonoured)
{
  TriangleComplex surface;
  shapes::AddBox(surface, { 0, 0, 0 }, { 4, 4, 4 }, { { 4, 4, 4 } }, { 1, 0 });
  ThreadMonitor monitor;
  VolumeMesh coarse;
  VolumeMesh fine;
  const std::vector<Vec3> interior{ { 2, 2.1, 2.2 }, { 1.1, 1.2, 1.3 }, { 9, 9, 9 } };
  for (const CoreTetsOptions& options : BothWays())
  {
    ASSERT_TRUE(MeshCoreTets(surface, interior, options, coarse, monitor));
    ExpectFills(surface, coarse, { 1 });
  }
  CoreTetsOptions options;
  options.maximumEdge = 0.5;
  const auto report = MeshCoreTets(surface, interior, options, fine, monitor);
  ASSERT_TRUE(report) << report.GetError().message;
  ExpectFills(surface, fine, { 1 });
  EXPECT_GT(fine.CellCount(), 3 * coarse.CellCount());
}

TEST(CoreTets, BadSurfacesAreRefusedWithPlaces)
{
  ThreadMonitor monitor;
  VolumeMesh mesh;
  TriangleComplex open;
  shapes::AddSphere(open, { 0, 0, 0 }, 1, 2, { 1, 0 });
  open.triangles.pop_back();
  open.materials.pop_back();
  auto result = MeshCoreTets(open, {}, {}, mesh, monitor);
  ASSERT_FALSE(result);
  EXPECT_NE(result.GetError().message.find("open"), std::string::npos);
  EXPECT_EQ(result.GetError().places.size(), 3u);

  TriangleComplex crossing;
  shapes::AddSphere(crossing, { 0, 0, 0 }, 1, 2, { 1, 0 });
  shapes::AddSphere(crossing, { 1.5, 0, 0 }, 1, 2, { 1, 0 });
  CoreTetsReport onFailure;
  result = MeshCoreTets(crossing, {}, {}, mesh, monitor, &onFailure);
  ASSERT_FALSE(result);
  EXPECT_NE(result.GetError().message.find("intersects"), std::string::npos);
  EXPECT_FALSE(onFailure.offendingTriangles.empty());
  EXPECT_EQ(result.GetError().places.size(), onFailure.offendingTriangles.size());

  // A ball of another material that nothing joins to the one around it: (2, 0) inside (1, 0).
  TriangleComplex nested;
  shapes::AddSphere(nested, { 0, 0, 0 }, 1, 2, { 1, 0 });
  shapes::AddSphere(nested, { 0, 0, 0 }, 0.5, 2, { 2, 0 });
  EXPECT_FALSE(MeshCoreTets(nested, {}, {}, mesh, monitor));

  CoreTetsOptions options;
  options.radiusEdgeRatio = 1;
  result = MeshCoreTets(nested, {}, options, mesh, monitor);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.GetError().kind, Failure::InvalidOption);
  EXPECT_TRUE(MeshCoreTets({}, {}, {}, mesh, monitor));
  EXPECT_EQ(mesh.CellCount(), 0);
}
