// SPDX-License-Identifier: BSD-3-Clause
// What finite volumes ask of faces: the measures, and their improvement.
#include "ShakenGrids.h"
#include "Volume/FrontCells.h"
#include "Volume/ImproveFaces.h"

using namespace lamina;
using namespace shaken;

namespace
{

std::array<Vec3, 4> CornersOf(const TetSet& set, Id tet)
{
  std::array<Vec3, 4> corners;
  for (std::size_t k = 0; k < 4; ++k)
  {
    corners[k] = set.points[static_cast<std::size_t>(set.tets[static_cast<std::size_t>(tet)][k])];
  }
  return corners;
}

Vec3 Centre(const std::array<Vec3, 4>& c)
{
  return 0.25 * (c[0] + c[1] + c[2] + c[3]);
}

/// Angles, in degrees, and skewness of all faces between two tets of a group; the worst of both.
std::array<double, 2> WorstFaces(const TetSet& set)
{
  ThreadMonitor monitor;
  const auto neighbours = FindTetNeighbours(set.tets, static_cast<Id>(set.points.size()), monitor);
  std::array<double, 2> worst{ { 0, 0 } };
  for (Id t = 0; t < static_cast<Id>(set.tets.size()); ++t)
  {
    for (std::size_t k = 0; k < 4; ++k)
    {
      const Id other = neighbours[static_cast<std::size_t>(t)][k];
      if (other <= t ||
          set.groups[static_cast<std::size_t>(other)] != set.groups[static_cast<std::size_t>(t)])
      {
        continue;
      }
      const Triangle ids = TetFace(set.tets[static_cast<std::size_t>(t)], k);
      std::array<Vec3, 3> face;
      for (std::size_t c = 0; c < 3; ++c)
      {
        face[c] = set.points[static_cast<std::size_t>(ids[c])];
      }
      const Vec3 near = Centre(CornersOf(set, t));
      const Vec3 far = Centre(CornersOf(set, other));
      const Vec3 normal = Normalized(Cross(face[1] - face[0], face[2] - face[0]));
      const double cosine = std::abs(Dot(normal, Normalized(far - near)));
      worst[0] = std::max(worst[0], std::acos(std::min(cosine, 1.0)) * 57.29577951308232);
      worst[1] = std::max(worst[1], FaceSkewness(face, near, far));
    }
  }
  return worst;
}

} // namespace

TEST(FaceMeasures, ReferenceValues)
{
  const std::array<Vec3, 3> face{ { { 0, 0, 0 }, { 3, 0, 0 }, { 0, 3, 0 } } }; // centre (1, 1, 0)
  EXPECT_NEAR(FaceNonOrthogonality(face, { 1, 1, -1 }, { 1, 1, 2 }), 0, 1e-12);
  EXPECT_NEAR(FaceSkewness(face, { 1, 1, -1 }, { 1, 1, 2 }), 0, 1e-12);
  EXPECT_NEAR(FaceNonOrthogonality(face, { 0, 1, -1 }, { 2, 1, 1 }), 45, 1e-12);
  EXPECT_NEAR(FaceSkewness(face, { 0, 1, -1 }, { 2, 1, 1 }), 0, 1e-12); // aslant, but through the centre
  EXPECT_NEAR(FaceNonOrthogonality(face, { 0, 1, 0 }, { 2, 1, 0 }), 90, 1e-12);
  EXPECT_TRUE(std::isinf(FaceSkewness(face, { 0, 1, 0 }, { 2, 1, 0 })));
  // Upright, but 4 off the centre along x, where the face reaches 2 from it.
  EXPECT_NEAR(FaceSkewness(face, { 5, 1, -1 }, { 5, 1, 1 }), 2, 1e-12);
  // A fifth of the centres' distance, 20, is more.
  EXPECT_NEAR(FaceSkewness(face, { 41, 1, -50 }, { 41, 1, 50 }), 2, 1e-12);
  // The same whichever cell comes first, at any scale and place.
  const auto moved = [](const Vec3& p) { return 1e-3 * p + Vec3{ 7, -8, 9 }; };
  const std::array<Vec3, 3> small{ { moved(face[0]), moved(face[2]), moved(face[1]) } };
  EXPECT_NEAR(FaceSkewness(small, moved({ 5, 1, 1 }), moved({ 5, 1, -1 })), 2, 1e-9);
  EXPECT_NEAR(FaceNonOrthogonality(small, moved({ 2, 1, 1 }), moved({ 0, 1, -1 })), 45, 1e-9);
}

