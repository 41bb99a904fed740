// SPDX-License-Identifier: BSD-3-Clause
#include "PrismChecks.h"

using namespace lamina;
using namespace prisms;

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
