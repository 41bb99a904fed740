// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/Quality.h"
#include "Mesh/Adjacency.h"
#include "Shapes.h"
#include "Sizing/FeatureSize.h"
#include "Volume/AssembleMesh.h"
#include "Volume/CoreTets.h"
#include "Volume/LayeredTets.h"
#include "Volume/QuadraticHarmonic.h"
#include "Volume/WallDepth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace lamina;

namespace
{

constexpr double Pi = 3.14159265358979323846;

struct Meshed
{
  VolumeMesh mesh;
  MeshPatches patches;
};

/// Fills all materials of the surface with tets no longer than `edge`.
Meshed Fill(const TriangleComplex& surface, double edge)
{
  ThreadMonitor monitor(2);
  Meshed meshed;
  CoreTetsOptions options;
  options.maximumEdge = edge;
  options.sizeFactor = 1;
  const auto report = MeshCoreTets(surface, {}, options, meshed.mesh, monitor);
  EXPECT_TRUE(report) << (report ? "" : report.GetError().message);
  EXPECT_TRUE(FindPatches(meshed.mesh, nullptr, {}, meshed.patches, monitor));
  return meshed;
}

struct Measured
{
  WallDepthField field;
  WallDepthReport report;
};

Measured Measure(const Meshed& meshed, const WallDepthOptions& options, int threads = 2)
{
  ThreadMonitor monitor(threads);
  Measured measured;
  const auto report = ComputeWallDepth(meshed.mesh, meshed.patches, options, measured.field, monitor);
  EXPECT_TRUE(report) << (report ? "" : report.GetError().message);
  measured.report = report ? *report : WallDepthReport{};
  return measured;
}

/// The inner half of a sphere's triangles counts as one material more, so that walls have names.
TriangleComplex Shell(double inner, double outer, int level)
{
  TriangleComplex surface;
  shapes::AddSphere(surface, {}, inner, level, { 2, 1 });
  shapes::AddSphere(surface, {}, outer, level, { 1, 0 });
  for (MaterialPair& pair : surface.materials)
  {
    pair = pair.first == 2 ? MaterialPair{ 1, 2 } : pair;
  }
  for (Triangle& t : surface.triangles)
  {
    const bool isInner = Norm(surface.points[static_cast<std::size_t>(t[0])]) < 0.5 * (inner + outer);
    if (isInner) // the normal points from 1 to 2, inwards
    {
      std::swap(t[1], t[2]);
    }
  }
  return surface;
}

/// A block of wedges between two coaxial cylinders about z: material 1, with a thin layer of 2 inside.
VolumeMesh WedgeTube(int around, int across)
{
  VolumeMesh mesh;
  const auto node = [&](int i, int j, int k) { return Id{ i + (across + 2) * (j % around + around * k) }; };
  for (int k = 0; k < 3; ++k)
  {
    for (int j = 0; j < around; ++j)
    {
      for (int i = 0; i < across + 2; ++i)
      {
        const double r = 1 + (i - 1) / static_cast<double>(across);
        const double angle = 2 * Pi * j / around;
        mesh.points.push_back({ r * std::cos(angle), r * std::sin(angle), 0.1 * k });
      }
    }
  }
  const Id up = node(0, 0, 1);
  for (int k = 0; k < 2; ++k)
  {
    for (int j = 0; j < around; ++j)
    {
      for (int i = 0; i <= across; ++i)
      {
        const Id a[4] = { node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k) };
        const int material = i == 0 ? 2 : 1;
        mesh.AddCell(CellType::Wedge,
                     std::array<Id, 6>{ { a[0], a[2], a[1], a[0] + up, a[2] + up, a[1] + up } }, material, 0);
        mesh.AddCell(CellType::Wedge,
                     std::array<Id, 6>{ { a[0], a[3], a[2], a[0] + up, a[3] + up, a[2] + up } }, material, 0);
      }
    }
  }
  return mesh;
}

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

