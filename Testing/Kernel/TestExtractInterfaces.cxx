// SPDX-License-Identifier: BSD-3-Clause
#include "Images.h"
#include "Mesh/Closedness.h"
#include "Mesh/PointTable.h"
#include "Mesh/VolumeCorrection.h"
#include "Surface/ExtractInterfaces.h"

#include <gtest/gtest.h>

using namespace lamina;

namespace
{

ExtractInterfacesReport Extract(const LabelImage& image, TriangleComplex& surface, int threads = 1)
{
  ThreadMonitor monitor(threads);
  const auto report = ExtractInterfaces(image, surface, {}, monitor);
  EXPECT_TRUE(report) << (report ? "" : report.GetError().message);
  return report ? *report : ExtractInterfacesReport{};
}

void ExpectSound(const TriangleComplex& surface, const std::string& what)
{
  ThreadMonitor monitor;
  const auto error = CheckClosed(surface, true, monitor);
  EXPECT_FALSE(error) << what << ": " << (error ? error->message : "");
  PointTable table(surface.points.size());
  for (const Vec3& p : surface.points)
  {
    table.Insert(p);
  }
  EXPECT_EQ(table.GetPoints().size(), surface.points.size()) << what;
  std::vector<char> used(surface.points.size(), 0);
  for (const Triangle& t : surface.triangles)
  {
    for (Id p : t)
    {
      used[static_cast<std::size_t>(p)] = 1;
    }
  }
  EXPECT_EQ(std::count(used.begin(), used.end(), 0), 0) << what;
}

/// The label of the voxel around a world position; the direction matrix must be orthogonal.
int LabelAt(const LabelImage& image, const Vec3& place)
{
  const Vec3 d = place - image.grid.origin;
  const auto& m = image.grid.direction;
  std::array<Id, 3> v{};
  for (std::size_t c = 0; c < 3; ++c)
  {
    const double along = m[c] * d.x + m[3 + c] * d.y + m[6 + c] * d.z;
    v[c] = static_cast<Id>(std::llround(along / image.grid.spacing[static_cast<int>(c)]));
    if (v[c] < 0 || v[c] >= image.grid.size[c])
    {
      return 0;
    }
  }
  return image.labels[static_cast<std::size_t>(image.grid.Index(v[0], v[1], v[2]))];
}

/// Every triangle has its first material behind it and its second one in front.
void ExpectFacing(const LabelImage& image, const TriangleComplex& surface, double step)
{
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    Vec3 centre;
    for (Id p : surface.triangles[t])
    {
      centre += (1.0 / 3) * surface.points[static_cast<std::size_t>(p)];
    }
    const Vec3 normal = Normalized(AreaVector2(surface.points, surface.triangles[t]));
    ASSERT_EQ(LabelAt(image, centre - step * normal), surface.materials[t].first) << t;
    ASSERT_EQ(LabelAt(image, centre + step * normal), surface.materials[t].second) << t;
    ASSERT_TRUE(surface.materials[t].second == 0 || surface.materials[t].first < surface.materials[t].second);
    ASSERT_NE(surface.materials[t].first, 0);
  }
}

void ExpectVolumes(const LabelImage& image, const TriangleComplex& surface, double tolerance)
{
  const auto materials = MaterialsOf(surface);
  const auto volumes = MaterialVolumes(surface, materials);
  for (std::size_t m = 0; m < materials.size(); ++m)
  {
    const double expected = images::CountOf(image, materials[m]) * image.grid.VoxelVolume();
    EXPECT_NEAR(volumes[m], expected, tolerance * expected) << materials[m];
  }
}

void ExpectError(const LabelImage& image, const ExtractInterfacesOptions& options, const char* word)
{
  ThreadMonitor monitor;
  TriangleComplex surface;
  const auto result = ExtractInterfaces(image, surface, options, monitor);
  ASSERT_FALSE(result) << word;
  EXPECT_EQ(result.GetError().kind, Failure::InvalidInput);
  EXPECT_NE(result.GetError().message.find(word), std::string::npos) << result.GetError().message;
  EXPECT_TRUE(surface.points.empty());
}

} // namespace

TEST(ExtractInterfaces, VolumesAreThoseOfTheVoxelsExactly)
{
  for (const LabelImage& image :
       { images::Ball(12, 4.6), images::Shell(14, 3.4, 5.8), images::Sectors(12, 4.7, true) })
  {
    TriangleComplex surface;
    const auto report = Extract(image, surface);
    ASSERT_EQ(report.repairedVoxels, 0);
    EXPECT_EQ(report.points, static_cast<Id>(surface.points.size()));
    EXPECT_EQ(report.triangles, static_cast<Id>(surface.triangles.size()));
    EXPECT_EQ(report.materials, MaterialsOf(surface));
    ExpectVolumes(image, surface, 0);
    ExpectSound(surface, "shape");
    ExpectFacing(image, surface, 0.3);
  }
}

