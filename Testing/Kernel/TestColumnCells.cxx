// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/Quality.h"
#include "Mesh/CellFaces.h"
#include "Mesh/VolumeCorrection.h"
#include "Shapes.h"
#include "Volume/ColumnCells.h"
#include "Volume/LayerMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace lamina;

namespace
{

/// Columns of two layers on a wall; node v stops where bit v of `stopped` is set.
Columns MakeColumns(const Wall& wall, const std::vector<Vec3>& directions, double height, unsigned stopped)
{
  Columns columns;
  columns.layers = 2;
  columns.fraction = { 0, 0.4, 1 };
  for (std::size_t v = 0; v < wall.points.size(); ++v)
  {
    const bool stops = v < 32 && (stopped >> v & 1u) != 0;
    columns.direction.push_back(Normalized(directions[v]));
    columns.height.push_back(stops ? 0 : height * (1 + 0.2 * static_cast<double>(v % 4)));
    columns.wanted.push_back(height);
    columns.hidden.push_back(0);
  }
  return columns;
}

double VolumeOf(const Wall& wall, const Columns& columns, const ColumnCell& cell)
{
  const auto at = [&](std::size_t i) { return columns.Place(wall, cell.nodes[i].node, cell.nodes[i].layer); };
  switch (cell.type)
  {
    case CellType::Wedge:
      return WedgeVolume({ { at(0), at(1), at(2), at(3), at(4), at(5) } });
    case CellType::Pyramid:
      return PyramidVolume({ { at(0), at(1), at(2), at(3), at(4) } });
    default:
      return TetVolume(at(0), at(1), at(2), at(3));
  }
}

/// All cells of a wall as a mesh, and how many of each type.
LayersReport Build(const TriangleComplex& surface, const Wall& wall, const Columns& columns, ColumnCells kind,
                   VolumeMesh& mesh)
{
  mesh = VolumeMesh{};
  LayersReport report;
  LayerMesh(surface, mesh).Add(wall, columns, kind, report);
  return report;
}

/// No face has more than two cells or cells that see it from the same side, and no quad meets triangles.
void ExpectConforming(const VolumeMesh& mesh, const std::string& what)
{
  ThreadMonitor monitor;
  const CellFaces faces = FindCellFaces(mesh, monitor);
  for (std::size_t g = 0; g < faces.GroupCount(); ++g)
  {
    const std::size_t count = faces.start[g + 1] - faces.start[g];
    ASSERT_LE(count, 2u) << what;
    if (count == 2)
    {
      ASSERT_TRUE(AreOpposite(faces.faces[faces.start[g]], faces.faces[faces.start[g] + 1])) << what;
    }
    else if (const CellFace& face = faces.faces[faces.start[g]]; face.IsQuad())
    {
      for (std::size_t k = 0; k < 4; ++k) // three corners of a quad are no triangle's of another cell
      {
        const Triangle half{ { face.corners[k], face.corners[(k + 1) % 4], face.corners[(k + 2) % 4] } };
        ASSERT_LT(faces.Find(half), 0) << what;
      }
    }
  }
}

} // namespace

