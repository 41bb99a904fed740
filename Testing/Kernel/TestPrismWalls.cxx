// SPDX-License-Identifier: BSD-3-Clause
// Where prisms grow and where they end: openings, chosen walls, walls that allow none, troubled fluids.
#include "PrismChecks.h"
#include "Volume/CoreTets.h"

#include <map>

using namespace lamina;
using namespace prisms;

namespace
{

/// A box along z with openings at its ends, patches 1 and 2.
TriangleComplex Duct()
{
  TriangleComplex surface;
  shapes::AddBox(surface, { 0, 0, 0 }, { 2, 2, 5 }, { { 6, 6, 15 } }, { 1, 0 });
  surface.patchNames = { "wall", "opening_1", "opening_2" };
  for (const Triangle& t : surface.triangles)
  {
    const auto z = [&](std::size_t k) { return surface.points[static_cast<std::size_t>(t[k])].z; };
    const bool plane = z(0) == z(1) && z(1) == z(2);
    surface.patches.push_back(plane && z(0) == 0 ? 1 : (plane && z(0) == 5 ? 2 : 0));
  }
  Size(surface);
  return surface;
}

} // namespace

TEST(PrismLayers, LayersRunUpToOpenings)
{
  const TriangleComplex surface = Duct();
  PrismLayersOptions options;
  options.materials = { 1 };
  const Layers layers = Grow(surface, options);
  ExpectSound(surface, layers, 1, { 1 });
  const Id onWalls = static_cast<Id>(std::count(surface.patches.begin(), surface.patches.end(), 0));
  EXPECT_EQ(layers.report.wedges, 5 * onWalls);
  EXPECT_EQ(layers.report.pyramids + layers.report.tets + layers.report.stoppedColumns, 0);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    EXPECT_EQ(layers.onSurface.achieved[t], surface.patches[t] != 0 ? 0 : 5);
  }
  // Side faces and new triangles of the front cover each opening; nothing else lies in its plane.
  for (const double z : { 0.0, 5.0 })
  {
    const auto isIn = [&](const Vec3& p) { return std::abs(p.z - z) < 1e-12; };
    double front = 0;
    for (const Triangle& t : layers.front.triangles)
    {
      const auto at = [&](std::size_t k) { return layers.front.points[static_cast<std::size_t>(t[k])]; };
      front += isIn(at(0)) && isIn(at(1)) && isIn(at(2)) ? AreaVector2(layers.front.points, t).z / 2 : 0;
    }
    EXPECT_GT(z > 0 ? front : -front, 0.5); // it looks out
    EXPECT_LT(std::abs(front), 3.5);
    Id onRim = 0;
    for (std::size_t p = 0; p < layers.mesh.points.size(); ++p)
    {
      onRim += isIn(layers.mesh.points[p]) ? 1 : 0;
    }
    EXPECT_EQ(onRim, 24 * 6); // points round the rim, in all layers
  }
}

TEST(PrismLayers, LayersEndBeforeOpeningsThatBend)
{
  TriangleComplex surface = Duct();
  for (Vec3& p : surface.points)
  {
    const bool isInner = p.z == 5 && std::max(std::abs(p.x - 1), std::abs(p.y - 1)) < 0.4;
    p.z += isInner ? 0.05 : 0;
  }
  PrismLayersOptions options;
  options.materials = { 1 };
  const Layers layers = Grow(surface, options);
  ExpectSound(surface, layers, 1, { 1 });
  EXPECT_GT(layers.report.pyramids, 0);
  EXPECT_EQ(layers.report.stoppedColumns, 0); // openings are not counted as trouble
}

TEST(PrismLayers, OnlyChosenPatchesCarryLayers)
{
  // The walls on one side of the duct are a patch of their own, which is no opening.
  TriangleComplex surface = Duct();
  surface.patchNames.push_back("plaque");
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const auto x = [&](std::size_t k)
    { return surface.points[static_cast<std::size_t>(surface.triangles[t][k])].x; };
    surface.patches[t] = x(0) == 0 && x(1) == 0 && x(2) == 0 ? 3 : surface.patches[t];
  }
  PrismLayersOptions options;
  options.materials = { 1 };
  for (const int patch : { 3, 0 })
  {
    options.patches = { patch };
    const Layers layers = Grow(surface, options);
    ExpectSound(surface, layers, 1, { 1 });
    Id full = 0;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
      full += layers.onSurface.achieved[t] == 5 ? 1 : 0;
      EXPECT_TRUE(surface.patches[t] == patch || layers.onSurface.achieved[t] == 0) << t;
    }
    EXPECT_GT(full, patch == 3 ? 100 : 300);
  }
  options.patches = { 1, 7 };
  ExpectError(surface, options, Failure::InvalidOption, "one of the patches");
}

TEST(PrismLayers, PoorColumnsEnd)
{
  // A tip of four faces, cut at its middle: along no direction prisms on its faces are good.
  TriangleComplex surface;
  surface.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, 1.2 } };
  surface.triangles = { { 0, 2, 1 }, { 0, 3, 2 }, { 0, 4, 3 }, { 0, 1, 4 },
                        { 5, 1, 2 }, { 5, 2, 3 }, { 5, 3, 4 }, { 5, 4, 1 } };
  surface.materials.assign(8, { 1, 0 });
  Size(surface);
  PrismLayersOptions options;
  options.materials = { 1 };
  options.layers = 2;
  const Layers kept = Grow(surface, options);
  ExpectSound(surface, kept, 1, { 1 });
  EXPECT_EQ(kept.report.stoppedColumns, 0);
  EXPECT_GT(kept.report.leastQuality, 0.2);
  // More than the faces allow at the tip and on the rim, but not at the middle of the base.
  options.leastQuality = 0.6;
  const Layers ended = Grow(surface, options);
  ExpectSound(surface, ended, 1, { 1 });
  EXPECT_GT(ended.report.stoppedColumns, 0);
  EXPECT_EQ(ended.report.stoppedPlaces.size(), static_cast<std::size_t>(ended.report.stoppedColumns));
  EXPECT_EQ(*std::min_element(ended.onSurface.achieved.begin(), ended.onSurface.achieved.end()), 0);
  options.endColumns = false;
  ExpectError(surface, options, Failure::Unreachable, "let columns end");
  options.leastQuality = 0.2;
  EXPECT_EQ(Grow(surface, options).report.wedges, kept.report.wedges);
  for (const double quality : { -0.1, 1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    options.leastQuality = quality;
    ExpectError(surface, options, Failure::InvalidOption, "least quality");
  }
}