TEST(ExtractInterfaces, OriginSpacingAndDirectionAreHonoured)
{
  const double c = std::cos(0.6);
  const double s = std::sin(0.6);
  const std::array<std::array<double, 9>, 4> directions{ { { { 1, 0, 0, 0, 1, 0, 0, 0, 1 } },
                                                           { { -1, 0, 0, 0, 1, 0, 0, 0, 1 } },
                                                           { { c, 0, s, 0, 1, 0, -s, 0, c } },
                                                           { { c, -s, 0, s, c, 0, 0, 0, -1 } } } };
  for (const auto& direction : directions)
  {
    LabelImage image = images::Shell(12, 2.7, 4.8);
    image.grid.origin = { 103.5, -20, 7 };
    image.grid.spacing = { 0.5, 0.75, 2 };
    image.grid.direction = direction;
    TriangleComplex surface;
    Extract(image, surface);
    ExpectVolumes(image, surface, 1e-12);
    ExpectFacing(image, surface, 0.1);
    ExpectSound(surface, "turned");
  }
}

TEST(ExtractInterfaces, PointsStandBetweenVoxels)
{
  LabelImage image =
    images::Make({ { 3, 3, 3 } }, [](Id i, Id j, Id k) { return i == 1 && j == 1 && k == 1; });
  TriangleComplex surface;
  const auto report = Extract(image, surface);
  EXPECT_EQ(report.points, 8);
  EXPECT_EQ(report.triangles, 12);
  for (const Vec3& p : surface.points)
  {
    EXPECT_EQ(std::abs(p.x - 1), 0.5);
    EXPECT_EQ(std::abs(p.y - 1), 0.5);
    EXPECT_EQ(std::abs(p.z - 1), 0.5);
  }
}

TEST(ExtractInterfaces, JunctionsOfThreeMaterials)
{
  const LabelImage image = images::Sectors(12, 4.7, true);
  TriangleComplex surface;
  const auto report = Extract(image, surface);
  Id corners = 0;
  Id axis = 0;
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    corners += surface.junctionKind[p] == JunctionCorner ? 1 : 0;
    axis += surface.junctionKind[p] == JunctionCurve && surface.junctionOrder[p] == 3 ? 1 : 0;
    const int expected = surface.junctionKind[p] == JunctionSheet ? 2 : 3;
    EXPECT_GE(surface.junctionOrder[p], expected);
  }
  EXPECT_EQ(corners, 2); // the ends of the line where 1, 2 and 3 meet
  EXPECT_GT(axis, 0);
  // Each point of a curve has two of its edges, each corner four.
  EXPECT_EQ(report.junctionCurveEdges, (2 * axis + 4 * corners) / 2);
}

TEST(ExtractInterfaces, NoiseIsClosedAndManifold)
{
  for (unsigned seed = 0; seed < 100; ++seed)
  {
    const LabelImage image = images::Noise(10, 2 + static_cast<int>(seed % 4), seed);
    TriangleComplex surface;
    const auto report = Extract(image, surface);
    EXPECT_GT(report.repairedVoxels, 0);
    ExpectSound(surface, "seed " + std::to_string(seed));
  }
}

TEST(ExtractInterfaces, RepairedPlacesAreTold)
{
  LabelImage image = images::Make({ { 6, 6, 6 } },
                                  [](Id i, Id j, Id k)
                                  {
                                    const bool block = i >= 1 && i <= 2 && j >= 1 && j <= 2;
                                    return k >= 1 && k <= 4 && (block || (i == 3 && j == 3 && k == 2));
                                  });
  image.grid.spacing = { 2, 2, 2 };
  TriangleComplex surface;
  const auto report = Extract(image, surface);
  EXPECT_EQ(report.repairedVoxels, 1);
  ASSERT_EQ(report.repairedPlaces.size(), 1u);
  EXPECT_LE(Norm(report.repairedPlaces[0] - Vec3{ 5, 5, 4 }), std::sqrt(3.0) * 1.001);
}

TEST(ExtractInterfaces, ThreadsMakeNoDifference)
{
  const LabelImage image = images::Noise(14, 4, 11);
  TriangleComplex one;
  TriangleComplex three;
  Extract(image, one, 1);
  Extract(image, three, 3);
  EXPECT_EQ(one.points, three.points);
  EXPECT_EQ(one.triangles, three.triangles);
  EXPECT_EQ(one.materials, three.materials);
  EXPECT_EQ(one.patches, three.patches);
  EXPECT_EQ(one.junctionKind, three.junctionKind);
}

TEST(ExtractInterfaces, BadImagesAreRefused)
{
  const auto flat = images::Make({ { 5, 5, 1 } }, [](Id, Id, Id) { return 1; });
  ExpectError(flat, {}, "three-dimensional");
  LabelImage image = images::Ball(6, 2);
  image.labels[3] = -1;
  ExpectError(image, {}, "-1");
  image.labels[3] = 65536;
  ExpectError(image, {}, "65536");
  image.labels.assign(image.labels.size(), 0);
  ExpectError(image, {}, "background");
  image.labels.pop_back();
  ExpectError(image, {}, "values");
  const LabelImage mask = images::Ball(7, 2);
  ExtractInterfacesOptions options;
  options.mask = &mask;
  ExpectError(images::Ball(6, 2), options, "mask");
}

TEST(ExtractInterfaces, Cancel)
{
  ThreadMonitor monitor;
  monitor.Cancel();
  TriangleComplex surface;
  const auto result = ExtractInterfaces(images::Ball(12, 4), surface, {}, monitor);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.GetError().kind, Failure::Cancelled);
}
