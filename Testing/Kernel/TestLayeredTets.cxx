// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/Quality.h"
#include "Mesh/CellFaces.h"
#include "Mesh/VolumeCorrection.h"
#include "Shapes.h"
#include "Sizing/FeatureSize.h"
#include "Volume/LayeredTets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
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

/// A plate of thickness 1 whose edges suit `layers` layers at anisotropy 2.
TriangleComplex Slab(int layers)
{
  TriangleComplex surface;
  shapes::AddBox(surface, { 0, 0, 0 }, { 8, 8, 1 }, { { 4 * layers, 4 * layers, std::max(1, layers / 2) } },
                 { 1, 0 });
  Size(surface);
  return surface;
}

struct Filled
{
  VolumeMesh mesh;
  LayersOnSurface onSurface;
  LayersReport report;
};

Filled Fill(const TriangleComplex& surface, const LayeredTetsOptions& options, int threads = 2)
{
  ThreadMonitor monitor(threads);
  Filled filled;
  const auto report = MeshLayeredTets(surface, options, filled.mesh, filled.onSurface, monitor);
  EXPECT_TRUE(report) << options.layers << ": " << (report ? "" : report.GetError().message);
  filled.report = report ? *report : LayersReport{};
  return filled;
}

LayeredTetsOptions Ask(int layers, std::vector<int> materials)
{
  LayeredTetsOptions options;
  options.layers = layers;
  options.materials = std::move(materials);
  return options;
}

/// Tets are positive and fill the materials, no worse than 0.1; every triangle of the surface is one face.
void ExpectSound(const TriangleComplex& surface, const Filled& filled, const std::vector<int>& materials,
                 const std::string& what)
{
  const VolumeMesh& mesh = filled.mesh;
  ASSERT_GT(mesh.CellCount(), 0) << what;
  std::vector<double> sums(materials.size(), 0);
  double least = 1;
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    ASSERT_EQ(mesh.types[static_cast<std::size_t>(c)], CellType::Tetrahedron);
    const auto at = [&](int i) { return mesh.points[static_cast<std::size_t>(mesh.Cell(c)[i])]; };
    const double volume = TetVolume(at(0), at(1), at(2), at(3));
    ASSERT_GT(volume, 0) << what;
    least = std::min(least, TetQuality(at(0), at(1), at(2), at(3)));
    const int material = mesh.materials[static_cast<std::size_t>(c)];
    const auto m = std::find(materials.begin(), materials.end(), material) - materials.begin();
    ASSERT_LT(static_cast<std::size_t>(m), materials.size()) << what;
    sums[static_cast<std::size_t>(m)] += volume;
  }
  EXPECT_GT(least, 0.1) << what;
  EXPECT_DOUBLE_EQ(filled.report.leastQuality, least) << what;
  const auto expected = MaterialVolumes(surface, materials);
  for (std::size_t m = 0; m < materials.size(); ++m)
  {
    EXPECT_NEAR(sums[m], expected[m], 1e-9 * expected[m]) << what;
  }
  std::vector<Id> idOf(surface.points.size(), -1);
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    if (mesh.interfaceNodeIds[p] >= 0)
    {
      const auto s = static_cast<std::size_t>(mesh.interfaceNodeIds[p]);
      idOf[s] = static_cast<Id>(p);
      ASSERT_EQ(mesh.points[p], surface.points[s]) << what;
    }
  }
  ThreadMonitor monitor;
  const CellFaces faces = FindCellFaces(mesh, monitor);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    std::size_t sides = 0;
    for (int material : materials)
    {
      sides += SideOf(surface.materials[t], material) != 0 ? 1 : 0;
    }
    if (sides == 0)
    {
      continue;
    }
    Triangle corners = surface.triangles[t];
    for (Id& p : corners)
    {
      p = idOf[static_cast<std::size_t>(p)];
    }
    const auto group = static_cast<std::size_t>(faces.Find(corners));
    ASSERT_LT(group, faces.GroupCount()) << what << ": triangle " << t << " is not a face";
    EXPECT_EQ(faces.start[group + 1] - faces.start[group], sides) << what;
  }
}

/// For every mesh point the least number of edges to the points that `isStart` picks.
template<typename IsStart>
std::vector<int> StepsFrom(const VolumeMesh& mesh, IsStart&& isStart)
{
  std::vector<std::vector<Id>> ring(mesh.points.size());
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    for (int i = 0; i < 4; ++i)
    {
      for (int j = 0; j < 4; ++j)
      {
        if (i != j)
        {
          ring[static_cast<std::size_t>(mesh.Cell(c)[i])].push_back(mesh.Cell(c)[j]);
        }
      }
    }
  }
  std::vector<int> steps(mesh.points.size(), -1);
  std::deque<std::size_t> queue;
  for (std::size_t p = 0; p < steps.size(); ++p)
  {
    if (isStart(p))
    {
      steps[p] = 0;
      queue.push_back(p);
    }
  }
  while (!queue.empty())
  {
    const std::size_t p = queue.front();
    queue.pop_front();
    for (Id q : ring[p])
    {
      if (steps[static_cast<std::size_t>(q)] < 0)
      {
        steps[static_cast<std::size_t>(q)] = steps[p] + 1;
        queue.push_back(static_cast<std::size_t>(q));
      }
    }
  }
  return steps;
}

} // namespace

