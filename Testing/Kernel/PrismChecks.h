// SPDX-License-Identifier: BSD-3-Clause
// Prism layers grown for a test, and what must hold for all of them.
#pragma once

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

namespace prisms
{

using namespace lamina;

inline void Size(TriangleComplex& surface)
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

inline Layers Grow(const TriangleComplex& surface, const PrismLayersOptions& options, int threads = 2)
{
  ThreadMonitor monitor(threads);
  Layers layers;
  const auto report = GrowPrismLayers(surface, options, layers.mesh, layers.front, layers.onSurface, monitor);
  EXPECT_TRUE(report) << (report ? "" : report.GetError().message);
  layers.report = report ? *report : LayersReport{};
  return layers;
}

inline double CellVolume(const VolumeMesh& mesh, Id cell)
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
inline void ExpectSound(const TriangleComplex& surface, const Layers& layers, int material,
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

inline void ExpectError(const TriangleComplex& surface, const PrismLayersOptions& options, Failure kind,
                        const char* word)
{
  ThreadMonitor monitor;
  Layers layers;
  const auto result = GrowPrismLayers(surface, options, layers.mesh, layers.front, layers.onSurface, monitor);
  ASSERT_FALSE(result) << word;
  EXPECT_EQ(result.GetError().kind, kind) << word;
  EXPECT_NE(result.GetError().message.find(word), std::string::npos) << result.GetError().message;
}

inline TriangleComplex SizedSphere(int level)
{
  TriangleComplex surface;
  shapes::AddSphere(surface, { 5, 5, 5 }, 1, level, { 3, 0 });
  Size(surface);
  return surface;
}

} // namespace prisms
