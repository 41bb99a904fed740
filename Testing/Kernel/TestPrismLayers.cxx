// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/Quality.h"
#include "Mesh/Adjacency.h"
#include "Mesh/CellFaces.h"
#include "Mesh/Closedness.h"
#include "Mesh/VolumeCorrection.h"
#include "Shapes.h"
#include "Sizing/FeatureSize.h"
#include "Volume/PrismLayers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace lamina;

namespace
{

void Size(TriangleComplex& surface)
{
  ThreadMonitor monitor(2);
  FeatureSizeOptions options;
  options.minimum = 1e-3;
  ASSERT_TRUE(ComputeFeatureSize(surface, options, monitor));
}

struct Layers
{
  VolumeMesh mesh;
  TriangleComplex front;
  LayersOnSurface onSurface;
  LayersReport report;
};

Layers Grow(const TriangleComplex& surface, const PrismLayersOptions& options, int threads = 2)
{
  ThreadMonitor monitor(threads);
  Layers layers;
  const auto report = GrowPrismLayers(surface, options, layers.mesh, layers.front, layers.onSurface, monitor);
  EXPECT_TRUE(report) << (report ? "" : report.GetError().message);
  layers.report = report ? *report : LayersReport{};
  return layers;
}

double CellVolume(const VolumeMesh& mesh, Id cell)
{
  const auto at = [&](int i) { return mesh.points[static_cast<std::size_t>(mesh.Cell(cell)[i])]; };
  switch (mesh.types[static_cast<std::size_t>(cell)])
  {
    case CellType::Wedge:
      EXPECT_TRUE(WedgeIsValid({ { at(0), at(1), at(2), at(3), at(4), at(5) } })) << cell;
      return WedgeVolume({ { at(0), at(1), at(2), at(3), at(4), at(5) } });
    case CellType::Pyramid:
      EXPECT_TRUE(PyramidIsValid({ { at(0), at(1), at(2), at(3), at(4) } })) << cell;
      return PyramidVolume({ { at(0), at(1), at(2), at(3), at(4) } });
    default:
      return TetVolume(at(0), at(1), at(2), at(3));
  }
}

/// Cells are positive, fill what lies between wall and front, and each wall triangle that carries layers is a
/// face of one cell on each side that is in `grown`; the front closes.
void ExpectSound(const TriangleComplex& surface, const Layers& layers, int material,
                 const std::vector<int>& grown)
{
  ThreadMonitor monitor;
  double sum = 0;
  for (Id c = 0; c < layers.mesh.CellCount(); ++c)
  {
    const double volume = CellVolume(layers.mesh, c);
    EXPECT_GT(volume, 0);
    sum += layers.mesh.materials[static_cast<std::size_t>(c)] == material ? volume : 0;
  }
  const auto error = CheckClosed(layers.front, true, monitor);
  EXPECT_FALSE(error) << error->message;
  const double wall = MaterialVolumes(surface, { material })[0];
  EXPECT_NEAR(sum + MaterialVolumes(layers.front, { material })[0], wall, 1e-9 * wall);

  std::vector<Id> idOf(surface.points.size(), -1);
  for (std::size_t p = 0; p < layers.mesh.points.size(); ++p)
  {
    const Id s = layers.mesh.interfaceNodeIds[p];
    if (s >= 0)
    {
      EXPECT_EQ(layers.mesh.points[p], surface.points[static_cast<std::size_t>(s)]);
      EXPECT_EQ(idOf[static_cast<std::size_t>(s)], -1) << "made twice";
      idOf[static_cast<std::size_t>(s)] = static_cast<Id>(p);
    }
  }
  const CellFaces faces = FindCellFaces(layers.mesh, monitor);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    if (SideOf(surface.materials[t], material) == 0 || layers.onSurface.achieved[t] <= 0)
    {
      continue;
    }
    Triangle corners = surface.triangles[t];
    for (Id& p : corners)
    {
      p = idOf[static_cast<std::size_t>(p)];
    }
    const Id group = faces.Find(corners);
    ASSERT_GE(group, 0) << t;
    const auto g = static_cast<std::size_t>(group);
    const auto sides =
      std::count_if(grown.begin(), grown.end(), [&](int m) { return SideOf(surface.materials[t], m) != 0; });
    EXPECT_EQ(faces.start[g + 1] - faces.start[g], static_cast<std::size_t>(sides)) << t;
  }
}