TEST(LayeredTets, SlabHasTheLayersAskedFor)
{
  for (int layers = 1; layers <= 8; ++layers)
  {
    const TriangleComplex surface = Slab(layers);
    const Filled filled = Fill(surface, Ask(layers, { 1 }));
    const std::string what = std::to_string(layers) + " layers";
    ExpectSound(surface, filled, { 1 }, what);
    const int columnLayers = (layers - 1) / 2;
    EXPECT_EQ(*std::max_element(filled.mesh.layers.begin(), filled.mesh.layers.end()), columnLayers) << what;
    // From the lower side's middle to the upper side there are as many edges as layers.
    const auto isLower = [&](std::size_t p)
    { return filled.mesh.layerIndex[p] == 0 && filled.mesh.points[p].z == 0; };
    const auto steps = StepsFrom(filled.mesh, isLower);
    int middle = 0;
    int right = 0;
    for (std::size_t p = 0; p < steps.size(); ++p)
    {
      const Vec3& x = filled.mesh.points[p];
      if (x.z == 1 && std::abs(x.x - 4) < 1 && std::abs(x.y - 4) < 1)
      {
        ++middle;
        right += steps[p] == layers ? 1 : 0;
      }
    }
    EXPECT_GT(middle, 0) << what;
    EXPECT_EQ(right, middle) << what;
  }
}

TEST(LayeredTets, Shell)
{
  TriangleComplex surface;
  shapes::AddSphere(surface, {}, 1, 4, { 2, 0 });
  shapes::AddSphere(surface, {}, 0.6, 4, { 1, 2 });
  Size(surface);
  for (const int layers : { 4, 5 })
  {
    const Filled filled = Fill(surface, Ask(layers, { 2 }));
    ExpectSound(surface, filled, { 2 }, "shell");
    EXPECT_EQ(filled.report.stoppedColumns, 0);
    const int columnLayers = (layers - 1) / 2;
    EXPECT_EQ(filled.onSurface.achieved, std::vector<int>(surface.triangles.size(), columnLayers));
    // Half the wall is 0.2 thick; layers of equal height.
    for (std::size_t p = 0; p < filled.mesh.points.size(); ++p)
    {
      const double depth = std::min(1 - Norm(filled.mesh.points[p]), Norm(filled.mesh.points[p]) - 0.6);
      if (filled.mesh.layerIndex[p] >= 0)
      {
        EXPECT_NEAR(depth, 0.4 / layers * filled.mesh.layerIndex[p], 0.03);
      }
    }
  }
}

TEST(LayeredTets, TwoSolidsShareTheirWall)
{
  TriangleComplex surface;
  shapes::AddSphere(surface, {}, 1, 3, { 2, 0 });
  shapes::AddSphere(surface, {}, 0.5, 3, { 1, 2 });
  Size(surface);
  const Filled filled = Fill(surface, Ask(3, { 1, 2 }));
  ExpectSound(surface, filled, { 1, 2 }, "both");
}

TEST(LayeredTets, ThreadsMakeNoDifference)
{
  const TriangleComplex surface = Slab(4);
  const Filled one = Fill(surface, Ask(4, { 1 }), 1);
  const Filled three = Fill(surface, Ask(4, { 1 }), 3);
  EXPECT_EQ(one.mesh.points, three.mesh.points);
  EXPECT_EQ(one.mesh.connectivity, three.mesh.connectivity);
  EXPECT_EQ(one.mesh.layers, three.mesh.layers);
}

TEST(LayeredTets, NothingAskedNothingMade)
{
  const Filled filled = Fill(Slab(2), Ask(2, {}));
  EXPECT_EQ(filled.mesh.CellCount(), 0);
}

TEST(LayeredTets, Errors)
{
  const TriangleComplex surface = Slab(2);
  const auto expect =
    [](const TriangleComplex& input, const LayeredTetsOptions& options, Failure kind, const char* word)
  {
    ThreadMonitor monitor;
    Filled filled;
    const auto result = MeshLayeredTets(input, options, filled.mesh, filled.onSurface, monitor);
    ASSERT_FALSE(result) << word;
    EXPECT_EQ(result.GetError().kind, kind) << word;
    EXPECT_NE(result.GetError().message.find(word), std::string::npos) << result.GetError().message;
  };
  expect(surface, Ask(2, { 1, 9 }), Failure::InvalidOption, "material 9");
  expect(surface, Ask(0, { 1 }), Failure::InvalidOption, "layers");
  expect(surface, Ask(200, { 1 }), Failure::InvalidOption, "100");
  LayeredTetsOptions options = Ask(2, { 1 });
  options.growth = 0;
  expect(surface, options, Failure::InvalidOption, "growth");
  options = Ask(2, { 1 });
  options.anisotropy = std::numeric_limits<double>::quiet_NaN();
  expect(surface, options, Failure::InvalidOption, "anisotropy");
  TriangleComplex bad = surface;
  bad.sizedMaterials.clear();
  expect(bad, Ask(2, { 1 }), Failure::InvalidInput, "MaterialFeatureSize");
  bad = surface;
  bad.triangles.pop_back();
  bad.materials.pop_back();
  expect(bad, Ask(2, { 1 }), Failure::InvalidInput, "");
  bad = surface;
  shapes::AddBox(bad, { 3, 3, 0.5 }, { 6, 6, 3 }, { { 1, 1, 1 } }, { 1, 0 });
  bad.thickness.resize(bad.points.size(), 1);
  expect(bad, Ask(2, { 1 }), Failure::InvalidInput, "intersects itself");

  ThreadMonitor cancelled;
  cancelled.Cancel();
  Filled filled;
  const auto result = MeshLayeredTets(surface, Ask(4, { 1 }), filled.mesh, filled.onSurface, cancelled);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.GetError().kind, Failure::Cancelled);
}
