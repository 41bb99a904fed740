// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Audit.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace lamina;

namespace
{

struct Sandwich
{
  VolumeMesh mesh;
  TriangleComplex surface;
};

Id AddPoint(VolumeMesh& mesh, const Vec3& p)
{
  const auto found = std::find(mesh.points.begin(), mesh.points.end(), p);
  if (found != mesh.points.end())
  {
    return found - mesh.points.begin();
  }
  mesh.points.push_back(p);
  return static_cast<Id>(mesh.points.size()) - 1;
}

/// Tets from the middle to the triangles of a box, whose normals point out.
void AddFan(Sandwich& s, const TriangleComplex& box, const Vec3& middle, int material)
{
  const Id apex = AddPoint(s.mesh, middle);
  for (const Triangle& t : box.triangles)
  {
    std::array<Id, 4> tet;
    for (std::size_t k = 0; k < 3; ++k)
    {
      tet[k] = AddPoint(s.mesh, box.points[static_cast<std::size_t>(t[2 - k])]);
    }
    tet[3] = apex;
    s.mesh.AddCell(CellType::Tetrahedron, tet, material, 0);
  }
}

/// A cube of tets of material 1, on top of it a slab of wedges of material 2 that is open at its sides.
Sandwich MakeSandwich()
{
  Sandwich s;
  TriangleComplex lower;
  shapes::AddBox(lower, { 0, 0, 0 }, { 2, 2, 2 }, { { 2, 2, 2 } }, { 1, 0 });
  AddFan(s, lower, { 1, 1.1, 0.9 }, 1);
  // Wedges stand on the lower box's top; the surface round both.
  TriangleComplex& surface = s.surface;
  const auto map = [&](const Vec3& p)
  {
    const auto found = std::find(surface.points.begin(), surface.points.end(), p);
    if (found == surface.points.end())
    {
      surface.points.push_back(p);
      return static_cast<Id>(surface.points.size()) - 1;
    }
    return static_cast<Id>(found - surface.points.begin());
  };
  const Vec3 up{ 0, 0, 1 };
  for (const Triangle& t : lower.triangles)
  {
    std::array<Vec3, 3> c;
    bool isTop = true;
    for (std::size_t k = 0; k < 3; ++k)
    {
      c[k] = lower.points[static_cast<std::size_t>(t[k])];
      isTop = isTop && c[k].z == 2;
    }
    surface.triangles.push_back({ { map(c[0]), map(c[1]), map(c[2]) } });
    surface.materials.push_back(isTop ? MaterialPair{ 1, 2 } : MaterialPair{ 1, 0 });
    if (isTop)
    {
      std::array<Id, 6> wedge;
      for (std::size_t k = 0; k < 3; ++k)
      {
        wedge[k] = AddPoint(s.mesh, c[2 - k]);
        wedge[k + 3] = AddPoint(s.mesh, c[2 - k] + up);
      }
      s.mesh.AddCell(CellType::Wedge, wedge, 2, 1);
      surface.triangles.push_back({ { map(c[0] + up), map(c[1] + up), map(c[2] + up) } });
      surface.materials.push_back({ 2, 0 });
    }
  }
  // The sides of the wedges are an opening each: plane, and triangulated otherwise than the wedges' quads.
  surface.patches.assign(surface.triangles.size(), 0);
  surface.patchNames = { "wall", "opening_1", "opening_2", "opening_3", "opening_4" };
  const Vec3 corners[4] = { { 0, 0, 2 }, { 2, 0, 2 }, { 2, 2, 2 }, { 0, 2, 2 } };
  for (int side = 0; side < 4; ++side)
  {
    const Vec3 a = corners[side];
    const Vec3 c = corners[(side + 1) % 4];
    const Vec3 b = 0.5 * (a + c);
    const Id ids[6] = { map(a), map(b), map(c), map(a + up), map(b + up), map(c + up) };
    const Triangle sides[4] = { { { ids[0], ids[1], ids[4] } },
                                { { ids[0], ids[4], ids[3] } },
                                { { ids[1], ids[2], ids[5] } },
                                { { ids[1], ids[5], ids[4] } } };
    for (const Triangle& t : sides)
    {
      surface.triangles.push_back(t);
      surface.materials.push_back({ 2, 0 });
      surface.patches.push_back(side + 1);
    }
  }
  return s;
}

AuditReport Audit(const VolumeMesh& mesh, const TriangleComplex* surface, AuditMarks& marks, double scale = 1)
{
  ThreadMonitor monitor(2);
  AuditOptions options;
  options.surfaceScale = scale;
  const auto result = AuditMesh(mesh, surface, options, marks, monitor);
  EXPECT_TRUE(result);
  return *result;
}

AuditReport Audit(const Sandwich& s)
{
  AuditMarks marks;
  return Audit(s.mesh, &s.surface, marks);
}

std::string All(const AuditReport& report)
{
  std::string text;
  for (const std::string& finding : report.findings)
  {
    text += finding + "\n";
  }
  return text;
}

} // namespace

