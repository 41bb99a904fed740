// SPDX-License-Identifier: BSD-3-Clause
// Prism layers and core on shapes where layers are known to fail.
#include "CoreChecks.h"
#include "Geometry/VisibleDirection.h"
#include "Images.h"
#include "PrismChecks.h"
#include "RefinedSurfaces.h"
#include "Volume/CoreTets.h"
#include "Volume/Wall.h"

using namespace lamina;
using namespace prisms;

namespace
{

/// From this cosine on, at which the best direction sees the faces round a point, prisms must be good, and on
/// triangles of this quality.
constexpr double GoodSight = 0.4;
constexpr double GoodTriangle = 0.3;

std::size_t U(Id i)
{
  return static_cast<std::size_t>(i);
}

/// For every point of the surface the least cosine of the best direction into the material with its faces.
std::vector<double> SightOf(const TriangleComplex& surface, int material)
{
  std::vector<double> sight(surface.points.size(), 1);
  const Wall wall = MakeWall(surface, material);
  for (Id v = 0; v < static_cast<Id>(wall.points.size()); ++v)
  {
    std::vector<Vec3> normals;
    for (Id t : Row(wall.star, v))
    {
      normals.push_back(Normalized(AreaVector2(wall.points, wall.triangles[U(t)])));
    }
    sight[U(wall.surfacePoints[U(v)])] = FindVisibleDirection(normals).leastCosine;
  }
  return sight;
}

/// Every cell valid; prisms above 0.2 on good triangles whose points are seen well; full layers on the
/// share of all triangles; the core above 0.1; the volume that of the surface.
void ExpectGood(const TriangleComplex& surface, int material, const std::string& what,
                double leastFull = 0.99)
{
  ThreadMonitor monitor(2);
  PrismLayersOptions options;
  options.materials = { material };
  options.layers = 3;
  VolumeMesh layers;
  TriangleComplex front;
  LayersOnSurface onSurface;
  SCOPED_TRACE(what);
  const auto grown = GrowPrismLayers(surface, options, layers, front, onSurface, monitor);
  ASSERT_TRUE(grown) << what << ": " << grown.GetError().message;
  const std::vector<double> sight = SightOf(surface, material);
  std::vector<double> groundOf(surface.points.size(), 1); // the poorest triangle at a point
  for (const Triangle& t : surface.triangles)
  {
    const double quality =
      TriangleQuality(surface.points[U(t[0])], surface.points[U(t[1])], surface.points[U(t[2])]);
    for (Id p : t)
    {
      groundOf[U(p)] = std::min(groundOf[U(p)], quality);
    }
  }
  std::vector<double> sightOf(layers.points.size(), 1);
  for (std::size_t p = 0; p < layers.points.size(); ++p)
  {
    const Id foot = layers.interfaceNodeIds[p];
    sightOf[p] = foot >= 0 && groundOf[U(foot)] >= GoodTriangle ? sight[U(foot)] : (foot >= 0 ? 0 : 1);
  }
  double sum = 0;
  Id bad = 0;
  for (Id c = 0; c < layers.CellCount(); ++c)
  {
    const double volume = CellVolume(layers, c);
    EXPECT_GT(volume, 0) << what;
    sum += volume;
    if (layers.types[U(c)] != CellType::Wedge)
    {
      continue;
    }
    const auto at = [&](int i) { return layers.points[U(layers.Cell(c)[i])]; };
    bool isSeen = true;
    for (int k = 0; k < 3; ++k) // layers come in order: what a column stands on is known from the one below
    {
      const double foot = sightOf[U(layers.Cell(c)[k])];
      sightOf[U(layers.Cell(c)[k + 3])] = foot;
      isSeen = isSeen && foot >= GoodSight;
    }
    const double quality = WedgeQuality({ { at(0), at(1), at(2), at(3), at(4), at(5) } });
    bad += isSeen && quality <= 0.2 ? 1 : 0;
  }
  Id walls = 0;
  Id full = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    walls += SideOf(surface.materials[t], material) != 0 ? 1 : 0;
    full += SideOf(surface.materials[t], material) != 0 && onSurface.achieved[t] == options.layers ? 1 : 0;
  }
  EXPECT_EQ(bad, 0) << what;
  EXPECT_GE(static_cast<double>(full), leastFull * static_cast<double>(walls)) << what;
  VolumeMesh core;
  CoreTetsOptions filling;
  filling.isThorough = true;
  const auto filled = MeshCoreTets(front, {}, filling, core, monitor);
  ASSERT_TRUE(filled) << what << ": " << filled.GetError().message;
  EXPECT_GT(filled->leastQuality, 0.1) << what;
  cores::ExpectFacesWithinLimits(front, core);
  for (Id c = 0; c < core.CellCount(); ++c)
  {
    sum += CellVolume(core, c);
  }
  const double expected = MaterialVolumes(surface, { material })[0];
  EXPECT_NEAR(sum, expected, 1e-9 * expected) << what;
}

