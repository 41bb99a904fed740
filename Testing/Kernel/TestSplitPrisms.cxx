// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/SplitPrisms.h"

#include "Geometry/Quality.h"
#include "Mesh/Audit.h"
#include "Mesh/CellFaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace lamina;

namespace
{

/// A slab of wedges, `n` x `n` squares of two, `layers` high, with a pyramid on a side and shuffled point
/// ids.
VolumeMesh MakeSlab(int n, int layers, unsigned seed, double wobble)
{
  std::mt19937 random(seed);
  const auto noise = [&]() { return wobble * (2.0 * (random() % 1000) / 1000 - 1); };
  VolumeMesh mesh;
  const int side = n + 1;
  std::vector<Id> shuffled(static_cast<std::size_t>(side * side * (layers + 1) + 1));
  for (std::size_t i = 0; i < shuffled.size(); ++i)
  {
    shuffled[i] = static_cast<Id>(i);
  }
  std::shuffle(shuffled.begin(), shuffled.end(), random);
  mesh.points.resize(shuffled.size());
  const auto node = [&](int i, int j, int k)
  { return shuffled[static_cast<std::size_t>((k * side + j) * side + i)]; };
  for (int k = 0; k <= layers; ++k)
  {
    for (int j = 0; j < side; ++j)
    {
      for (int i = 0; i < side; ++i)
      {
        mesh.points[static_cast<std::size_t>(node(i, j, k))] = { i + noise(), j + noise(), k + noise() };
      }
    }
  }
  const Id apex = shuffled.back();
  mesh.points[static_cast<std::size_t>(apex)] = { 0.5, -0.7, 0.5 };
  for (int k = 0; k < layers; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        const int corners[2][3][2] = { { { 0, 0 }, { 0, 1 }, { 1, 0 } }, { { 1, 1 }, { 1, 0 }, { 0, 1 } } };
        for (const auto& c : corners)
        {
          std::array<Id, 6> wedge;
          for (std::size_t m = 0; m < 3; ++m)
          {
            wedge[m] = node(i + c[m][0], j + c[m][1], k);
            wedge[m + 3] = node(i + c[m][0], j + c[m][1], k + 1);
          }
          mesh.AddCell(CellType::Wedge, wedge, 1 + k % 2, k + 1);
        }
      }
    }
  }
  mesh.AddCell(CellType::Pyramid,
               std::array<Id, 5>{ { node(0, 0, 0), node(1, 0, 0), node(1, 0, 1), node(0, 0, 1), apex } }, 1,
               0);
  return mesh;
}

AuditReport Audit(const VolumeMesh& mesh)
{
  ThreadMonitor monitor(2);
  AuditMarks marks;
  return *AuditMesh(mesh, nullptr, {}, marks, monitor);
}

} // namespace

TEST(SplitPrisms, MatchAcrossEveryFaceWhateverTheIds)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    const VolumeMesh mesh = MakeSlab(3, 3, seed, 0);
    ASSERT_TRUE(Audit(mesh).Passed()) << Audit(mesh).findings[0];
    ThreadMonitor monitor(2);
    VolumeMesh tets;
    const auto report = SplitPrisms(mesh, tets, nullptr, monitor);
    ASSERT_TRUE(report) << report.GetError().message;
    EXPECT_EQ(report->addedPoints, 0);
    EXPECT_EQ(tets.CellCount(), 3 * 54 + 2);
    const AuditReport audit = Audit(tets);
    EXPECT_TRUE(audit.Passed()) << audit.findings[0];
    // Outer faces: 18 triangles below and above, 12 x 3 quads around of which one bears the pyramid's 4
    // sides.
    const CellFaces faces = FindCellFaces(tets, monitor);
    Id outer = 0;
    for (std::size_t g = 0; g < faces.GroupCount(); ++g)
    {
      outer += faces.start[g + 1] - faces.start[g] == 1;
    }
    EXPECT_EQ(outer, 2 * 18 + 2 * (36 - 1) + 4);
    double volume = 0;
    for (const MaterialAudit& m : audit.materials)
    {
      volume += m.meshVolume;
    }
    EXPECT_NEAR(volume, 27 + 0.7 / 3, 1e-12);
  }
}

TEST(SplitPrisms, WarpedCellsStayPositive)
{
  Id added = 0;
  Id turned = 0;
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    VolumeMesh mesh = MakeSlab(3, 2, seed, 0.12);
    // Twist the top by much: the corners' Jacobians stay positive.
    for (Vec3& p : mesh.points)
    {
      const double angle = 0.6 * (p.z > 1.5 ? 1 : 0);
      p = { 1.5 + std::cos(angle) * (p.x - 1.5) - std::sin(angle) * (p.y - 1.5),
            1.5 + std::sin(angle) * (p.x - 1.5) + std::cos(angle) * (p.y - 1.5), p.z };
    }
    if (Audit(mesh).invertedCells > 0)
    {
      continue;
    }
    ThreadMonitor monitor;
    VolumeMesh tets;
    const auto report = SplitPrisms(mesh, tets, nullptr, monitor);
    ASSERT_TRUE(report) << report.GetError().message;
    added += report->addedPoints;
    turned += report->turnedQuads;
    const AuditReport audit = Audit(tets);
    EXPECT_EQ(audit.invertedCells, 0);
    EXPECT_TRUE(audit.Passed()) << audit.findings[0];
  }
  EXPECT_GT(added + turned, 0) << "the shapes do not need what is tested here";
}

TEST(SplitPrisms, PatchesAreCarriedOver)
{
  const VolumeMesh mesh = MakeSlab(3, 2, 5, 0);
  ThreadMonitor monitor(2);
  MeshPatches patches;
  ASSERT_TRUE(FindPatches(mesh, nullptr, {}, patches, monitor));
  MeshPatches anew;
  VolumeMesh tets;
  ASSERT_TRUE(SplitPrisms(mesh, tets, &patches, monitor));
  ASSERT_TRUE(FindPatches(tets, nullptr, {}, anew, monitor));
  ASSERT_EQ(patches.patches.size(), anew.patches.size());
  for (std::size_t p = 0; p < anew.patches.size(); ++p)
  {
    EXPECT_EQ(patches.patches[p].name, anew.patches[p].name);
    EXPECT_EQ(patches.patches[p].faces, anew.patches[p].faces);
  }
  const auto key = [](const PatchFace& f) {
    return std::array<Id, 5>{ { f.patch, f.cell, f.face, f.otherCell, f.otherFace } };
  };
  std::vector<std::array<Id, 5>> a;
  std::vector<std::array<Id, 5>> b;
  for (const PatchFace& f : patches.faces)
  {
    a.push_back(key(f));
  }
  for (const PatchFace& f : anew.faces)
  {
    b.push_back(key(f));
  }
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  EXPECT_EQ(a, b);
}

TEST(SplitPrisms, InvertedPrismsAreNamed)
{
  VolumeMesh mesh = MakeSlab(2, 1, 1, 0);
  std::swap(mesh.connectivity[0], mesh.connectivity[1]);
  std::swap(mesh.connectivity[3], mesh.connectivity[4]);
  ThreadMonitor monitor;
  VolumeMesh tets;
  const auto report = SplitPrisms(mesh, tets, nullptr, monitor);
  ASSERT_FALSE(report);
  EXPECT_NE(report.GetError().message.find("no positive cut"), std::string::npos);
  EXPECT_FALSE(report.GetError().places.empty());
}
