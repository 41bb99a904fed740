// SPDX-License-Identifier: BSD-3-Clause
// Solids of unusual kinds: many pieces, one inside the other, thin everywhere.
#include "Geometry/Quality.h"
#include "Images.h"
#include "Mesh/VolumeCorrection.h"
#include "RefinedSurfaces.h"
#include "Shapes.h"
#include "Volume/LayeredTets.h"

#include <algorithm>

using namespace lamina;

namespace
{

/// Fills material 1 with layers: positive tets above 0.1, of its volume.
LayersReport Fill(const TriangleComplex& surface, int layers, LayersOnSurface& onSurface)
{
  ThreadMonitor monitor(2);
  LayeredTetsOptions options;
  options.materials = { 1 };
  options.layers = layers;
  VolumeMesh mesh;
  const auto report = MeshLayeredTets(surface, options, mesh, onSurface, monitor);
  EXPECT_TRUE(report) << (report ? "" : report.GetError().message);
  double sum = 0;
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    const auto p = PlacesOf<4>(mesh, c);
    EXPECT_GT(TetQuality(p[0], p[1], p[2], p[3]), 0.1);
    sum += TetVolume(p[0], p[1], p[2], p[3]);
  }
  const double expected = MaterialVolumes(surface, { 1 })[0];
  EXPECT_NEAR(sum, expected, 1e-9 * expected);
  return report ? *report : LayersReport{};
}

void Size(TriangleComplex& surface)
{
  ThreadMonitor monitor(2);
  FeatureSizeOptions options;
  options.minimum = 1e-3;
  ASSERT_TRUE(ComputeFeatureSize(surface, options, monitor));
}

} // namespace

TEST(LayeredInputs, TwentyPieces)
{
  TriangleComplex surface;
  for (int i = 0; i < 20; ++i)
  {
    shapes::AddSphere(surface, { 3.0 * (i % 5), 3.0 * (i / 5), 0.1 * i }, 1 + 0.01 * i, 2, { 1, 0 });
  }
  Size(surface);
  LayersOnSurface onSurface;
  EXPECT_EQ(Fill(surface, 4, onSurface).stoppedColumns, 0);
  EXPECT_EQ(onSurface.achieved, std::vector<int>(surface.triangles.size(), 1));
}

TEST(LayeredInputs, ASolidInAFluidInTheSolid)
{
  TriangleComplex surface;
  shapes::AddSphere(surface, {}, 1, 3, { 1, 0 });
  shapes::AddSphere(surface, {}, 0.75, 3, { 1, 2 });
  for (std::size_t t = surface.triangles.size() / 2; t < surface.triangles.size(); ++t)
  {
    std::swap(surface.triangles[t][1], surface.triangles[t][2]); // it is the outer material that comes first
  }
  shapes::AddSphere(surface, {}, 0.4, 3, { 1, 2 });
  Size(surface);
  LayersOnSurface onSurface;
  EXPECT_EQ(Fill(surface, 4, onSurface).stoppedColumns, 0);
  EXPECT_EQ(onSurface.achieved, std::vector<int>(surface.triangles.size(), 1));
}

TEST(LayeredInputs, OneVoxelThickEverywhere)
{
  const LabelImage image = images::MakeCentred(13,
                                               [](double x, double y, double z)
                                               {
                                                 const double r = std::sqrt(x * x + y * y + z * z);
                                                 return r < 3.6 ? 2 : (r < 4.8 ? 1 : 0);
                                               });
  FeatureSizeOptions sizing;
  sizing.layers = 4;
  const TriangleComplex surface = RefinedSurface(image, sizing);
  LayersOnSurface onSurface;
  const LayersReport report = Fill(surface, 4, onSurface);
  EXPECT_GT(report.columns, 0);
  const auto isFlagged = std::count(onSurface.achieved.begin(), onSurface.achieved.end(), 0);
  EXPECT_EQ(report.stoppedColumns > 0, isFlagged > 0);
}