TEST(ColumnCells, EveryPatternFillsThePrism)
{
  const std::vector<Vec3> places{ { 0, 0, 0 }, { 1, 0, 0 }, { 0.3, 0.9, 0 } };
  std::array<Id, 3> order{ { 0, 1, 2 } };
  do
  {
    for (unsigned stopped = 0; stopped < 8; ++stopped)
    {
      Wall wall;
      wall.points.resize(3);
      for (std::size_t i = 0; i < 3; ++i)
      {
        wall.points[static_cast<std::size_t>(order[i])] = places[i];
      }
      wall.triangles = { { { order[0], order[1], order[2] } } };
      // Upright columns: the sides are plane, so that the volume is area times mean height.
      const Columns columns = MakeColumns(wall, { { 0, 0, 1 }, { 0, 0, 1 }, { 0, 0, 1 } }, 0.3, stopped);
      const double height = (columns.height[0] + columns.height[1] + columns.height[2]) / 3;
      for (const ColumnCells kind : { ColumnCells::Prisms, ColumnCells::Tets })
      {
        for (int layer = 1; layer <= 2; ++layer)
        {
          const auto l = static_cast<std::size_t>(layer);
          const double expected = 0.45 * height * (columns.fraction[l] - columns.fraction[l - 1]);
          std::array<ColumnCell, 3> cells;
          const int count = CellsOfTriangle(wall, columns, 0, layer, kind, cells);
          const int moving = 3 - static_cast<int>((stopped & 1) + (stopped >> 1 & 1) + (stopped >> 2));
          EXPECT_EQ(count, kind == ColumnCells::Tets ? moving : std::min(1, moving));
          double sum = 0;
          for (int i = 0; i < count; ++i)
          {
            const double volume = VolumeOf(wall, columns, cells[static_cast<std::size_t>(i)]);
            EXPECT_GT(volume, 0) << stopped;
            EXPECT_GT(QualityOf(wall, columns, cells[static_cast<std::size_t>(i)]), 0) << stopped;
            sum += volume;
          }
          EXPECT_NEAR(sum, expected, 1e-14) << stopped << ' ' << layer;
        }
      }
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(ColumnCells, NeighboursFit)
{
  const std::vector<Vec3> places{ { 0, 0, 0 }, { 1, 0, 0.1 }, { 1.1, 1, 0 }, { 0, 0.9, 0.2 } };
  const std::vector<Vec3> leaning{ { 0.1, 0, 1 }, { -0.2, 0.1, 1 }, { 0, -0.2, 1 }, { 0.2, 0.2, 1 } };
  std::array<Id, 4> order{ { 0, 1, 2, 3 } };
  do
  {
    TriangleComplex surface;
    surface.points.resize(4);
    std::vector<Vec3> directions(4);
    for (std::size_t i = 0; i < 4; ++i)
    {
      surface.points[static_cast<std::size_t>(order[i])] = places[i];
      directions[static_cast<std::size_t>(order[i])] = leaning[i];
    }
    Wall wall;
    wall.points = surface.points;
    wall.surfacePoints = { 0, 1, 2, 3 };
    wall.triangles = { { { order[0], order[1], order[2] } }, { { order[0], order[2], order[3] } } };
    for (unsigned stopped = 0; stopped < 16; ++stopped)
    {
      const Columns columns = MakeColumns(wall, directions, 0.2, stopped);
      for (const ColumnCells kind : { ColumnCells::Prisms, ColumnCells::Tets })
      {
        VolumeMesh mesh;
        Build(surface, wall, columns, kind, mesh);
        ExpectConforming(mesh, "stopped " + std::to_string(stopped));
      }
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(ColumnCells, WallMinusFrontIsTheLayersVolume)
{
  TriangleComplex surface;
  shapes::AddBox(surface, { 0, 0, 0 }, { 3, 3, 3 }, { { 3, 3, 3 } }, { 7, 0 });
  const Wall wall = MakeWall(surface, 7);
  std::mt19937 random(2);
  for (int round = 0; round < 20; ++round)
  {
    std::vector<Vec3> directions;
    for (const Vec3& p : wall.points)
    {
      directions.push_back(Vec3{ 1.5, 1.5, 1.5 } - p);
    }
    Columns columns = MakeColumns(wall, directions, 0.3, 0);
    for (double& h : columns.height)
    {
      h = random() % 4 == 0 ? 0 : h;
    }
    for (const ColumnCells kind : { ColumnCells::Prisms, ColumnCells::Tets })
    {
      VolumeMesh mesh;
      const LayersReport report = Build(surface, wall, columns, kind, mesh);
      EXPECT_EQ(report.wedges > 0, kind == ColumnCells::Prisms);
      EXPECT_EQ(report.pyramids > 0, kind == ColumnCells::Prisms);
      EXPECT_EQ(report.wedges + report.pyramids + report.tets, mesh.CellCount());
      ExpectConforming(mesh, "box");
      double sum = 0;
      std::array<ColumnCell, 3> cells;
      for (Id t = 0; t < static_cast<Id>(wall.triangles.size()); ++t)
      {
        for (int layer = 1; layer <= 2; ++layer)
        {
          const int count = CellsOfTriangle(wall, columns, t, layer, kind, cells);
          for (int i = 0; i < count; ++i)
          {
            sum += VolumeOf(wall, columns, cells[static_cast<std::size_t>(i)]);
          }
        }
      }
      const double front = MaterialVolumes(FrontOf(wall, columns), { 7 })[0];
      EXPECT_NEAR(sum + front, 27, 27e-12) << round;
    }
  }
}
