// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/Quality.h"
#include "Mesh/AuditPatches.h"
#include "Mesh/CellFaces.h"
#include "Mesh/MeshPatches.h"
#include "Mesh/PieceOrder.h"
#include "Mesh/PointTable.h"
#include "Mesh/SplitInterfaces.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

using namespace lamina;

namespace
{

/// A box of n x n x n cubes, six tets each, of edge 1 in all; a cube's material by its middle, 0 for none.
VolumeMesh MakeBlocks(int n, const std::function<int(const Vec3&)>& materialAt)
{
  VolumeMesh mesh;
  PointTable table;
  constexpr int paths[6][2] = { { 1, 3 }, { 1, 5 }, { 2, 3 }, { 2, 6 }, { 4, 5 }, { 4, 6 } };
  for (int cube = 0; cube < n * n * n; ++cube)
  {
    const std::array<int, 3> at{ { cube % n, cube / n % n, cube / n / n } };
    const auto corner = [&](int bits)
    {
      return table.Insert({ (at[0] + (bits & 1)) / double(n), (at[1] + (bits >> 1 & 1)) / double(n),
                            (at[2] + (bits >> 2 & 1)) / double(n) });
    };
    const int material = materialAt({ (at[0] + 0.5) / n, (at[1] + 0.5) / n, (at[2] + 0.5) / n });
    for (const auto& path : paths)
    {
      std::array<Id, 4> tet{ { corner(0), corner(path[0]), corner(path[1]), corner(7) } };
      const auto& p = table.GetPoints();
      const auto point = [&](std::size_t k) { return p[static_cast<std::size_t>(tet[k])]; };
      if (TetVolume(point(0), point(1), point(2), point(3)) < 0)
      {
        std::swap(tet[1], tet[2]);
      }
      if (material != 0)
      {
        mesh.AddCell(CellType::Tetrahedron, tet, material, 0);
      }
    }
  }
  mesh.points = table.GetPoints();
  mesh.layerIndex.assign(mesh.points.size(), -1);
  mesh.interfaceNodeIds.assign(mesh.points.size(), -1);
  return mesh;
}

/// Two chambers of blood (2), the left one larger, in tissue (1) without air.
int Chambers(const Vec3& p)
{
  const auto in = [&](double low, double high, double side)
  { return p.x > low && p.x < high && std::abs(p.y - 0.5) < side && std::abs(p.z - 0.5) < side; };
  return in(0.1, 0.45, 0.3) || in(0.6, 0.8, 0.15) ? 2 : 1;
}

MeshPatches Find(const VolumeMesh& mesh, const TriangleComplex* surface = nullptr,
                 const std::map<std::string, std::string>& names = {})
{
  ThreadMonitor monitor(2);
  MeshPatches patches;
  const auto report = FindPatches(mesh, surface, { 1, names }, patches, monitor);
  EXPECT_TRUE(report);
  return patches;
}

} // namespace

TEST(MeshPatches, AreNamedBySizeAndPlaceUnderAnyMeshSize)
{
  for (int n : { 10, 20, 30 })
  {
    const VolumeMesh mesh = MakeBlocks(n, Chambers);
    const MeshPatches found = Find(mesh);
    ASSERT_EQ(found.patches.size(), 3u) << n;
    EXPECT_EQ(found.patches[0].name, "interface_1_2_1");
    EXPECT_LT(found.patches[0].centre.x, 0.4); // the large chamber
    EXPECT_EQ(found.patches[1].name, "interface_1_2_2");
    EXPECT_GT(found.patches[1].centre.x, 0.5);
    EXPECT_EQ(found.patches[2].name, "wall_1_1");
    EXPECT_NEAR(found.patches[2].area, 6, 1e-12);
    EXPECT_EQ(found.patches[2].faces, 12 * n * n);
  }
}