TEST(Audit, ASoundMeshPasses)
{
  const Sandwich s = MakeSandwich();
  const AuditReport report = Audit(s);
  EXPECT_TRUE(report.Passed()) << All(report);
  ASSERT_EQ(report.materials.size(), 2u);
  EXPECT_EQ(report.materials[0].tets, 48);
  EXPECT_EQ(report.materials[1].wedges, 8);
  EXPECT_EQ(report.materials[0].components, 1);
  EXPECT_EQ(report.materials[1].components, 1);
  EXPECT_NEAR(report.materials[0].meshVolume, 8, 1e-13);
  EXPECT_NEAR(report.materials[1].surfaceVolume, 4, 1e-13);
  EXPECT_LT(report.largestVolumeError, 1e-14);
  EXPECT_EQ(report.interfaceTriangles, 8);
  EXPECT_GT(report.materials[0].tetQualityMin, 0);
  EXPECT_LE(report.materials[0].tetQualityMin, report.materials[0].tetQualityP1);
  EXPECT_LE(report.materials[0].tetQualityP1, report.materials[0].tetQualityP50);
  EXPECT_NEAR(report.materials[1].wedgeQualityMin, std::sqrt(2.0 / 3), 1e-12);
}

TEST(Audit, TheSurfaceMayBeScaledOrAbsent)
{
  Sandwich s = MakeSandwich();
  for (Vec3& p : s.mesh.points)
  {
    p *= 0.001;
  }
  AuditMarks marks;
  EXPECT_TRUE(Audit(s.mesh, &s.surface, marks, 0.001).Passed());
  EXPECT_FALSE(Audit(s.mesh, &s.surface, marks).Passed());
  const AuditReport alone = Audit(s.mesh, nullptr, marks);
  EXPECT_TRUE(alone.Passed());
  EXPECT_TRUE(std::isnan(alone.materials[0].surfaceVolume));
  EXPECT_EQ(marks.flags, std::vector<unsigned char>(marks.flags.size(), 0));
}

TEST(Audit, InvertedCellsAreFound)
{
  Sandwich s = MakeSandwich();
  std::swap(s.mesh.connectivity[0], s.mesh.connectivity[1]);
  AuditMarks marks;
  const AuditReport report = Audit(s.mesh, &s.surface, marks);
  EXPECT_EQ(report.invertedCells, 1);
  EXPECT_EQ(marks.flags[0] & FlagInverted, FlagInverted);
  EXPECT_LT(marks.quality[0], 0);
  EXPECT_GT(report.mismatchedFaces, 0); // and its faces look the wrong way
  EXPECT_NE(All(report).find("inverted"), std::string::npos);
}

TEST(Audit, MissingCellsAreFound)
{
  Sandwich s = MakeSandwich();
  VolumeMesh& mesh = s.mesh; // drop the last wedge
  mesh.types.pop_back();
  mesh.materials.pop_back();
  mesh.layers.pop_back();
  mesh.offsets.pop_back();
  mesh.connectivity.resize(static_cast<std::size_t>(mesh.offsets.back()));
  const AuditReport report = Audit(s);
  EXPECT_EQ(report.interfaceMismatches, 1);
  EXPECT_EQ(report.wallMismatches, 1);
  EXPECT_GT(report.openFaces, 0);
  EXPECT_GT(report.overlaps, 0);
  EXPECT_NEAR(report.largestVolumeError, 1.0 / 8, 1e-12);
  EXPECT_NE(All(report).find("in no cell"), std::string::npos);
  EXPECT_NE(All(report).find("opening"), std::string::npos);
}

