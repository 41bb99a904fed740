// SPDX-License-Identifier: BSD-3-Clause
// Cores that go well with the prisms they stand on.
#include "PrismChecks.h"
#include "Volume/CoreTets.h"
#include "Volume/FrontCells.h"

using namespace lamina;
using namespace prisms;

namespace
{

/// One triangle in the plane z = 0, a prism of this height below it.
TriangleComplex FrontOn(double height)
{
  TriangleComplex front;
  front.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, std::sqrt(0.75), 0 } };
  front.triangles = { { { 0, 1, 2 } } };
  front.materials = { { 1, 0 } };
  front.layerSide.assign(3, { 0, 0, height });
  return front;
}

double FitOfApex(const TriangleComplex& front, const Vec3& apex)
{
  std::vector<Vec3> points = front.points;
  points.push_back(apex);
  return FrontCells(front).FitOf({ { 0, 1, 2, 3 } }, points);
}

/// Volumes of the core's tets over those of the prisms they share a triangle with.
std::vector<double> VolumeRatios(const Layers& layers, const VolumeMesh& core)
{
  const FaceTable table(layers.front.triangles, static_cast<Id>(layers.front.points.size()));
  std::vector<double> ratios;
  for (Id c = 0; c < core.CellCount(); ++c)
  {
    const Id* p = core.Cell(c);
    const std::array<Id, 4> tet{ { p[0], p[1], p[2], p[3] } };
    for (std::size_t k = 0; k < 4; ++k)
    {
      const Triangle face = TetFace(tet, k);
      if (*std::max_element(face.begin(), face.end()) >= static_cast<Id>(layers.front.points.size()) ||
          table.Find(face) < 0)
      {
        continue;
      }
      std::array<Vec3, 6> wedge;
      for (std::size_t i = 0; i < 3; ++i)
      {
        const auto v = static_cast<std::size_t>(face[i]);
        wedge[i] = layers.front.points[v] - layers.front.layerSide[v];
        wedge[i + 3] = layers.front.points[v];
      }
      ratios.push_back(CellVolume(core, c) / std::abs(WedgeVolume(wedge)));
    }
  }
  return ratios;
}

double ShareWithin(const std::vector<double>& ratios, double low, double high)
{
  const auto count =
    std::count_if(ratios.begin(), ratios.end(), [&](double r) { return r > low && r < high; });
  return static_cast<double>(count) / static_cast<double>(ratios.size());
}

} // namespace

TEST(FrontCells, VolumesCountByTheirRatio)
{
  // A prism of height h and a tet of 3 h r have volumes of 1 to r.
  const double h = 0.2;
  const TriangleComplex front = FrontOn(h);
  const auto fit = [&](double ratio) {
    return FitOfApex(front, { 0.5, std::sqrt(0.75) / 3, 3 * h * ratio });
  };
  EXPECT_EQ(fit(1), 1);
  EXPECT_EQ(fit(0.51), 1);
  EXPECT_EQ(fit(1.99), 1);
  EXPECT_NEAR(fit(2.5), 0.235, 1e-12);
  EXPECT_NEAR(fit(3), 0.22, 1e-12);
  EXPECT_NEAR(fit(0.3), 0.22, 1e-12);
  EXPECT_LT(fit(6), 0.2);
  EXPECT_LT(fit(0.1), 0.2);
  EXPECT_GE(fit(1000), 0.12);
}

TEST(FrontCells, LeaningCellsCountByTheirAngle)
{
  // The centres' line leans by the tet's middle over both heights.
  const double h = 0.2;
  const double height = 3 * h;
  const double rise = 0.25 * height + 0.5 * h;
  for (const double degrees : { 20.0, 60.0, 80.0, 82.0 })
  {
    const double away = 4 * rise * std::tan(degrees * 3.14159265358979323846 / 180);
    const double cosine = std::cos(degrees * 3.14159265358979323846 / 180);
    EXPECT_NEAR(FitOfApex(FrontOn(h), { 0.5 + away, std::sqrt(0.75) / 3, height }),
                std::min(1.0, 1.44 * cosine), 1e-9)
      << degrees;
  }
}

TEST(FrontCells, NothingIsAskedWhereNoPrismIs)
{
  TriangleComplex front = FrontOn(0.2);
  const Vec3 high{ 0.5, 0.3, 50 };
  EXPECT_LT(FitOfApex(front, high), 0.2);
  front.layerSide[1] = {};
  EXPECT_EQ(FitOfApex(front, high), 1) << "a stopped column";
  front.layerSide = { { 0.1, 0, 0 }, { 0.1, 0, 0 }, { 0, 0.1, 0 } };
  EXPECT_EQ(FitOfApex(front, high), 1) << "sides in the plane of an opening";
  front.layerSide.clear();
  EXPECT_EQ(FitOfApex(front, high), 1);
  // Lower than a hundredth of its edge: no good tet could be three times as large.
  EXPECT_EQ(FitOfApex(FrontOn(0.005), { 0.5, std::sqrt(0.75) / 3, 0.5 }), 1);
}

TEST(CoreTets, VolumesFollowThePrisms)
{
  const TriangleComplex surface = SizedSphere(3);
  ThreadMonitor monitor(2);
  PrismLayersOptions options;
  options.materials = { 3 };
  for (const double share : { 0.1, 0.25 })
  {
    options.thickness = share;
    Layers layers = Grow(surface, options);
    const auto ratiosOf = [&](const TriangleComplex& front)
    {
      VolumeMesh core;
      const auto filled = MeshCoreTets(front, {}, {}, core, monitor);
      EXPECT_TRUE(filled) << filled.GetError().message;
      EXPECT_GT(filled->leastQuality, 0.15);
      EXPECT_LT(static_cast<double>(filled->tets), 4.5 * static_cast<double>(front.triangles.size()));
      return VolumeRatios(layers, core);
    };
    const std::vector<double> ratios = ratiosOf(layers.front);
    EXPECT_EQ(ratios.size(), layers.front.triangles.size());
    EXPECT_GE(ShareWithin(ratios, 0.3, 3), 0.99) << share;
    EXPECT_GE(ShareWithin(ratios, 0.5, 2), 0.95) << share;
    // Without the prisms' sides nothing is known of them.
    TriangleComplex bare = layers.front;
    bare.layerSide.clear();
    EXPECT_LT(ShareWithin(ratiosOf(bare), 0.5, 2), ShareWithin(ratios, 0.5, 2)) << share;
  }
}