TEST(MeshPatches, FacesLieOnTheFirstMaterialAndKnowTheOtherSide)
{
  const VolumeMesh mesh = MakeBlocks(10, Chambers);
  const MeshPatches found = Find(mesh);
  for (const PatchFace& face : found.faces)
  {
    const MeshPatch& patch = found.patches[static_cast<std::size_t>(face.patch)];
    EXPECT_EQ(mesh.materials[static_cast<std::size_t>(face.cell)], patch.pair.first);
    if (patch.kind == PatchKind::Interface)
    {
      EXPECT_EQ(mesh.materials[static_cast<std::size_t>(face.otherCell)], patch.pair.second);
      EXPECT_TRUE(
        AreOpposite(FaceOf(mesh, face.cell, face.face), FaceOf(mesh, face.otherCell, face.otherFace)));
    }
    else
    {
      EXPECT_EQ(face.otherCell, -1);
    }
  }
}

TEST(MeshPatches, NamesOfMaterialsAndPatchesAreReplaced)
{
  const VolumeMesh mesh = MakeBlocks(10, Chambers);
  ThreadMonitor monitor;
  MeshPatches patches;
  const auto report = FindPatches(
    mesh, nullptr,
    { 1, { { "1", "tissue" }, { "2", "blood" }, { "wall_tissue_1", "epicardium" }, { "7", "bone" } } },
    patches, monitor);
  ASSERT_TRUE(report);
  EXPECT_EQ(patches.patches[0].name, "interface_tissue_blood_1");
  EXPECT_EQ(patches.patches[2].name, "epicardium");
  EXPECT_EQ(MaterialName(patches.materialNames, 2), "blood");
  EXPECT_EQ(report->unusedNames, std::vector<std::string>{ "7" });
}

TEST(MeshPatches, OpeningsAndBordersComeFromTheSurface)
{
  // Blood from end to end along z, open at the bottom; tissue's border at the top.
  const VolumeMesh mesh = MakeBlocks(
    4, [](const Vec3& p) { return std::abs(p.x - 0.5) < 0.25 && std::abs(p.y - 0.5) < 0.25 ? 2 : 1; });
  TriangleComplex surface;
  surface.patchNames = { "wall", "opening_1", "border_3" };
  std::map<Id, Id> numbers;
  for (const PatchFace& face : Find(mesh).faces)
  {
    Triangle t;
    double height = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id node = FaceOf(mesh, face.cell, face.face).corners[k];
      const auto [at, isNew] = numbers.emplace(node, static_cast<Id>(surface.points.size()));
      if (isNew)
      {
        surface.points.push_back(mesh.points[static_cast<std::size_t>(node)]);
      }
      t[k] = at->second;
      height += surface.points[static_cast<std::size_t>(at->second)].z;
    }
    const int material = mesh.materials[static_cast<std::size_t>(face.cell)];
    const bool isInner = face.otherCell >= 0;
    surface.triangles.push_back(t);
    surface.materials.push_back({ material, isInner ? 2 : 0 });
    surface.patches.push_back(isInner ? 0 : (height == 0 && material == 2 ? 1 : (height == 3 ? 2 : 0)));
  }
  const MeshPatches found = Find(mesh, &surface);
  std::set<std::string> names;
  for (const MeshPatch& patch : found.patches)
  {
    names.insert(patch.name);
  }
  EXPECT_EQ(names, (std::set<std::string>{ "border_1_1", "border_2_1", "interface_1_2_1", "opening_2_1",
                                           "wall_1_1" }));
  EXPECT_EQ(found.patches.back().kind, PatchKind::Opening);
  EXPECT_NEAR(found.patches.back().area, 0.25, 1e-14);
}

TEST(MeshPatches, AFluidWithoutWallAndNothingAtAll)
{
  const MeshPatches fluid = Find(MakeBlocks(3, [](const Vec3&) { return 2; }));
  ASSERT_EQ(fluid.patches.size(), 1u);
  EXPECT_EQ(fluid.patches[0].name, "wall_2_1");
  EXPECT_TRUE(Find(VolumeMesh{}).patches.empty());
  ThreadMonitor monitor;
  MeshPatches patches;
  EXPECT_EQ(FindPatches(VolumeMesh{}, nullptr, { 0, {} }, patches, monitor).GetError().kind,
            Failure::InvalidOption);
}