void ExpectError(const TriangleComplex& surface, const PrismLayersOptions& options, Failure kind,
                 const char* word)
{
  ThreadMonitor monitor;
  Layers layers;
  const auto result = GrowPrismLayers(surface, options, layers.mesh, layers.front, layers.onSurface, monitor);
  ASSERT_FALSE(result) << word;
  EXPECT_EQ(result.GetError().kind, kind) << word;
  EXPECT_NE(result.GetError().message.find(word), std::string::npos) << result.GetError().message;
}

TriangleComplex SizedSphere(int level)
{
  TriangleComplex surface;
  shapes::AddSphere(surface, { 5, 5, 5 }, 1, level, { 3, 0 });
  Size(surface);
  return surface;
}

} // namespace

TEST(PrismLayers, SphereIsAllWedges)
{
  const TriangleComplex surface = SizedSphere(2);
  PrismLayersOptions options;
  options.materials = { 3 };
  options.total = 0.5;
  const Layers layers = Grow(surface, options);
  ExpectSound(surface, layers, 3, { 3 });
  const Id triangles = static_cast<Id>(surface.triangles.size());
  EXPECT_EQ(layers.report.wedges, 5 * triangles);
  EXPECT_EQ(layers.report.pyramids + layers.report.tets, 0);
  EXPECT_EQ(layers.report.columns, static_cast<Id>(surface.points.size()));
  EXPECT_EQ(layers.report.thinnedColumns + layers.report.stoppedColumns, 0);
  EXPECT_GT(layers.report.leastQuality, 0.3);
  EXPECT_EQ(layers.onSurface.achieved, std::vector<int>(surface.triangles.size(), 5));
  EXPECT_EQ(std::count(layers.mesh.layers.begin(), layers.mesh.layers.end(), 1), triangles);
  // Growth 1.2: the first layer is 1 / 7.4416 of all.
  for (std::size_t p = 0; p < layers.mesh.points.size(); ++p)
  {
    const double depth = 1 - Norm(layers.mesh.points[p] - Vec3{ 5, 5, 5 });
    const int k = layers.mesh.layerIndex[p];
    EXPECT_NEAR(depth, 0.5 * (std::pow(1.2, k) - 1) / 0.2 / 7.4416, 0.03);
  }
}

TEST(PrismLayers, BothSidesOfAShell)
{
  // Fluid 2 round fluid 1: the inner sphere carries layers on both sides.
  TriangleComplex surface;
  shapes::AddSphere(surface, {}, 1, 3, { 1, 2 });
  shapes::AddSphere(surface, {}, 1.6, 3, { 2, 0 });
  Size(surface);
  PrismLayersOptions options;
  options.materials = { 2, 1, 2 };
  options.layers = 3;
  const Layers layers = Grow(surface, options);
  ExpectSound(surface, layers, 1, { 1, 2 });
  ExpectSound(surface, layers, 2, { 1, 2 });
  const auto onFront = MaterialsOf(layers.front);
  EXPECT_EQ(onFront, (std::vector<int>{ 1, 2 }));
  EXPECT_EQ(layers.report.wedges, 3 * (512 + 2 * 512));
}

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

TEST(PrismLayers, OnlyChosenNeighboursCarryLayers)
{
  // Fluid 2 between a ball of 1 and the outside.
  TriangleComplex surface;
  shapes::AddSphere(surface, {}, 1, 3, { 1, 2 });
  shapes::AddSphere(surface, {}, 1.6, 3, { 2, 0 });
  Size(surface);
  PrismLayersOptions options;
  options.materials = { 2 };
  options.layers = 3;
  for (const int neighbour : { 0, 1 })
  {
    options.neighbours = { neighbour };
    const Layers layers = Grow(surface, options);
    EXPECT_EQ(layers.report.wedges, 3 * 512);
    EXPECT_EQ(layers.report.stoppedColumns, 0); // walls not chosen are no trouble
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
      const int other =
        surface.materials[t].first == 2 ? surface.materials[t].second : surface.materials[t].first;
      EXPECT_EQ(layers.onSurface.achieved[t], other == neighbour ? 3 : 0);
    }
  }
  options.neighbours = { 1, 7 };
  ExpectError(surface, options, Failure::InvalidOption, "no fluid borders material 7");
}