/// A cone with its tip at the origin, of rings that shrink towards the tip, and a flat base; material 1.
TriangleComplex Cone(double halfAngle)
{
  constexpr double Pi = 3.14159265358979323846;
  constexpr int around = 20;
  constexpr int rings = 24;
  const double slope = std::tan(halfAngle * Pi / 180);
  const double shrink = 1 - 2 * Pi / around * std::sin(halfAngle * Pi / 180); // edges as long as wide
  TriangleComplex surface;
  const auto add = [&](Id a, Id b, Id c)
  {
    surface.triangles.push_back({ { a, b, c } });
    surface.materials.push_back({ 1, 0 });
  };
  double radius = 1;
  for (int k = 0; k < rings; ++k, radius *= shrink)
  {
    for (int i = 0; i < around; ++i)
    {
      const double angle = 2 * Pi * (i + 0.5 * (k % 2)) / around;
      surface.points.push_back({ radius * std::cos(angle), radius * std::sin(angle), radius / slope });
    }
  }
  const auto node = [&](int i, int k) { return Id{ k * around + i % around }; };
  for (int k = 0; k + 1 < rings; ++k)
  {
    for (int i = 0; i < around; ++i)
    {
      const int up = i + k % 2;
      add(node(i, k), node(up, k + 1), node(i + 1, k));
      add(node(i, k), node(up + around - 1, k + 1), node(up, k + 1));
    }
  }
  const Id tip = static_cast<Id>(surface.points.size());
  surface.points.push_back({});
  for (int i = 0; i < around; ++i)
  {
    add(node(i, rings - 1), tip, node(i + 1, rings - 1));
  }
  // The base, in rings too.
  std::vector<Id> outer(around);
  for (int i = 0; i < around; ++i)
  {
    outer[U(i)] = node(i, 0);
  }
  for (const double r : { 0.7, 0.4 })
  {
    std::vector<Id> inner(around);
    for (int i = 0; i < around; ++i)
    {
      const double angle = 2 * Pi * i / around;
      inner[U(i)] = static_cast<Id>(surface.points.size());
      surface.points.push_back({ r * std::cos(angle), r * std::sin(angle), 1 / slope });
    }
    for (int i = 0; i < around; ++i)
    {
      const std::size_t next = U((i + 1) % around);
      add(outer[U(i)], outer[next], inner[next]);
      add(outer[U(i)], inner[next], inner[U(i)]);
    }
    outer = inner;
  }
  const Id middle = static_cast<Id>(surface.points.size());
  surface.points.push_back({ 0, 0, 1 / slope });
  for (int i = 0; i < around; ++i)
  {
    add(outer[U(i)], outer[U((i + 1) % around)], middle);
  }
  return surface;
}

} // namespace

TEST(PrismShapes, Cube)
{
  TriangleComplex surface;
  shapes::AddBox(surface, { 0, 0, 0 }, { 1, 1, 1 }, { { 8, 8, 8 } }, { 1, 0 });
  Size(surface);
  ExpectGood(surface, 1, "cube");
}

TEST(PrismShapes, ConeTips)
{
  for (const double angle : { 45.0, 30.0, 15.0 })
  {
    TriangleComplex surface = Cone(angle);
    ThreadMonitor monitor(2);
    FeatureSizeOptions sizing;
    sizing.minimum = 0.15;
    ASSERT_TRUE(ComputeFeatureSize(surface, sizing, monitor));
    ASSERT_TRUE(RefineSurface(surface, {}, monitor));
    // At the rim of the base, which closes to 45 degrees too, prisms of just 0.2 would be the best: 98.01 %
    // of the widest cone keep their layers.
    ExpectGood(surface, 1, "cone of " + std::to_string(angle), angle == 45 ? 0.98 : 0.99);
  }
}

