// SPDX-License-Identifier: BSD-3-Clause
// Where the points of layers stand against closed formulas, and how soon growth and filling stop.
#include "PrismChecks.h"
#include "Volume/CoreTets.h"

#include <cmath>
#include <map>

using namespace lamina;
using namespace prisms;

namespace
{

/// Points of the layers on the column of the surface's point there, from the wall on.
std::vector<Vec3> ColumnAt(const TriangleComplex& surface, const Layers& layers, const Vec3& place)
{
  const Id foot = std::find(surface.points.begin(), surface.points.end(), place) - surface.points.begin();
  std::map<Id, Id> above;
  Id at = -1;
  for (Id c = 0; c < layers.mesh.CellCount(); ++c)
  {
    const Id* p = layers.mesh.Cell(c);
    for (int k = 0; k < 3; ++k)
    {
      above[p[k]] = p[k + 3];
      at = layers.mesh.interfaceNodeIds[static_cast<std::size_t>(p[k])] == foot ? p[k] : at;
    }
  }
  std::vector<Vec3> column;
  for (; at >= 0; at = above.count(at) > 0 ? above.at(at) : -1)
  {
    column.push_back(layers.mesh.points[static_cast<std::size_t>(at)]);
  }
  return column;
}

/// A cube from the origin to (3, 3, 3) whose triangles are the same under any exchange of axes: each square
/// is cut in four round its middle.
TriangleComplex EvenCube()
{
  constexpr int n = 6;
  TriangleComplex surface;
  std::map<std::array<int, 3>, Id> ids; // in halves of a square
  const auto point = [&](const std::array<int, 3>& at)
  {
    const auto [found, isNew] = ids.emplace(at, static_cast<Id>(surface.points.size()));
    if (isNew)
    {
      surface.points.push_back({ 3.0 * at[0] / (2 * n), 3.0 * at[1] / (2 * n), 3.0 * at[2] / (2 * n) });
    }
    return found->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (const int side : { 0, 2 * n })
    {
      for (int square = 0; square < n * n; ++square)
      {
        const auto corner = [&](int u, int v)
        {
          std::array<int, 3> at{};
          at[axis] = side;
          at[(axis + 1) % 3] = 2 * (square % n) + u;
          at[(axis + 2) % 3] = 2 * (square / n) + v;
          return point(at);
        };
        const std::array<Id, 4> ring{ { corner(0, 0), corner(2, 0), corner(2, 2), corner(0, 2) } };
        const Id middle = corner(1, 1);
        for (std::size_t k = 0; k < 4; ++k)
        {
          const Id next = ring[(k + 1) % 4];
          surface.triangles.push_back(side == 0 ? Triangle{ { next, ring[k], middle } }
                                                : Triangle{ { ring[k], next, middle } });
          surface.materials.push_back({ 1, 0 });
        }
      }
    }
  }
  Size(surface);
  return surface;
}

/// Stops after a number of questions; counts how much work was begun between two of them.
class StopsAfter : public Monitor
{
public:
  explicit StopsAfter(Id questions)
    : Limit(questions)
  {
  }
  void Progress(double, const char*) override {}
  bool Cancelled() override
  {
    ++this->Asked;
    this->Since = 0;
    return this->Asked > this->Limit;
  }
  void For(Id count, Id grain, const Chunk& chunk) override
  {
    this->Since += count;
    this->Most = std::max(this->Most, this->Since);
    this->After += this->Asked > this->Limit ? count : 0;
    for (Id begin = 0; begin < count; begin += grain)
    {
      chunk(begin, std::min(count, begin + grain));
    }
  }

  Id Asked = 0;
  Id Most = 0;  ///< elements of loops between two questions
  Id After = 0; ///< elements of loops begun after the answer was yes

private:
  Id Limit;
  Id Since = 0;
};

} // namespace

TEST(PrismOffsets, CornersAndEdgesOfACube)
{
  const TriangleComplex surface = EvenCube();
  PrismLayersOptions options;
  options.materials = { 1 };
  options.layers = 4;
  options.growth = 1.5;
  options.total = 0.1;
  const Layers layers = Grow(surface, options);
  ExpectSound(surface, layers, 1, { 1 });
  EXPECT_EQ(layers.report.stoppedColumns, 0);
  const double first = 0.1 / 8.125; // 1 + 1.5 + 2.25 + 3.375
  const std::vector<Vec3> corner = ColumnAt(surface, layers, { 0, 0, 0 });
  const std::vector<Vec3> edge = ColumnAt(surface, layers, { 1.5, 3, 0 });
  const std::vector<Vec3> face = ColumnAt(surface, layers, { 1.5, 1.5, 3 });
  ASSERT_EQ(corner.size(), 5u);
  ASSERT_EQ(edge.size(), 5u);
  ASSERT_EQ(face.size(), 5u);
  // The same depth below each face they stand on: the columns are as long as is asked for.
  for (int k = 0; k <= 4; ++k)
  {
    const double length = first * (std::pow(1.5, k) - 1) / 0.5;
    const double third = length / std::sqrt(3.0);
    const double half = length / std::sqrt(2.0);
    const auto at = static_cast<std::size_t>(k);
    EXPECT_LT(Norm(corner[at] - Vec3{ third, third, third }), 1e-9) << k;
    EXPECT_LT(Norm(edge[at] - Vec3{ 1.5, 3 - half, half }), 1e-9) << k;
    EXPECT_LT(Norm(face[at] - Vec3{ 1.5, 1.5, 3 - length }), 1e-9) << k;
  }
}

TEST(PrismOffsets, GrowthAndFillingStopSoon)
{
  const TriangleComplex surface = SizedSphere(3);
  PrismLayersOptions options;
  options.materials = { 3 };
  VolumeMesh mesh;
  TriangleComplex front;
  LayersOnSurface onSurface;
  StopsAfter whole(1000000000);
  ASSERT_TRUE(GrowPrismLayers(surface, options, mesh, front, onSurface, whole));
  const Id size = static_cast<Id>(surface.triangles.size() + surface.points.size());
  // Never more between two questions than some passes over the surface, so the time to stop grows with the
  // surface like one pass does.
  EXPECT_LE(whole.Most, 30 * size);
  ASSERT_GT(whole.Asked, 5);
  for (int part = 0; part < 10; ++part)
  {
    StopsAfter early(whole.Asked * part / 10);
    VolumeMesh none;
    TriangleComplex noFront;
    const auto result = GrowPrismLayers(surface, options, none, noFront, onSurface, early);
    ASSERT_FALSE(result) << part;
    EXPECT_EQ(result.GetError().kind, Failure::Cancelled) << part;
    EXPECT_LE(early.After, 30 * size) << part;
  }
  StopsAfter filling(1000000000);
  VolumeMesh core;
  ASSERT_TRUE(MeshCoreTets(front, {}, {}, core, filling));
  EXPECT_LE(filling.Most, 30 * core.CellCount());
  ASSERT_GT(filling.Asked, 5);
  for (int part = 0; part < 10; ++part)
  {
    StopsAfter early(filling.Asked * part / 10);
    VolumeMesh none;
    const auto result = MeshCoreTets(front, {}, {}, none, early);
    ASSERT_FALSE(result) << part;
    EXPECT_EQ(result.GetError().kind, Failure::Cancelled) << part;
    EXPECT_LE(early.After, 30 * core.CellCount()) << part;
  }
}