TEST(Audit, DoubledCellsAndPointsAreFound)
{
  Sandwich s = MakeSandwich();
  std::array<Id, 4> tet;
  std::copy_n(s.mesh.connectivity.begin(), 4, tet.begin());
  s.mesh.AddCell(CellType::Tetrahedron, tet, 1, 0);
  AuditMarks marks;
  AuditReport report = Audit(s.mesh, &s.surface, marks);
  EXPECT_EQ(report.facesOfManyCells, 3);
  EXPECT_GT(report.overlaps, 0);
  EXPECT_NE(marks.flags[0] & FlagOverlap, 0);
  EXPECT_NE(marks.flags[0] & FlagNonConforming, 0);

  s = MakeSandwich();
  s.mesh.points.push_back(s.mesh.points[3]);
  report = Audit(s);
  EXPECT_EQ(report.duplicatePoints, 1);
  EXPECT_EQ(report.unusedPoints, 1);
  // A crack: one tet goes by the copy.
  s.mesh.connectivity[static_cast<std::size_t>(
    std::find(s.mesh.connectivity.begin(), s.mesh.connectivity.end(), 3) - s.mesh.connectivity.begin())] =
    static_cast<Id>(s.mesh.points.size()) - 1;
  report = Audit(s);
  EXPECT_EQ(report.unusedPoints, 0);
  EXPECT_GT(report.openFaces, 0);
}

TEST(Audit, WrongMaterialsAreFound)
{
  Sandwich s = MakeSandwich();
  s.mesh.materials.front() = 2;
  const AuditReport report = Audit(s);
  EXPECT_GT(report.strayInterfaces, 0);
  EXPECT_GT(report.interfaceMismatches + report.wallMismatches, 0);
  EXPECT_EQ(report.materials[1].components, 2);
  s.mesh.materials.assign(s.mesh.materials.size(), 5);
  EXPECT_NE(All(Audit(s)).find("material 5 is in the mesh but not in the surface"), std::string::npos);
}

TEST(Audit, QuadsThatMeetTrianglesAreFound)
{
  // A wedge whose side meets two tets.
  VolumeMesh mesh;
  mesh.points = { { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 },     { 0, 0, 1 },
                  { 0, 1, 1 }, { 1, 0, 1 }, { -1, 0.5, 0.5 } };
  mesh.AddCell(CellType::Wedge, std::array<Id, 6>{ { 0, 1, 2, 3, 4, 5 } }, 1, 0);
  mesh.AddCell(CellType::Tetrahedron, std::array<Id, 4>{ { 0, 3, 4, 6 } }, 1, 0);
  mesh.AddCell(CellType::Tetrahedron, std::array<Id, 4>{ { 0, 4, 1, 6 } }, 1, 0);
  AuditMarks marks;
  EXPECT_EQ(Audit(mesh, nullptr, marks).mismatchedFaces, 1);
  // With a pyramid instead all is well.
  mesh = VolumeMesh{ mesh.points, {}, { 0 }, {}, {}, {}, {}, {} };
  mesh.AddCell(CellType::Wedge, std::array<Id, 6>{ { 0, 1, 2, 3, 4, 5 } }, 1, 0);
  mesh.AddCell(CellType::Pyramid, std::array<Id, 5>{ { 0, 3, 4, 1, 6 } }, 1, 0);
  const AuditReport report = Audit(mesh, nullptr, marks);
  EXPECT_TRUE(report.Passed()) << All(report);
  EXPECT_EQ(report.materials[0].components, 1);
  EXPECT_NEAR(report.materials[0].meshVolume, 0.5 + 1.0 / 3, 1e-14);
}

TEST(Audit, BadInputIsNamedAndEmptyPasses)
{
  ThreadMonitor monitor;
  AuditMarks marks;
  Sandwich s = MakeSandwich();
  AuditOptions options;
  options.surfaceScale = 0;
  EXPECT_EQ(AuditMesh(s.mesh, nullptr, options, marks, monitor).GetError().kind, Failure::InvalidOption);
  s.mesh.connectivity[3] = 12345;
  EXPECT_NE(AuditMesh(s.mesh, nullptr, {}, marks, monitor).GetError().message.find("12345"),
            std::string::npos);
  EXPECT_TRUE(AuditMesh({}, nullptr, {}, marks, monitor)->Passed());
}