TEST(MeshPatches, ManyPiecesOfSteppedSizesAreInOrder)
{
  // Bars of blood that differ by a tenth or less, one to the next, and not in the order of their places.
  const int lengths[6] = { 20, 24, 21, 25, 22, 23 };
  const auto material = [&](const Vec3& p)
  {
    const int bar = static_cast<int>(p.x * 6);
    const double inBar = p.x * 6 - bar;
    const bool isIn =
      inBar > 0.3 && inBar < 0.7 && std::abs(p.y - 0.5) < 0.1 && p.z > 0.1 && p.z < 0.1 + lengths[bar] / 30.0;
    return isIn ? 2 : 1;
  };
  VolumeMesh mesh = MakeBlocks(30, material);
  const MeshPatches found = Find(mesh);
  ASSERT_EQ(found.patches.size(), 7u);
  std::vector<unsigned char> flags(mesh.types.size(), 0);
  PatchAudit audit = AuditPatches(mesh, found, Find(mesh), false, flags);
  EXPECT_TRUE(audit.findings.empty()) << audit.findings[0];
  MeshPatches swapped = found;
  for (PatchFace& face : swapped.faces)
  {
    face.patch = face.patch == 1 ? 4 : (face.patch == 4 ? 1 : face.patch);
  }
  audit = AuditPatches(mesh, swapped, Find(mesh), false, flags);
  ASSERT_EQ(audit.findings.size(), 1u);
  EXPECT_NE(audit.findings[0].find("wrong order"), std::string::npos);
}

TEST(PieceOrder, NearlyEqualSizesGoByPlace)
{
  const std::vector<Piece> a = { { 1, { 0.9, 0, 0 } }, { 1.02, { 0.1, 0, 0 } }, { 5, { 0.5, 0, 0 } } };
  const std::vector<Piece> b = { { 1.02, { 0.9, 0, 0 } }, { 1, { 0.1, 0.001, 0 } }, { 5.1, { 0.5, 0, 0 } } };
  const std::vector<std::size_t> expected{ 2, 1, 0 };
  EXPECT_EQ(OrderPieces(a, 1), expected);
  EXPECT_EQ(OrderPieces(b, 1), expected);
}

TEST(SplitInterfaces, FluidsGetTwinsOfEverySharedNode)
{
  VolumeMesh mesh = MakeBlocks(10, Chambers);
  std::vector<std::set<int>> before(mesh.points.size());
  for (std::size_t i = 0; i < mesh.connectivity.size(); ++i)
  {
    before[static_cast<std::size_t>(mesh.connectivity[i])].insert(mesh.materials[i / 4]);
  }
  Id shared = 0;
  for (const auto& materials : before)
  {
    shared += materials.size() == 2;
  }
  const std::size_t points = mesh.points.size();
  std::vector<Id> twins;
  ThreadMonitor monitor;
  const auto report = SplitInterfaces(mesh, { 2 }, twins, monitor);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->twins, shared);
  ASSERT_EQ(twins.size(), mesh.points.size());
  std::vector<std::set<int>> after(mesh.points.size());
  for (std::size_t i = 0; i < mesh.connectivity.size(); ++i)
  {
    after[static_cast<std::size_t>(mesh.connectivity[i])].insert(mesh.materials[i / 4]);
  }
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    EXPECT_EQ(after[p].size(), 1u);
    if (twins[p] >= 0)
    {
      EXPECT_EQ(twins[static_cast<std::size_t>(twins[p])], static_cast<Id>(p));
      EXPECT_TRUE(mesh.points[p] == mesh.points[static_cast<std::size_t>(twins[p])]);
      EXPECT_EQ(*after[p].begin(), p < points ? 1 : 2);
    }
  }
}
