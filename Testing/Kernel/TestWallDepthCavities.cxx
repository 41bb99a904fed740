// SPDX-License-Identifier: BSD-3-Clause
// The depth of a layered wall round two cavities against a finer mesh of it.
#include "FilledWalls.h"
#include "Geometry/Quality.h"
#include "Mesh/Adjacency.h"
#include "Shapes.h"
#include "Sizing/FeatureSize.h"
#include "Volume/AssembleMesh.h"
#include "Volume/LayeredTets.h"

#include <algorithm>
#include <cmath>

using namespace lamina;
using namespace lamina::walls;

namespace
{

/// Depth at a place, from the tet that holds it; -1 if none does, or not all its corners have one.
double DepthAt(const Meshed& meshed, const WallDepthField& field, const Vec3& place)
{
  for (Id c = 0; c < meshed.mesh.CellCount(); ++c)
  {
    const Id* n = meshed.mesh.Cell(c);
    std::array<Vec3, 4> p;
    for (std::size_t k = 0; k < 4; ++k)
    {
      p[k] = meshed.mesh.points[static_cast<std::size_t>(n[k])];
    }
    const double whole = TetVolume(p[0], p[1], p[2], p[3]);
    double sum = 0;
    bool isInside =
      meshed.mesh.materials[static_cast<std::size_t>(c)] == 1 && Norm(p[0] - place) < 1; // longest edge
    for (std::size_t k = 0; k < 4 && isInside; ++k)
    {
      std::array<Vec3, 4> q = p;
      q[k] = place;
      const double weight = TetVolume(q[0], q[1], q[2], q[3]) / whole;
      isInside = weight >= -1e-12;
      const double value = field.points[static_cast<std::size_t>(n[k])];
      sum = value < 0 ? -10 : sum + weight * value;
    }
    if (isInside)
    {
      return std::max(sum, -1.0);
    }
  }
  return -1;
}

/// Every triangle cut in four: the same surface, finer.
TriangleComplex Finer(const TriangleComplex& surface)
{
  TriangleComplex finer;
  finer.points = surface.points;
  const EdgeTable table = MakeEdgeTable(surface.triangles);
  std::vector<std::array<Id, 3>> middle(surface.triangles.size());
  for (std::size_t e = 0; e < table.edges.size(); ++e)
  {
    const Edge& edge = table.edges[e];
    for (Id t : Row(table.triangles, static_cast<Id>(e)))
    {
      const Triangle& c = surface.triangles[static_cast<std::size_t>(t)];
      const std::size_t opposite =
        c[0] != edge.a && c[0] != edge.b ? 0 : (c[1] != edge.a && c[1] != edge.b ? 1 : 2);
      middle[static_cast<std::size_t>(t)][opposite] = static_cast<Id>(finer.points.size());
    }
    finer.points.push_back(0.5 * (surface.points[static_cast<std::size_t>(edge.a)] +
                                  surface.points[static_cast<std::size_t>(edge.b)]));
  }
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const Triangle& c = surface.triangles[t];
    const auto& m = middle[t];
    for (const Triangle& part : { Triangle{ { c[0], m[2], m[1] } }, Triangle{ { m[2], c[1], m[0] } },
                                  Triangle{ { m[1], m[0], c[2] } }, Triangle{ { m[0], m[1], m[2] } } })
    {
      finer.triangles.push_back(part);
      finer.materials.push_back(surface.materials[t]);
    }
  }
  return finer;
}

/// Wall 1 round two cavities (2 and 3) of blood, with a vessel (4) through the wall between their heights.
TriangleComplex TwoCavities(int level)
{
  TriangleComplex surface;
  const auto addInside = [&](const Vec3& centre, double radius, int sub, int material, const Vec3& stretch)
  {
    const std::size_t firstPoint = surface.points.size();
    const std::size_t first = surface.triangles.size();
    shapes::AddSphere(surface, {}, radius, sub, { 1, material });
    for (std::size_t t = first; t < surface.triangles.size(); ++t)
    {
      std::swap(surface.triangles[t][1], surface.triangles[t][2]);
    }
    for (std::size_t p = firstPoint; p < surface.points.size(); ++p)
    {
      Vec3& x = surface.points[p];
      x = centre + Vec3{ x.x * stretch.x, x.y * stretch.y, x.z * stretch.z };
    }
  };
  shapes::AddSphere(surface, {}, 2, level + 1, { 1, 0 });
  addInside({ -0.75, 0, 0 }, 0.6, level, 2, { 1, 1, 1.4 });
  addInside({ 0.8, 0.1, 0 }, 0.55, level, 3, { 1, 1.2, 1.5 });
  addInside({ 0, 1.5, 0 }, 0.18, level - 1, 4, { 1, 1, 4 });
  return surface;
}

} // namespace

TEST(LongWallDepth, TwoCavitiesAndAVessel)
{
  WallDepthOptions options;
  options.inner = { "1-2" };
  options.outer = { "1-0", "3-1" }; // the second cavity counts as outer, the vessel as nothing
  TriangleComplex surface = TwoCavities(3);
  const Meshed fine = Fill(Finer(surface), 0.1);
  ThreadMonitor monitor(2);
  ASSERT_TRUE(ComputeFeatureSize(surface, {}, monitor));
  Meshed coarse;
  LayeredTetsOptions layers;
  layers.materials = { 1 };
  LayersOnSurface onSurface;
  ASSERT_TRUE(MeshLayeredTets(surface, layers, coarse.mesh, onSurface, monitor));
  VolumeMesh cavities;
  layers.materials = { 2, 3, 4 };
  layers.layers = 1;
  ASSERT_TRUE(MeshLayeredTets(surface, layers, cavities, onSurface, monitor));
  const VolumeMesh wall = coarse.mesh;
  ASSERT_TRUE(AssembleMesh({ &wall, &cavities }, {}, coarse.mesh, monitor));
  ASSERT_TRUE(FindPatches(coarse.mesh, nullptr, {}, coarse.patches, monitor));
  const Measured ours = Measure(coarse, options);
  const Measured reference = Measure(fine, options);
  std::vector<double> errors;
  for (std::size_t p = 0; p < coarse.mesh.points.size(); ++p)
  {
    const Vec3& place = coarse.mesh.points[p];
    if (ours.field.points[p] <= 0 || ours.field.points[p] >= 1 || p % 7 != 0)
    {
      continue;
    }
    const double expected = DepthAt(fine, reference.field, place);
    if (expected >= 0) // behind the second cavity both sides count as outer
    {
      errors.push_back(std::abs(expected - ours.field.points[p]));
    }
  }
  std::sort(errors.begin(), errors.end());
  ASSERT_GT(errors.size(), 200u);
  EXPECT_LT(errors[errors.size() * 9 / 10], 0.01); // of the thickness
  EXPECT_LT(errors.back(), 0.01);
}
