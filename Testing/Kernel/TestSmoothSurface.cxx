// SPDX-License-Identifier: BSD-3-Clause
#include "Images.h"
#include "Mesh/Closedness.h"
#include "Mesh/VolumeCorrection.h"
#include "Search/SelfIntersection.h"
#include "Shapes.h"
#include "Surface/ExtractInterfaces.h"
#include "Surface/SmoothSurface.h"

#include <gtest/gtest.h>

#include <limits>

using namespace lamina;

namespace
{

TriangleComplex Extract(const LabelImage& image)
{
  ThreadMonitor monitor;
  TriangleComplex surface;
  EXPECT_TRUE(ExtractInterfaces(image, surface, {}, monitor));
  return surface;
}

/// Smooths, and expects the volumes that are held to a part in 10^12, no intersections and the same
/// triangles.
SmoothSurfaceReport SmoothAndCheck(TriangleComplex& surface, const std::string& what)
{
  ThreadMonitor monitor(2);
  const TriangleComplex before = surface;
  const auto report = SmoothSurface(surface, {}, monitor);
  EXPECT_TRUE(report) << what << ": " << (report ? "" : report.GetError().message);
  if (!report)
  {
    return {};
  }
  EXPECT_GE(report->sweepsDone, 12) << what;
  EXPECT_EQ(report->materials, MaterialsOf(surface)) << what;
  const auto old = MaterialVolumes(before, report->materials);
  const auto now = MaterialVolumes(surface, report->materials);
  for (std::size_t m = 0; m < now.size(); ++m)
  {
    // A repaired image has other volumes; what of small pieces is out of reach is told, piece by piece.
    double held = report->volumesHeld[m];
    for (const MissedPiece& piece : report->missedPieces)
    {
      held += piece.material == report->materials[m] ? piece.volume - piece.target : 0;
    }
    const double most = report->missedPieces.empty() ? 1e-12 * old[m] : 1e-6;
    EXPECT_NEAR(now[m], held, most) << what << ", material " << report->materials[m];
    if (before.missing.empty())
    {
      EXPECT_NEAR(now[m], old[m], 1e-12 * old[m]) << what << ", material " << report->materials[m];
    }
  }
  EXPECT_EQ(report->volumesBefore, old) << what;
  EXPECT_EQ(report->volumesAfter, now) << what;
  EXPECT_LT(report->largestPieceError, 1e-12) << what;
  EXPECT_TRUE(surface.missing.empty()) << what;
  EXPECT_EQ(FindIntersections(surface.points, surface.triangles, monitor).size(), 0u) << what;
  EXPECT_EQ(surface.triangles, before.triangles) << what;
  EXPECT_EQ(surface.materials, before.materials) << what;
  return *report;
}

/// Root of the mean squared angle between the triangles' normals and the ball's, in degrees.
double NormalError(const TriangleComplex& surface, const Vec3& centre)
{
  double sum = 0;
  for (const Triangle& t : surface.triangles)
  {
    Vec3 middle;
    for (Id p : t)
    {
      middle += (1.0 / 3) * surface.points[static_cast<std::size_t>(p)];
    }
    const Vec3 normal = Normalized(AreaVector2(surface.points, t));
    const double angle = std::acos(std::min(1.0, Dot(normal, Normalized(middle - centre))));
    sum += angle * angle;
  }
  return std::sqrt(sum / static_cast<double>(surface.triangles.size())) * 57.29577951308232;
}

void ExpectError(TriangleComplex surface, const SmoothSurfaceOptions& options, Failure kind, const char* word,
                 bool withPlaces)
{
  ThreadMonitor monitor;
  const auto before = surface.points;
  const auto result = SmoothSurface(surface, options, monitor);
  ASSERT_FALSE(result) << word;
  EXPECT_EQ(result.GetError().kind, kind) << word;
  EXPECT_NE(result.GetError().message.find(word), std::string::npos) << result.GetError().message;
  EXPECT_EQ(!result.GetError().places.empty(), withPlaces) << word;
  EXPECT_EQ(surface.points, before) << word;
}

} // namespace