TEST(PrismLayers, LengthsAreKept)
{
  const TriangleComplex surface = SizedSphere(3);
  PrismLayersOptions options;
  options.materials = { 3 };
  options.layers = 3;
  options.growth = 1.5;
  const auto expect = [&](double first)
  {
    const Layers layers = Grow(surface, options);
    ExpectSound(surface, layers, 3, { 3 });
    EXPECT_EQ(layers.onSurface.fraction, std::vector<double>(surface.triangles.size(), 1));
    for (std::size_t p = 0; p < layers.mesh.points.size(); ++p)
    {
      const double depth = 1 - Norm(layers.mesh.points[p] - Vec3{ 5, 5, 5 });
      const double expected = first * (std::pow(1.5, layers.mesh.layerIndex[p]) - 1) / 0.5;
      EXPECT_NEAR(depth, expected, 0.01 * expected + 1e-12);
    }
  };
  options.firstHeight = 0.02;
  expect(0.02);
  options.firstHeight = 0;
  options.total = 0.19;
  expect(0.19 / 4.75);
  // More than there is room for: thinner layers, and an error if there is room nowhere.
  options.total = 1.8;
  const Layers layers = Grow(surface, options);
  ExpectSound(surface, layers, 3, { 3 });
  EXPECT_LT(*std::max_element(layers.onSurface.fraction.begin(), layers.onSurface.fraction.end()), 0.6);
  options.total = 5;
  ExpectError(surface, options, Failure::InvalidOption, "fit nowhere");
  options.total = 0.1;
  options.firstHeight = 0.1;
  ExpectError(surface, options, Failure::InvalidOption, "both given");
  options.firstHeight = -1;
  ExpectError(surface, options, Failure::InvalidOption, "lengths");
}

TEST(PrismLayers, ThreadsMakeNoDifference)
{
  const TriangleComplex surface = SizedSphere(2);
  PrismLayersOptions options;
  options.materials = { 3 };
  const Layers one = Grow(surface, options, 1);
  const Layers three = Grow(surface, options, 3);
  EXPECT_EQ(one.mesh.points, three.mesh.points);
  EXPECT_EQ(one.mesh.connectivity, three.mesh.connectivity);
  EXPECT_EQ(one.front.points, three.front.points);
}

TEST(PrismLayers, NothingAskedNothingGrown)
{
  const Layers layers = Grow(SizedSphere(1), {});
  EXPECT_EQ(layers.mesh.CellCount(), 0);
  EXPECT_TRUE(layers.front.triangles.empty());
}

TEST(PrismLayers, Errors)
{
  const TriangleComplex surface = SizedSphere(1);
  PrismLayersOptions options;
  options.materials = { 3, 4 };
  ExpectError(surface, options, Failure::InvalidOption, "material 4");
  options.materials = { 3 };
  options.layers = 0;
  ExpectError(surface, options, Failure::InvalidOption, "layers");
  options.layers = 2;
  for (const double growth : { 0.9, 3.1, std::numeric_limits<double>::quiet_NaN() })
  {
    options.growth = growth;
    ExpectError(surface, options, Failure::InvalidOption, "growth");
  }
  options.growth = 1;
  for (const double thickness : { 0.0, 0.5, std::numeric_limits<double>::quiet_NaN() })
  {
    options.thickness = thickness;
    ExpectError(surface, options, Failure::InvalidOption, "thickness");
  }
  options.thickness = 0.2;
  TriangleComplex bad = surface;
  bad.sizedMaterials.clear();
  ExpectError(bad, options, Failure::InvalidInput, "MaterialFeatureSize");
  bad = surface;
  bad.triangles.pop_back();
  bad.materials.pop_back();
  ExpectError(bad, options, Failure::InvalidInput, "");
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
