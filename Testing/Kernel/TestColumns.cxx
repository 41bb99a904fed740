// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/Quality.h"
#include "Search/SelfIntersection.h"
#include "Shapes.h"
#include "Volume/ColumnCells.h"
#include "Volume/LayerMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace lamina;

namespace
{

Columns Grow(const Wall& wall, const ColumnOptions& options, int threads = 2)
{
  ThreadMonitor monitor(threads);
  const auto columns = GrowColumns(wall, options, monitor);
  EXPECT_TRUE(columns) << (columns ? "" : columns.GetError().message);
  return columns ? *columns : Columns{};
}

/// All cells are valid and the front meets itself nowhere.
void ExpectSound(const Wall& wall, const Columns& columns, ColumnCells kind)
{
  ASSERT_EQ(columns.height.size(), wall.points.size());
  std::array<ColumnCell, 3> cells;
  for (Id t = 0; t < static_cast<Id>(wall.triangles.size()); ++t)
  {
    for (int layer = 1; layer <= columns.layers; ++layer)
    {
      const int count = CellsOfTriangle(wall, columns, t, layer, kind, cells);
      for (int i = 0; i < count; ++i)
      {
        ASSERT_GT(QualityOf(wall, columns, cells[static_cast<std::size_t>(i)]), 0) << t;
      }
    }
  }
  ThreadMonitor monitor;
  const TriangleComplex front = FrontOf(wall, columns);
  EXPECT_EQ(FindIntersections(front.points, front.triangles, monitor).size(), 0u);
}

/// A ball whose points are shaken along the radius by up to `bumps` of it.
Wall BumpyBall(double bumps, unsigned seed)
{
  TriangleComplex surface;
  shapes::AddSphere(surface, {}, 1, 3, { 1, 0 });
  std::mt19937 random(seed);
  for (Vec3& p : surface.points)
  {
    p = p * (1 + bumps * (static_cast<double>(random() % 2001) / 1000 - 1));
  }
  return MakeWall(surface, 1);
}

/// The least quality of all cells on the wall.
double LeastQuality(const Wall& wall, const Columns& columns, ColumnCells kind)
{
  double least = 1;
  std::array<ColumnCell, 3> cells;
  for (Id t = 0; t < static_cast<Id>(wall.triangles.size()); ++t)
  {
    for (int layer = 1; layer <= columns.layers; ++layer)
    {
      const int count = CellsOfTriangle(wall, columns, t, layer, kind, cells);
      for (int i = 0; i < count; ++i)
      {
        least = std::min(least, QualityOf(wall, columns, cells[static_cast<std::size_t>(i)]));
      }
    }
  }
  return least;
}

Id CountStopped(const Columns& columns)
{
  return static_cast<Id>(std::count(columns.height.begin(), columns.height.end(), 0.0));
}

} // namespace

TEST(Columns, FractionsGrow)
{
  TriangleComplex surface;
  shapes::AddSphere(surface, {}, 1, 2, { 1, 0 });
  ColumnOptions options;
  options.layers = 4;
  options.growth = 1.5;
  const Columns columns = Grow(MakeWall(surface, 1), options);
  ASSERT_EQ(columns.fraction.size(), 5u);
  EXPECT_EQ(columns.fraction.front(), 0);
  EXPECT_DOUBLE_EQ(columns.fraction.back(), 1);
  for (std::size_t k = 2; k < 5; ++k)
  {
    EXPECT_NEAR((columns.fraction[k] - columns.fraction[k - 1]) /
                  (columns.fraction[k - 1] - columns.fraction[k - 2]),
                1.5, 1e-12);
  }
}

TEST(Columns, SlabGetsWhatItAsksFor)
{
  TriangleComplex surface;
  shapes::AddBox(surface, { 0, 0, 0 }, { 10, 10, 1 }, { { 20, 20, 2 } }, { 1, 0 });
  const Wall wall = MakeWall(surface, 1);
  for (const ColumnCells kind : { ColumnCells::Prisms, ColumnCells::Tets })
  {
    ColumnOptions options;
    options.layers = 3;
    options.share = 0.3;
    options.cells = kind;
    const Columns columns = Grow(wall, options);
    ExpectSound(wall, columns, kind);
    int middle = 0;
    for (std::size_t v = 0; v < wall.points.size(); ++v)
    {
      const Vec3& p = wall.points[v];
      if (std::abs(p.x - 5) > 0.6 || std::abs(p.y - 5) > 0.6) // where the rim's directions do not reach
      {
        continue;
      }
      ++middle;
      EXPECT_NEAR(columns.wanted[v], 0.3, 1e-12);
      EXPECT_NEAR(columns.height[v], 0.3, 1e-12);
      EXPECT_NEAR(columns.direction[v].z, p.z < 0.5 ? 1 : -1, 1e-12);
    }
    EXPECT_EQ(middle, 18);
  }
}