TEST(WallDepth, ConcentricSpheres)
{
  const Meshed meshed = Fill(Shell(1, 2, 4), 0.2);
  const Measured measured = Measure(meshed, {});
  EXPECT_EQ(measured.report.oneSided, 0);
  EXPECT_EQ(measured.report.contestedNodes, 0);
  double worst = 0;
  for (std::size_t p = 0; p < meshed.mesh.points.size(); ++p)
  {
    const double r = Norm(meshed.mesh.points[p]);
    const double expected = (1 - 1 / r) / (1 - 0.5);
    const double depth = measured.field.points[p];
    if (r < 0.99) // in the cavity
    {
      EXPECT_EQ(depth, -1);
      continue;
    }
    worst = std::max(worst, std::abs(depth - expected));
  }
  EXPECT_LT(worst, 0.01);
  Id cells = 0;
  Id good = 0;
  for (Id c = 0; c < meshed.mesh.CellCount(); ++c)
  {
    const auto at = static_cast<std::size_t>(c);
    Vec3 middle;
    for (int k = 0; k < 4; ++k)
    {
      middle += meshed.mesh.points[static_cast<std::size_t>(meshed.mesh.Cell(c)[k])] * 0.25;
    }
    if (meshed.mesh.materials[at] == 1)
    {
      ++cells;
      const double along = Dot(measured.field.normals[at], Normalized(middle));
      EXPECT_GT(along, 0.8); // a gradient is of first order, the worst cells are flat
      good += along > 0.97 ? 1 : 0;
      EXPECT_NEAR(Norm(measured.field.normals[at]), 1, 1e-12);
    }
    else
    {
      EXPECT_EQ(measured.field.cells[at], -1);
      EXPECT_EQ(Norm(measured.field.normals[at]), 0);
    }
  }
  EXPECT_EQ(measured.report.cells, cells);
  EXPECT_GT(good, 0.99 * static_cast<double>(cells));
}

TEST(WallDepth, QuadraticElementsAreExactForQuadraticFields)
{
  TriangleComplex box;
  shapes::AddBox(box, { 0, 0, 0 }, { 1, 1, 1 }, { { 3, 3, 3 } }, { 1, 0 });
  const Meshed meshed = Fill(box, 0.3);
  const VolumeMesh& mesh = meshed.mesh;
  // Known on the four sides, where x y is linear; through the two ends nothing flows.
  const auto isAt = [&](const Triangle& t, double place)
  {
    return std::all_of(t.begin(), t.end(),
                       [&](Id p) { return box.points[static_cast<std::size_t>(p)].z == place; });
  };
  const auto field = [&](std::size_t p) { return mesh.points[p].x * mesh.points[p].y; };
  std::vector<double> values(mesh.points.size(), 0.5);
  std::vector<char> known(mesh.points.size(), 0);
  std::vector<Triangle> walls;
  for (const Triangle& t : box.triangles)
  {
    if (isAt(t, 0) || isAt(t, 1))
    {
      continue;
    }
    walls.push_back(t);
    for (const Id p : t)
    {
      known[static_cast<std::size_t>(p)] = 1;
      values[static_cast<std::size_t>(p)] = field(static_cast<std::size_t>(p));
    }
  }
  std::vector<Id> cells(static_cast<std::size_t>(mesh.CellCount()));
  std::iota(cells.begin(), cells.end(), Id{ 0 });
  const auto worst = [&]()
  {
    double most = 0;
    for (std::size_t p = 0; p < values.size(); ++p)
    {
      most = std::max(most, std::abs(values[p] - field(p)));
    }
    return most;
  };
  ThreadMonitor monitor(2);
  ASSERT_TRUE(SolveHarmonic(mesh, cells, known, values, monitor));
  EXPECT_GT(worst(), 1e-3); // linear elements are not
  ASSERT_TRUE(SolveQuadraticHarmonic(mesh, cells, known, walls, values, monitor));
  EXPECT_LT(worst(), 1e-5); // of what the steps are to reach
}

TEST(WallDepth, WedgesOfATube)
{
  Meshed meshed;
  meshed.mesh = WedgeTube(96, 10);
  ThreadMonitor monitor(2);
  ASSERT_TRUE(FindPatches(meshed.mesh, nullptr, {}, meshed.patches, monitor));
  // The ends are no wall: the outside is told by pieces that are not flat.
  MeshPatch ends = meshed.patches.patches.back();
  ends.name = "ends";
  ends.kind = PatchKind::Border;
  meshed.patches.patches.push_back(ends);
  for (PatchFace& face : meshed.patches.faces)
  {
    face.patch =
      face.otherCell < 0 && face.face < 2 ? static_cast<int>(meshed.patches.patches.size()) - 1 : face.patch;
  }
  const Measured measured = Measure(meshed, {});
  for (std::size_t p = 0; p < meshed.mesh.points.size(); ++p)
  {
    const double r = std::hypot(meshed.mesh.points[p].x, meshed.mesh.points[p].y);
    if (r > 0.99)
    {
      EXPECT_NEAR(measured.field.points[p], std::log(r) / std::log(2.0), 2e-3);
    }
  }
}

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