TEST(SmoothSurface, BallBecomesRound)
{
  TriangleComplex surface = Extract(images::Ball(24, 10));
  const Vec3 centre{ 11.5, 11.5, 11.5 };
  EXPECT_GT(NormalError(surface, centre), 20);
  SmoothAndCheck(surface, "ball");
  EXPECT_LT(NormalError(surface, centre), 5);
  // All points lie near the ball of the same volume.
  for (const Vec3& p : surface.points)
  {
    EXPECT_NEAR(Norm(p - centre), 10, 0.5);
  }
}

TEST(SmoothSurface, ThinShellKeepsBothSides)
{
  TriangleComplex surface = Extract(images::Shell(20, 6, 8));
  const Vec3 centre{ 9.5, 9.5, 9.5 };
  SmoothAndCheck(surface, "shell");
  for (const Vec3& p : surface.points)
  {
    const double r = Norm(p - centre);
    EXPECT_LT(std::min(std::abs(r - 6), std::abs(r - 8)), 0.6);
  }
}

TEST(SmoothSurface, SectorsKeepTheirBorderPlanes)
{
  TriangleComplex surface = Extract(images::Sectors(16, 6.3, false));
  const TriangleComplex before = surface;
  SmoothAndCheck(surface, "sectors");
  int inPlane = 0;
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    if (surface.junctionKind[p] & JunctionInBorderPlane)
    {
      ++inPlane;
      EXPECT_NEAR(surface.points[p].z, before.points[p].z, 1e-12);
    }
  }
  EXPECT_GT(inPlane, 100);
}

TEST(SmoothSurface, CappedSectors)
{
  TriangleComplex surface = Extract(images::Sectors(16, 6.3, true));
  SmoothAndCheck(surface, "capped sectors");
}

TEST(SmoothSurface, FourBallsThatMeet)
{
  // Each voxel belongs to the nearest of four balls around a tetrahedron's corners: curves of three materials
  // and more meet in the middle.
  const LabelImage image = images::MakeCentred(
    22,
    [](double x, double y, double z)
    {
      const Vec3 p{ x, y, z };
      const double d = 2.9;
      const std::array<Vec3, 4> centres{ { { d, d, d }, { d, -d, -d }, { -d, d, -d }, { -d, -d, d } } };
      int nearest = 0;
      double least = 5.3;
      for (std::size_t c = 0; c < 4; ++c)
      {
        if (Norm(p - centres[c]) < least)
        {
          least = Norm(p - centres[c]);
          nearest = static_cast<int>(c) + 1;
        }
      }
      return nearest;
    });
  TriangleComplex surface = Extract(image);
  const TriangleComplex before = surface;
  SmoothAndCheck(surface, "four balls");
  // The curves lose their steps: the turn at their points, before and after.
  const EdgeTable table = MakeEdgeTable(surface.triangles);
  std::vector<std::vector<Id>> along(surface.points.size());
  for (std::size_t e = 0; e < table.edges.size(); ++e)
  {
    if (table.triangles.Count(static_cast<Id>(e)) > 2)
    {
      along[static_cast<std::size_t>(table.edges[e].a)].push_back(table.edges[e].b);
      along[static_cast<std::size_t>(table.edges[e].b)].push_back(table.edges[e].a);
    }
  }
  const auto turns = [&](const TriangleComplex& s)
  {
    double sum = 0;
    int count = 0;
    for (std::size_t p = 0; p < along.size(); ++p)
    {
      if (along[p].size() == 2)
      {
        const auto x = [&](Id q) { return s.points[static_cast<std::size_t>(q)]; };
        const Vec3 u = Normalized(s.points[p] - x(along[p][0]));
        const Vec3 v = Normalized(x(along[p][1]) - s.points[p]);
        sum += std::acos(std::min(1.0, Dot(u, v)));
        ++count;
      }
    }
    EXPECT_GT(count, 30);
    return sum / count;
  };
  EXPECT_LT(turns(surface), 0.5 * turns(before));
}