TEST(Columns, ThicknessGovernsWhereItIsLess)
{
  TriangleComplex surface;
  shapes::AddSphere(surface, { 3, 2, 1 }, 1, 3, { 1, 0 });
  surface.sizedMaterials = { 1 };
  surface.thickness.assign(surface.points.size(), 0.8);
  const Wall wall = MakeWall(surface, 1);
  ColumnOptions options;
  options.share = 0.25;
  const Columns columns = Grow(wall, options);
  ExpectSound(wall, columns, ColumnCells::Prisms);
  for (std::size_t v = 0; v < wall.points.size(); ++v)
  {
    EXPECT_NEAR(columns.height[v], 0.2, 1e-12);
    const Vec3 inward = Normalized(Vec3{ 3, 2, 1 } - wall.points[v]);
    EXPECT_GT(Dot(columns.direction[v], inward), 0.996); // the stars are not regular
  }
}

TEST(Columns, SphereShrinksNothing)
{
  TriangleComplex surface;
  shapes::AddSphere(surface, {}, 1, 2, { 1, 0 });
  const Wall wall = MakeWall(surface, 1);
  ColumnOptions options;
  options.total = 0.5;
  const Columns columns = Grow(wall, options);
  ExpectSound(wall, columns, ColumnCells::Prisms);
  EXPECT_EQ(columns.height, columns.wanted);
  EXPECT_EQ(columns.height, std::vector<double>(wall.points.size(), 0.5));
}

TEST(Columns, LastPrismsFitTheCore)
{
  // A quarter of the diameter would end in prisms several times as large as tets on what is left of the
  // triangles there.
  TriangleComplex surface;
  shapes::AddSphere(surface, {}, 1, 2, { 1, 0 });
  const Wall wall = MakeWall(surface, 1);
  for (const int layers : { 1, 5 })
  {
    ColumnOptions options;
    options.layers = layers;
    const Columns columns = Grow(wall, options);
    ExpectSound(wall, columns, ColumnCells::Prisms);
    EXPECT_EQ(columns.height, columns.wanted); // it is what is asked for
    double most = 0;
    for (const Triangle& t : wall.triangles)
    {
      const auto at = [&](std::size_t k, int layer) { return columns.Place(wall, t[k], layer); };
      const std::array<Vec3, 3> top{ { at(0, layers), at(1, layers), at(2, layers) } };
      const double volume =
        WedgeVolume({ { at(0, layers - 1), at(2, layers - 1), at(1, layers - 1), top[0], top[2], top[1] } });
      const double side = (Norm(top[1] - top[0]) + Norm(top[2] - top[1]) + Norm(top[0] - top[2])) / 3;
      most = std::max(most, volume / (side * side * side / std::sqrt(72.0)));
    }
    EXPECT_LT(most, 1.1);
    EXPECT_GT(most, 0.8);
  }
}

TEST(Columns, FrontsBetweenPlatesDoNotMeet)
{
  // Two bodies in a box, nearer to each other at an edge than their columns' rays can see.
  for (const double gap : { 0.4, 0.05 })
  {
    TriangleComplex surface;
    shapes::AddBox(surface, { 0, 0, 0 }, { 2, 2, 1 }, { { 6, 6, 3 } }, { 1, 2 });
    shapes::AddBox(surface, { 0.1, 0.2, 1 + gap }, { 2.1, 2.2, 2 }, { { 6, 6, 3 } }, { 1, 2 });
    shapes::AddBox(surface, { 2 + gap, 2.2 + gap, 0.3 }, { 4, 4, 1.4 }, { { 6, 6, 3 } }, { 1, 2 });
    shapes::AddBox(surface, { -4, -4, -4 }, { 8, 8, 8 }, { { 8, 8, 8 } }, { 2, 0 });
    const Wall wall = MakeWall(surface, 2);
    for (const ColumnCells kind : { ColumnCells::Prisms, ColumnCells::Tets })
    {
      ColumnOptions options;
      options.layers = 3;
      options.share = 0.45;
      options.cells = kind;
      const Columns columns = Grow(wall, options);
      ExpectSound(wall, columns, kind);
      if (kind == ColumnCells::Prisms)
      {
        EXPECT_EQ(CountStopped(columns), 0) << gap;
      }
    }
  }
}

