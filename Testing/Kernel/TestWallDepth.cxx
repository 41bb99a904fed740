// SPDX-License-Identifier: BSD-3-Clause
#include "FilledWalls.h"
#include "Shapes.h"

#include <algorithm>
#include <cmath>

using namespace lamina;
using namespace lamina::walls;

namespace
{

constexpr double Pi = 3.14159265358979323846;

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