TEST(SmoothSurface, Noise)
{
  for (unsigned seed = 0; seed < 6; ++seed)
  {
    TriangleComplex surface = Extract(images::Noise(8, 2 + static_cast<int>(seed % 4), seed));
    SmoothAndCheck(surface, "noise " + std::to_string(seed));
  }
}

TEST(SmoothSurface, ScaleAndPlaceMakeNoDifference)
{
  LabelImage image = images::Shell(14, 3.4, 5.8);
  TriangleComplex surface = Extract(image);
  image.grid.spacing = { 0.25, 0.25, 0.25 };
  image.grid.origin = { 100, -50, 25 };
  TriangleComplex far = Extract(image);
  SmoothAndCheck(surface, "near");
  SmoothAndCheck(far, "far");
  double largest = 0;
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    largest = std::max(largest, Norm(4 * (far.points[p] - image.grid.origin) - surface.points[p]));
  }
  EXPECT_LT(largest, 1e-3);
}

TEST(SmoothSurface, ThreadsMakeNoDifference)
{
  const TriangleComplex start = Extract(images::Sectors(18, 7.2, true));
  std::vector<Vec3> first;
  for (int threads : { 1, 2, 3 })
  {
    ThreadMonitor monitor(threads);
    TriangleComplex surface = start;
    ASSERT_TRUE(SmoothSurface(surface, {}, monitor));
    if (first.empty())
    {
      first = surface.points;
    }
    EXPECT_EQ(surface.points, first) << threads;
  }
}

TEST(SmoothSurface, NoSweepsChangeNothing)
{
  ThreadMonitor monitor;
  TriangleComplex surface = Extract(images::Ball(10, 3.4));
  const auto before = surface.points;
  SmoothSurfaceOptions options;
  options.sweeps = 0;
  const auto report = SmoothSurface(surface, options, monitor);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->sweepsDone, 0);
  EXPECT_EQ(surface.points, before);
  TriangleComplex empty;
  EXPECT_TRUE(SmoothSurface(empty, {}, monitor));
}

TEST(SmoothSurface, BadOptions)
{
  const TriangleComplex surface = Extract(images::Ball(8, 2.5));
  SmoothSurfaceOptions options;
  options.sweeps = -1;
  ExpectError(surface, options, Failure::InvalidOption, "sweeps", false);
  for (const double value : { 0.0, 1.01, std::numeric_limits<double>::quiet_NaN() })
  {
    options = {};
    options.relaxation = value;
    ExpectError(surface, options, Failure::InvalidOption, "relaxation", false);
  }
  for (const double value : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    options = {};
    options.largestDrift = value;
    ExpectError(surface, options, Failure::InvalidOption, "drift", false);
  }
}

TEST(SmoothSurface, OpenOrIntersectingSurfacesAreRefused)
{
  TriangleComplex open = Extract(images::Ball(8, 2.5));
  open.triangles.pop_back();
  open.materials.pop_back();
  ExpectError(open, {}, Failure::InvalidInput, "", true);
  TriangleComplex crossing;
  shapes::AddSphere(crossing, {}, 1, 2, { 1, 0 });
  shapes::AddSphere(crossing, { 1.5, 0.1, 0.2 }, 1, 2, { 1, 0 });
  ExpectError(crossing, {}, Failure::InvalidInput, "intersects itself", true);
}

TEST(SmoothSurface, Cancel)
{
  ThreadMonitor monitor;
  monitor.Cancel();
  TriangleComplex surface = Extract(images::Ball(8, 2.5));
  const auto result = SmoothSurface(surface, {}, monitor);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.GetError().kind, Failure::Cancelled);
}