TEST(Columns, HiddenNodesStop)
{
  // Around the middle of the top steep spikes go up and down in turn: no direction sees all faces there.
  TriangleComplex surface;
  shapes::AddBox(surface, { 0, 0, -30 }, { 8, 8, 0 }, { { 8, 8, 8 } }, { 1, 0 });
  for (Vec3& p : surface.points)
  {
    const double dx = std::abs(p.x - 4);
    const double dy = std::abs(p.y - 4);
    if (p.z == 0 && dx + dy == 1)
    {
      p.z = dx == 1 ? 12 : -12;
    }
  }
  const Wall wall = MakeWall(surface, 1);
  ColumnOptions options;
  options.layers = 2;
  options.share = 0.1;
  const Columns columns = Grow(wall, options);
  ExpectSound(wall, columns, ColumnCells::Prisms);
  bool found = false;
  for (std::size_t v = 0; v < wall.points.size(); ++v)
  {
    if (columns.hidden[v])
    {
      EXPECT_EQ(columns.height[v], 0);
      found = found || wall.points[v] == Vec3{ 4, 4, 0 };
    }
  }
  EXPECT_TRUE(found);
  EXPECT_LT(CountStopped(columns), static_cast<Id>(wall.points.size()) / 10);
}

TEST(Columns, OpeningsCarryNone)
{
  TriangleComplex surface;
  shapes::AddBox(surface, { 0, 0, 0 }, { 4, 4, 4 }, { { 8, 8, 8 } }, { 1, 0 });
  surface.patchNames = { "wall", "opening_1" };
  for (const Triangle& t : surface.triangles)
  {
    const bool top = std::all_of(t.begin(), t.end(),
                                 [&](Id p) { return surface.points[static_cast<std::size_t>(p)].z == 4; });
    surface.patches.push_back(top ? 1 : 0);
  }
  const Wall wall = MakeWall(surface, 1);
  const Columns columns = Grow(wall, {});
  ExpectSound(wall, columns, ColumnCells::Prisms);
  for (std::size_t v = 0; v < wall.points.size(); ++v)
  {
    EXPECT_EQ(columns.Stopped(static_cast<Id>(v)), wall.points[v].z == 4);
  }
}

TEST(Columns, ThreadsMakeNoDifferenceAndCancelStops)
{
  TriangleComplex surface;
  shapes::AddBox(surface, { 0, 0, 0 }, { 3, 2, 1 }, { { 9, 6, 3 } }, { 1, 0 });
  const Wall wall = MakeWall(surface, 1);
  const Columns one = Grow(wall, {}, 1);
  const Columns three = Grow(wall, {}, 3);
  EXPECT_EQ(one.height, three.height);
  EXPECT_EQ(one.direction, three.direction);
  ThreadMonitor monitor;
  monitor.Cancel();
  const auto result = GrowColumns(wall, {}, monitor);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.GetError().kind, Failure::Cancelled);
}

TEST(Columns, PoorPrismsAreFaired)
{
  for (unsigned seed = 0; seed < 5; ++seed)
  {
    const Wall wall = BumpyBall(0.1, seed);
    const Columns columns = Grow(wall, {});
    ExpectSound(wall, columns, ColumnCells::Prisms);
    EXPECT_EQ(CountStopped(columns), 0) << seed;
    const double least = LeastQuality(wall, columns, ColumnCells::Prisms);
    EXPECT_GT(least, 0.25) << seed;
  }
}

TEST(Columns, ThinLayersOfTetsStand)
{
  // A crust so thin that each tet is flat: layers of a tenth of an edge.
  for (unsigned seed = 0; seed < 5; ++seed)
  {
    Wall wall = BumpyBall(0.05, seed);
    wall.thickness.assign(wall.points.size(), 0.15);
    ColumnOptions options;
    options.layers = 2;
    options.share = 1.0 / 3;
    options.cells = ColumnCells::Tets;
    const Columns columns = Grow(wall, options);
    ExpectSound(wall, columns, ColumnCells::Tets);
    EXPECT_EQ(CountStopped(columns), 0) << seed;
    // Of a twentieth, even the tets of a straight column would be 0.12 at best.
    wall.thickness.assign(wall.points.size(), 0.07);
    EXPECT_EQ(CountStopped(Grow(wall, options)), static_cast<Id>(wall.points.size())) << seed;
  }
}