TEST(PrismLayers, FluidsShareWhatColumnsLeave)
{
  // Around a point between two fluids steep spikes go up and down in turn: from neither side a direction sees
  // all faces there, so both fronts have the point and the triangles at it.
  TriangleComplex surface;
  shapes::AddBox(surface, { 0, 0, -30 }, { 8, 8, 0 }, { { 8, 8, 8 } }, { 1, 2 });
  shapes::AddBox(surface, { -16, -16, -46 }, { 24, 24, 28 }, { { 8, 8, 12 } }, { 2, 0 });
  for (Vec3& p : surface.points)
  {
    const double dx = std::abs(p.x - 4);
    const double dy = std::abs(p.y - 4);
    if (p.z == 0 && dx + dy == 1)
    {
      p.z = dx == 1 ? 12 : -12;
    }
  }
  Size(surface);
  PrismLayersOptions options;
  options.materials = { 1, 2 };
  options.layers = 2;
  const Layers layers = Grow(surface, options);
  EXPECT_GT(layers.report.stoppedColumns, 1);
  const auto& materials = layers.front.materials;
  EXPECT_GT(std::count(materials.begin(), materials.end(), MaterialPair{ 1, 2 }), 0);
  ThreadMonitor monitor(2);
  VolumeMesh core;
  const auto filled = MeshCoreTets(layers.front, {}, {}, core, monitor);
  ASSERT_TRUE(filled) << filled.GetError().message;
  std::map<int, double> volumes;
  for (const VolumeMesh* mesh : { &layers.mesh, static_cast<const VolumeMesh*>(&core) })
  {
    for (Id c = 0; c < mesh->CellCount(); ++c)
    {
      const double volume = CellVolume(*mesh, c);
      EXPECT_GT(volume, 0);
      volumes[mesh->materials[static_cast<std::size_t>(c)]] += volume;
    }
  }
  const std::vector<double> expected = MaterialVolumes(surface, { 1, 2 });
  EXPECT_NEAR(volumes[1], expected[0], 1e-9 * expected[0]);
  EXPECT_NEAR(volumes[2], expected[1], 1e-9 * expected[1]);
}

TEST(PrismLayers, TroubledFluids)
{
  PrismLayersOptions options;
  options.materials = { 1 };
  options.layers = 3;
  // One that intersects itself.
  TriangleComplex surface;
  shapes::AddBox(surface, { 0, 0, 0 }, { 1, 1, 1 }, { { 4, 4, 4 } }, { 1, 0 });
  shapes::AddBox(surface, { 0.55, 0.45, 0.35 }, { 1.5, 1.4, 1.3 }, { { 4, 4, 4 } }, { 1, 0 });
  Size(surface);
  ExpectError(surface, options, Failure::InvalidInput, "intersects itself");
  // Two bodies that touch in a corner, which is one point: no direction sees all its faces.
  surface = TriangleComplex{};
  shapes::AddBox(surface, { 0, 0, 0 }, { 1, 1, 1 }, { { 4, 4, 4 } }, { 1, 0 });
  const std::size_t first = surface.points.size();
  shapes::AddBox(surface, { 1, 1, 1 }, { 2, 2, 2 }, { { 4, 4, 4 } }, { 1, 0 });
  const auto last = surface.points.begin() + static_cast<std::ptrdiff_t>(first);
  const Id corner = std::find(surface.points.begin(), last, Vec3{ 1, 1, 1 }) - surface.points.begin();
  const Id twin = std::find(last, surface.points.end(), Vec3{ 1, 1, 1 }) - surface.points.begin();
  ASSERT_LT(twin, static_cast<Id>(surface.points.size()));
  const Id end = static_cast<Id>(surface.points.size()) - 1;
  for (Triangle& t : surface.triangles)
  {
    for (Id& p : t) // the last point takes the twin's place
    {
      p = p == twin ? corner : (p == end ? twin : p);
    }
  }
  surface.points[static_cast<std::size_t>(twin)] = surface.points.back();
  surface.points.pop_back();
  Size(surface);
  const Layers touching = Grow(surface, options);
  ExpectSound(surface, touching, 1, { 1 });
  ASSERT_EQ(touching.report.stoppedColumns, 1);
  EXPECT_EQ(touching.report.stoppedPlaces[0], (Vec3{ 1, 1, 1 }));
  // A body smaller than a layer of the length that is asked for.
  surface = SizedSphere(3);
  shapes::AddSphere(surface, { 8, 5, 5 }, 0.02, 2, { 3, 0 });
  Size(surface);
  options.materials = { 3 };
  options.total = 0.3;
  const Layers unequal = Grow(surface, options);
  ExpectSound(surface, unequal, 3, { 3 });
  EXPECT_EQ(unequal.report.wedges, 3 * static_cast<Id>(surface.triangles.size()));
  EXPECT_LT(unequal.onSurface.fraction.back(), 0.1);
  EXPECT_GT(unequal.onSurface.fraction.front(), 0.9);
}
