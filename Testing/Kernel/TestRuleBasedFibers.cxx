// SPDX-License-Identifier: BSD-3-Clause
#include "Volume/RuleBasedFibers.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace lamina;

namespace
{

constexpr double Pi = 3.14159265358979323846;
constexpr int Around = 48;
constexpr int Across = 8;
constexpr int Along = 12;

/// A tube of muscle (1) about z, from radius 1 to 2 and 6 high, of wedges, with blood (2) in two layers
/// within.
VolumeMesh MakeTube()
{
  VolumeMesh mesh;
  const int rings = Across + 3; // two more within, from radius 0.75
  for (int k = 0; k <= Along; ++k)
  {
    for (int j = 0; j < Around; ++j)
    {
      for (int i = 0; i < rings; ++i)
      {
        const double r = 1 + (i - 2) / double(Across);
        const double angle = 2 * Pi * j / Around;
        mesh.points.push_back({ r * std::cos(angle), r * std::sin(angle), 6.0 * k / Along });
      }
    }
  }
  const auto node = [&](int i, int j, int k) { return Id{ i + rings * (j % Around + Around * k) }; };
  for (int k = 0; k < Along; ++k)
  {
    for (int j = 0; j < Around; ++j)
    {
      for (int i = 0; i + 1 < rings; ++i)
      {
        const Id a[4] = { node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k) };
        const Id up = node(0, 0, 1);
        const int material = i < 2 ? 2 : 1;
        mesh.AddCell(CellType::Wedge,
                     std::array<Id, 6>{ { a[0], a[2], a[1], a[0] + up, a[2] + up, a[1] + up } }, material, 0);
        mesh.AddCell(CellType::Wedge,
                     std::array<Id, 6>{ { a[0], a[3], a[2], a[0] + up, a[3] + up, a[2] + up } }, material, 0);
      }
    }
  }
  return mesh;
}

/// Its patches, with the ends of the tube apart from the outside.
MeshPatches MakePatches(const VolumeMesh& mesh)
{
  MeshPatches patches;
  ThreadMonitor monitor;
  EXPECT_TRUE(FindPatches(mesh, nullptr, {}, patches, monitor));
  MeshPatches parted = patches;
  parted.patches.push_back(patches.patches.back());
  parted.patches.back().name = "ends";
  parted.patches.back().kind = PatchKind::Border;
  for (PatchFace& face : parted.faces)
  {
    if (face.otherCell < 0 && face.face < 2)
    {
      face.patch = static_cast<int>(parted.patches.size()) - 1;
    }
  }
  return parted;
}

} // namespace

TEST(RuleBasedFibers, ATubeHasItsHelix)
{
  const VolumeMesh mesh = MakeTube();
  const MeshPatches patches = MakePatches(mesh);
  FiberField field;
  ThreadMonitor monitor(2);
  const auto report = ComputeFibers(mesh, patches, {}, field, monitor);
  ASSERT_TRUE(report) << report.GetError().message;
  EXPECT_NEAR(report->axis.z, 1, 1e-9);
  EXPECT_EQ(report->cells, 2 * Around * Along * Across);
  EXPECT_EQ(report->undecided, 0);
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    const auto at = static_cast<std::size_t>(c);
    if (mesh.materials[at] == 2)
    {
      EXPECT_EQ(field.depth[at], -1);
      EXPECT_EQ(Norm(field.fibers[at]), 0);
      continue;
    }
    Vec3 p;
    for (int k = 0; k < 6; ++k)
    {
      p += mesh.points[static_cast<std::size_t>(mesh.Cell(c)[k])] * (1.0 / 6);
    }
    const double r = std::hypot(p.x, p.y);
    const Vec3 around{ -p.y / r, p.x / r, 0 };
    EXPECT_NEAR(field.depth[at], r - 1, 0.02);
    const double angle = (60 - 120 * (r - 1)) * Pi / 180;
    EXPECT_NEAR(Norm(field.fibers[at]), 1, 1e-12);
    EXPECT_NEAR(Dot(field.fibers[at], around), std::cos(angle), 0.05);
    EXPECT_NEAR(field.fibers[at].z, std::sin(angle), 0.05);
    EXPECT_NEAR(Dot(field.fibers[at], field.sheets[at]), 0, 1e-12);
    EXPECT_GT(Dot(field.sheets[at], { p.x, p.y, 0 }), 0);
  }
}

TEST(RuleBasedFibers, TransverseAngleLeansOut)
{
  const VolumeMesh mesh = MakeTube();
  FiberOptions options;
  options.helixEndo = options.helixEpi = 0;
  options.transverse = 30;
  FiberField field;
  ThreadMonitor monitor;
  ASSERT_TRUE(ComputeFibers(mesh, MakePatches(mesh), options, field, monitor));
  const std::size_t last = mesh.types.size() - 1;
  const Vec3& p = mesh.points[static_cast<std::size_t>(mesh.Cell(static_cast<Id>(last))[1])];
  EXPECT_NEAR(Dot(field.fibers[last], Normalized({ p.x, p.y, 0 })), 0.5, 0.1);
}

TEST(RuleBasedFibers, WrongInputIsNamed)
{
  const VolumeMesh mesh = MakeTube();
  const MeshPatches patches = MakePatches(mesh);
  FiberField field;
  ThreadMonitor monitor;
  FiberOptions options;
  options.helixEndo = 91;
  EXPECT_EQ(ComputeFibers(mesh, patches, options, field, monitor).GetError().kind, Failure::InvalidOption);
  options = {};
  options.epicardium = { "nowhere" };
  EXPECT_NE(ComputeFibers(mesh, patches, options, field, monitor).GetError().message.find("no patch nowhere"),
            std::string::npos);
  options = {};
  options.materials = { 7 };
  EXPECT_NE(ComputeFibers(mesh, patches, options, field, monitor).GetError().message.find("no endocardium"),
            std::string::npos);
  EXPECT_TRUE(field.fibers.empty());
}
