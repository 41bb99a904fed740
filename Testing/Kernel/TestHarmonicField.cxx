// SPDX-License-Identifier: BSD-3-Clause
#include "FilledWalls.h"
#include "Shapes.h"
#include "Volume/QuadraticHarmonic.h"

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace lamina;
using namespace lamina::walls;

TEST(HarmonicField, QuadraticElementsAreExactForQuadraticFields)
{
  TriangleComplex box;
  shapes::AddBox(box, { 0, 0, 0 }, { 1, 1, 1 }, { { 3, 3, 3 } }, { 1, 0 });
  const Meshed meshed = Fill(box, 0.3);
  const VolumeMesh& mesh = meshed.mesh;
  // Known on the four sides, where x y is linear; through the two ends nothing flows.
  const auto isAt = [&](const Triangle& t, double place)
  {
    return std::all_of(t.begin(), t.end(),
                       [&](Id p) { return box.points[static_cast<std::size_t>(p)].z == place; });
  };
  const auto field = [&](std::size_t p) { return mesh.points[p].x * mesh.points[p].y; };
  std::vector<double> values(mesh.points.size(), 0.5);
  std::vector<char> known(mesh.points.size(), 0);
  std::vector<Triangle> walls;
  for (const Triangle& t : box.triangles)
  {
    if (isAt(t, 0) || isAt(t, 1))
    {
      continue;
    }
    walls.push_back(t);
    for (const Id p : t)
    {
      known[static_cast<std::size_t>(p)] = 1;
      values[static_cast<std::size_t>(p)] = field(static_cast<std::size_t>(p));
    }
  }
  std::vector<Id> cells(static_cast<std::size_t>(mesh.CellCount()));
  std::iota(cells.begin(), cells.end(), Id{ 0 });
  const auto worst = [&]()
  {
    double most = 0;
    for (std::size_t p = 0; p < values.size(); ++p)
    {
      most = std::max(most, std::abs(values[p] - field(p)));
    }
    return most;
  };
  ThreadMonitor monitor(2);
  ASSERT_TRUE(SolveHarmonic(mesh, cells, known, values, monitor));
  EXPECT_GT(worst(), 1e-3); // linear elements are not
  ASSERT_TRUE(SolveQuadraticHarmonic(mesh, cells, known, walls, values, monitor));
  EXPECT_LT(worst(), 1e-5); // of what the steps are to reach
}