TEST(LongPrismShapes, KissingVessels)
{
  // Two tubes of radius 1, a tenth apart, in a box of fluid; and the same tubes full of fluid.
  TriangleComplex outside;
  shapes::AddBox(outside, { -3, -3, -1 }, { 5.1, 3, 5 }, { { 16, 12, 12 } }, { 2, 0 });
  TriangleComplex inside;
  for (const double x : { 0.0, 2.1 })
  {
    TriangleComplex tube;
    shapes::AddCylinder(tube, { x, 0, 0 }, 1, 4, 32, 20, { 2, 0 });
    for (TriangleComplex* whole : { &outside, &inside })
    {
      const Id shift = static_cast<Id>(whole->points.size());
      whole->points.insert(whole->points.end(), tube.points.begin(), tube.points.end());
      for (const Triangle& t : tube.triangles)
      {
        const bool isOutside = whole == &outside;
        whole->triangles.push_back(
          { { t[0] + shift, t[isOutside ? 2 : 1] + shift, t[isOutside ? 1 : 2] + shift } });
        whole->materials.push_back({ 2, 0 });
      }
    }
  }
  for (TriangleComplex* surface : { &outside, &inside })
  {
    ThreadMonitor monitor(2);
    FeatureSizeOptions sizing;
    sizing.minimum = 0.6;
    ASSERT_TRUE(ComputeFeatureSize(*surface, sizing, monitor));
    ASSERT_TRUE(RefineSurface(*surface, {}, monitor));
    ExpectGood(*surface, 2, surface == &outside ? "round kissing vessels" : "in kissing vessels");
  }
}

TEST(LongPrismShapes, BifurcationOfTenToOne)
{
  const auto image = images::Make({ { 40, 28, 34 } },
                                  [](Id i, Id j, Id k)
                                  {
                                    const double x = static_cast<double>(i) - 14;
                                    const double y = static_cast<double>(j) - 13.5;
                                    const double z = static_cast<double>(k) - 16.5;
                                    const bool isTrunk = x * x + y * y < 100 && std::abs(z) < 14;
                                    const bool isBranch = y * y + z * z < 1.1 && x > 0 && x < 23;
                                    return isTrunk || isBranch ? 1 : 0;
                                  });
  ExpectGood(RefinedSurface(image), 1, "bifurcation");
}

TEST(LongPrismShapes, SaddleCrease)
{
  // Two slabs that cross under an acute angle: creases of saddle shape where their faces meet.
  const auto image = images::MakeCentred(36,
                                         [](double x, double y, double z)
                                         {
                                           const bool isBody = std::abs(x) < 14 && std::abs(y) < 14;
                                           const bool one = std::abs(z - 0.35 * x) < 3.2;
                                           const bool two = std::abs(z + 0.35 * x + 0.2 * y) < 3.2;
                                           return isBody && (one || two) ? 1 : 0;
                                         });
  ExpectGood(RefinedSurface(image), 1, "saddle crease");
}

TEST(LongPrismShapes, TrabeculatedWall)
{
  // A cavity whose wall is beset with rods.
  const auto image = images::MakeCentred(30,
                                         [](double x, double y, double z)
                                         {
                                           const double r = std::sqrt(x * x + y * y + z * z);
                                           const double a = std::remainder(std::atan2(y, x), 0.785);
                                           const double b = std::remainder(std::acos(z / r), 0.785);
                                           const bool isRod = r > 7 && r * std::hypot(a, b) < 1.8;
                                           return r < 11 && !isRod ? 2 : (r < 14 ? 1 : 0);
                                         });
  ExpectGood(RefinedSurface(image), 2, "trabeculated wall");
}

TEST(LongPrismShapes, ChannelOfOneVoxel)
{
  const auto image =
    images::Make({ { 40, 16, 16 } },
                 [](Id i, Id j, Id k)
                 {
                   const auto far = [](Id a, double m) { return std::abs(static_cast<double>(a) - m); };
                   const bool isChamber =
                     (far(i, 7) < 5 || far(i, 32) < 5) && std::max(far(j, 7), far(k, 7)) < 5;
                   return isChamber || (j == 7 && k == 7 && i > 5 && i < 34) ? 1 : 0;
                 });
  ExpectGood(RefinedSurface(image), 1, "channel");
}