TEST(ImproveFaces, LowersTheWorstAndKeepsTheRest)
{
  TetSet start = ShakenGrid(8, 0.3);
  start.layerIndex.clear();
  double before = 0;
  const auto volumes = Volumes(start, before);
  const auto facesBefore = WorstFaces(start);
  ASSERT_EQ(start.tets.size(), 5u * 512); // none was inverted by the shaking
  const double worstBefore = std::max(facesBefore[0] / 85, facesBefore[1] / 4);
  ImproveFacesOptions options;
  options.share = 0.8 * worstBefore;
  options.enough = 0.1;
  options.rounds = 8;
  TetSet set = start;
  ThreadMonitor monitor;
  const ImproveFacesReport report = ImproveFaces(set, options, monitor);
  EXPECT_GT(report.found, 0);
  EXPECT_LT(report.left, report.found);
  const auto faces = WorstFaces(set);
  EXPECT_NEAR(report.worst, std::max(faces[0] / 85, faces[1] / 4), 1e-9);
  EXPECT_LT(report.worst, 0.9 * worstBefore);
  double after = 0;
  const auto now = Volumes(set, after);
  EXPECT_NEAR(now[0], volumes[0], 1e-9);
  EXPECT_NEAR(now[1], volumes[1], 1e-9);
  EXPECT_GE(after, std::min(before, options.enough) - 1e-12);
  EXPECT_EQ(Walls(set), Walls(start));
  for (std::size_t p = 0; p < set.points.size(); ++p)
  {
    EXPECT_TRUE(set.fixed[p] == 0 || set.points[p] == start.points[p]);
  }
  TetSet again = start;
  ThreadMonitor other(3);
  ImproveFaces(again, options, other);
  EXPECT_EQ(again.points, set.points);
  EXPECT_EQ(again.tets, set.tets);
}

TEST(ImproveFaces, WhatIsGoodStaysAsItIs)
{
  TetSet set = ShakenGrid(4, 0);
  const TetSet start = set;
  ThreadMonitor monitor;
  const ImproveFacesReport report = ImproveFaces(set, {}, monitor);
  EXPECT_EQ(report.found, 0);
  EXPECT_LT(report.worst, 0.94);
  EXPECT_EQ(set.points, start.points);
  EXPECT_EQ(set.tets, start.tets);
}

TEST(ImproveFaces, PrismsBehindAFrontCount)
{
  // A tet on a triangle with a prism under it, its top slid aside.
  TriangleComplex front;
  front.points = { { 0, 0, 0 }, { 3, 0, 0 }, { 0, 3, 0 } };
  front.triangles = { { { 0, 2, 1 } } };
  front.layerSide.assign(3, { 0, 0, 0.4 });
  const FrontCells behind(front);
  TetSet set;
  set.points = front.points;
  set.points.push_back({ 9, 1, 0.8 });
  set.fixed = { 1, 1, 1, 0 };
  set.tets = { { { 0, 1, 2, 3 } } };
  ThreadMonitor monitor;
  EXPECT_EQ(ImproveFaces(set, {}, monitor).worst, 0); // no face between two cells
  set.front = &behind;
  ImproveFacesOptions look;
  look.share = 100; // nothing is worked on
  const ImproveFacesReport report = ImproveFaces(set, look, monitor);
  EXPECT_EQ(report.found, 0);
  // The line of centres runs from (1, 1, -0.2) to (3, 1, 0.2).
  EXPECT_NEAR(report.worst, std::atan2(2, 0.4) * 57.29577951308232 / 85, 1e-9);
  // A point of one tet alone is on the boundary and stays.
  look.share = 0.5;
  EXPECT_EQ(ImproveFaces(set, look, monitor).left, 1);
  EXPECT_EQ(set.points[3], (Vec3{ 9, 1, 0.8 }));
}