TEST(WallDepth, WhatFeelsOneWallOnlyHasNone)
{
  TriangleComplex plate;
  shapes::AddBox(plate, { 0, 0, 0 }, { 3, 3, 1 }, { { 12, 12, 4 } }, { 1, 0 });
  Meshed meshed = Fill(plate, 0.3);
  MeshPatches& patches = meshed.patches;
  // Walls by place: the top is inner, the bottom outer.
  patches.patches.assign(3, patches.patches[0]);
  patches.patches[0].name = "rest";
  patches.patches[1].name = "top";
  patches.patches[2].name = "bottom";
  const auto isAt = [&](const PatchFace& face, double z)
  {
    const CellFace corners = FaceOf(meshed.mesh, face.cell, face.face);
    return std::all_of(corners.corners.begin(), corners.corners.begin() + 3,
                       [&](Id p) { return meshed.mesh.points[static_cast<std::size_t>(p)].z == z; });
  };
  for (PatchFace& face : patches.faces)
  {
    face.patch = isAt(face, 1) ? 1 : (isAt(face, 0) ? 2 : 0);
  }
  WallDepthOptions options;
  options.inner = { "top" };
  options.outer = { "bottom" };
  const Measured whole = Measure(meshed, options);
  EXPECT_EQ(whole.report.oneSided, 0);
  for (std::size_t p = 0; p < meshed.mesh.points.size(); ++p)
  {
    EXPECT_NEAR(whole.field.points[p], 1 - meshed.mesh.points[p].z, 1e-6); // linear elements are exact
  }
  // The side walls count as inner too: what is far from the bottom feels nothing of it.
  options.inner = { "top", "rest" };
  const auto tall = [&]()
  {
    TriangleComplex rod;
    shapes::AddBox(rod, { 0, 0, 0 }, { 1, 1, 5 }, { { 4, 4, 20 } }, { 1, 0 });
    meshed = Fill(rod, 0.3);
    patches.patches.assign(3, patches.patches[0]);
    patches.patches[0].name = "rest";
    patches.patches[1].name = "top";
    patches.patches[2].name = "bottom";
    for (PatchFace& face : patches.faces)
    {
      face.patch = isAt(face, 5) ? 1 : (isAt(face, 0) ? 2 : 0);
    }
    return Measure(meshed, options);
  };
  const Measured rod = tall();
  for (std::size_t p = 0; p < meshed.mesh.points.size(); ++p)
  {
    const double z = meshed.mesh.points[p].z;
    EXPECT_TRUE(z < 3 || rod.field.points[p] == -1) << z;
    EXPECT_TRUE(z > 0 || rod.field.points[p] >= 0) << z;
  }
  EXPECT_GT(rod.report.oneSided, 0);
  EXPECT_GT(rod.report.cells, 0);
}

TEST(WallDepth, APieceWithoutASecondWallHasNone)
{
  TriangleComplex surface = Shell(1, 2, 3);
  shapes::AddSphere(surface, { 5, 0, 0 }, 1, 2, { 1, 0 });
  const Meshed meshed = Fill(surface, 0.4);
  const Measured measured = Measure(meshed, {});
  EXPECT_GT(measured.report.oneSided, 0);
  for (std::size_t p = 0; p < meshed.mesh.points.size(); ++p)
  {
    EXPECT_TRUE(meshed.mesh.points[p].x < 3 || measured.field.points[p] == -1);
  }
}

TEST(WallDepth, ThreadsMakeNoDifferenceAndCancelStops)
{
  const Meshed meshed = Fill(Shell(1, 2, 3), 0.3);
  const Measured one = Measure(meshed, {}, 1);
  const Measured three = Measure(meshed, {}, 3);
  EXPECT_EQ(one.field.points, three.field.points);
  EXPECT_EQ(one.field.normals, three.field.normals);
  ThreadMonitor monitor;
  monitor.Cancel();
  WallDepthField field;
  const auto result = ComputeWallDepth(meshed.mesh, meshed.patches, {}, field, monitor);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.GetError().kind, Failure::Cancelled);
}

TEST(WallDepth, WrongWallsAreNamed)
{
  const Meshed meshed = Fill(Shell(1, 2, 2), 0);
  const auto expect = [&](const WallDepthOptions& options, const char* word)
  {
    ThreadMonitor monitor;
    WallDepthField field;
    const auto result = ComputeWallDepth(meshed.mesh, meshed.patches, options, field, monitor);
    ASSERT_FALSE(result) << word;
    EXPECT_NE(result.GetError().message.find(word), std::string::npos) << result.GetError().message;
  };
  WallDepthOptions options;
  options.inner = { "nowhere" };
  expect(options, "no patch nowhere");
  options.inner = { "1-7" };
  expect(options, "no patch 1-7");
  options.inner = {};
  options.materials = { 9 };
  expect(options, "no inner wall");
}
