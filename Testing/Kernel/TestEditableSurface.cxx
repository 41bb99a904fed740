// SPDX-License-Identifier: BSD-3-Clause
// Each local edit of a surface: what it does, what it must not do, and where sheets meet.
#include "Mesh/VolumeCorrection.h"
#include "Shapes.h"
#include "Surface/EditableSurface.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace lamina;

namespace
{

/// Points 0, 1, 2 round the equator, 3 on top, 4 below: material 1 over material 2, with a triangle between
/// them.
TriangleComplex TwoStoreys()
{
  TriangleComplex surface;
  const double half = std::sqrt(0.75);
  surface.points = { { 1, 0, 0 }, { -0.5, half, 0 }, { -0.5, -half, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
  surface.triangles = { { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 }, { 1, 0, 4 },
                        { 2, 1, 4 }, { 0, 2, 4 }, { 0, 2, 1 } };
  surface.materials = { { 1, 0 }, { 1, 0 }, { 1, 0 }, { 2, 0 }, { 2, 0 }, { 2, 0 }, { 1, 2 } };
  surface.targetEdgeLength.assign(5, 1);
  return surface;
}

TriangleComplex RoughSphere()
{
  TriangleComplex surface;
  shapes::AddSphere(surface, {}, 1, 3, { 1, 0 });
  shapes::JitterSphere(surface, {}, 1, 0.05);
  surface.targetEdgeLength.assign(surface.points.size(), 0.2);
  return surface;
}

/// A surface to edit, with the input it is held against.
struct Bench
{
  Bench(const TriangleComplex& surface, double tolerance)
    : input(surface, tolerance, 1, monitor)
    , edited(input, 0.7, 1.4)
  {
  }
  TriangleComplex Written()
  {
    TriangleComplex out;
    this->edited.Write(out, this->monitor);
    return out;
  }
  Id Alive() const
  {
    Id count = 0;
    for (Id t = 0; t < this->edited.TriangleCount(); ++t)
    {
      count += this->edited.IsAlive(t) ? 1 : 0;
    }
    return count;
  }

  ThreadMonitor monitor;
  InputSurface input;
  EditableSurface edited;
};

double Volume(const TriangleComplex& surface)
{
  return MaterialVolumes(surface, { 1 }).front();
}

} // namespace

TEST(EditableSurface, SplittingAJunctionEdgeSplitsAllItsTriangles)
{
  Bench bench(TwoStoreys(), 1);
  const Id middle = bench.edited.Split(0, 1);
  EXPECT_EQ(middle, 5);
  EXPECT_EQ(bench.Alive(), 10);
  EXPECT_EQ(bench.edited.TrianglesAt(0, 1).size(), 0u);
  EXPECT_EQ(bench.edited.TrianglesAt(0, middle).size(), 3u);
  EXPECT_EQ(bench.edited.Star(middle).size(), 6u);
  const TriangleComplex out = bench.Written();
  EXPECT_EQ(std::count(out.junctionKind.begin(), out.junctionKind.end(), JunctionCurve), 4);
  EXPECT_EQ(MaterialVolumes(out, { 1, 2 }), MaterialVolumes(TwoStoreys(), { 1, 2 }));
}

TEST(EditableSurface, MergingAlongAJunctionUndoesASplit)
{
  Bench bench(TwoStoreys(), 1);
  const Id middle = bench.edited.Split(0, 1);
  bench.edited.Split(0, middle);
  EXPECT_EQ(bench.Alive(), 13);
  EXPECT_TRUE(bench.edited.Merge(5, 6, true));
  EXPECT_EQ(bench.Alive(), 10);
}

TEST(EditableSurface, MergingKeepsTheLinkCondition)
{
  Bench bench(TwoStoreys(), 1);
  const Id middle = bench.edited.Split(0, 1);
  // The top and the middle both neighbour point 2, but there is no such triangle: the storeys would close up.
  EXPECT_FALSE(bench.edited.Merge(3, middle, true));
  TriangleComplex tetrahedron;
  tetrahedron.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  tetrahedron.triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 2 } };
  tetrahedron.materials.assign(4, { 1, 0 });
  tetrahedron.targetEdgeLength.assign(4, 10);
  Bench four(tetrahedron, 10);
  for (Id a = 0; a < 4; ++a)
  {
    for (Id b = a + 1; b < 4; ++b)
    {
      EXPECT_FALSE(four.edited.Merge(a, b, true)) << a << " " << b;
    }
  }
}

TEST(EditableSurface, PointsOfSheetsMergeIntoCurvesAndNotTheOtherWay)
{
  Bench bench(TwoStoreys(), 1);
  const Id onSheet = bench.edited.Split(0, 3);
  const Vec3 before = bench.edited.Point(0);
  ASSERT_TRUE(bench.edited.Merge(0, onSheet, true));
  EXPECT_TRUE(bench.edited.Star(onSheet).empty());
  EXPECT_EQ(bench.edited.Point(0), before);
  EXPECT_EQ(bench.Alive(), 7);
}

TEST(EditableSurface, MergingAcrossASheetBetweenTwoCurvesIsRefused)
{
  Bench bench(TwoStoreys(), 1);
  const Id first = bench.edited.Split(0, 1);
  const Id second = bench.edited.Split(0, 2);
  if (bench.edited.TrianglesAt(first, second).size() == 1)
  {
    EXPECT_FALSE(bench.edited.Merge(first, second, true)); // both on the junction, the edge within one sheet
  }
  EXPECT_FALSE(bench.edited.Merge(3, 4, true)); // no edge at all
}

TEST(EditableSurface, MergingStaysWithinTheTolerance)
{
  for (const double tolerance : { 1e-5, 0.2 })
  {
    Bench bench(RoughSphere(), tolerance);
    int merged = 0;
    for (Id p = 0; p < 40; ++p)
    {
      if (!bench.edited.Star(p).empty())
      {
        const Triangle corners = bench.edited.Corners(bench.edited.Star(p).front());
        merged += bench.edited.Merge(corners[0], corners[1], true) ? 1 : 0;
      }
    }
    EXPECT_EQ(merged > 0, tolerance > 0.1) << tolerance;
    EXPECT_NEAR(Volume(bench.Written()), Volume(RoughSphere()), 0.01 * Volume(RoughSphere()));
  }
}

TEST(EditableSurface, SwappingBettersTheWorseTriangleOrIsRefused)
{
  Bench bench(RoughSphere(), 0.2);
  int swapped = 0;
  int refused = 0;
  const auto worse = [&](const EdgeTriangles& pair)
  { return std::min(bench.edited.Quality(pair[0]), bench.edited.Quality(pair[1])); };
  for (Id t = 0; t < bench.edited.TriangleCount(); ++t)
  {
    const Triangle corners = bench.edited.Corners(t);
    const EdgeTriangles pair = bench.edited.TrianglesAt(corners[0], corners[1]);
    ASSERT_EQ(pair.size(), 2u);
    const double before = worse(pair);
    if (bench.edited.Swap(corners[0], corners[1]))
    {
      ++swapped;
      EXPECT_GT(worse(pair), before);
      EXPECT_EQ(bench.edited.TrianglesAt(corners[0], corners[1]).size(), 0u);
    }
    else
    {
      ++refused;
      EXPECT_EQ(worse(pair), before);
    }
  }
  EXPECT_GT(swapped, 5);
  EXPECT_GT(refused, 5);
}

TEST(EditableSurface, JunctionsAndEdgesThatAreThereAlreadyAreNotSwapped)
{
  Bench bench(TwoStoreys(), 1);
  EXPECT_FALSE(bench.edited.Swap(0, 1)); // three triangles
  EXPECT_FALSE(bench.edited.Swap(0, 3)); // 1 and 2 are joined already
}

TEST(EditableSurface, RelaxingKeepsTheVolumeAndCurvesInPlace)
{
  Bench sphere(RoughSphere(), 0.2);
  int moved = 0;
  double volume = Volume(sphere.Written());
  for (Id p = 0; p < 60; ++p)
  {
    moved += sphere.edited.Relax(p) ? 1 : 0;
    const double now = Volume(sphere.Written());
    EXPECT_NEAR(now, volume, 1e-12) << p;
    volume = now;
  }
  EXPECT_GT(moved, 20);
  Bench storeys(TwoStoreys(), 1);
  const Id middle = storeys.edited.Split(0, 1);
  const Id quarter = storeys.edited.Split(0, middle);
  EXPECT_TRUE(storeys.edited.Relax(middle));
  const Vec3 along = storeys.edited.Point(1) - storeys.edited.Point(0);
  for (Id p : { middle, quarter })
  {
    EXPECT_NEAR(Norm(Cross(storeys.edited.Point(p) - storeys.edited.Point(0), along)), 0, 1e-12) << p;
  }
}

TEST(EditableSurface, RelaxingInVainIsNotTriedAgain)
{
  Bench bench(RoughSphere(), 1e-9);
  const Id clock = bench.edited.Clock();
  for (Id p = 0; p < 20; ++p)
  {
    EXPECT_FALSE(bench.edited.Relax(p)) << p;
    EXPECT_FALSE(bench.edited.Relax(p)) << p;
  }
  EXPECT_EQ(bench.edited.Clock(), clock);
}

TEST(EditableSurface, NewIdsAreOfTheSameSurface)
{
  Bench bench(RoughSphere(), 0.2);
  const Triangle first = bench.edited.Corners(0);
  bench.edited.Split(first[0], first[1]);
  for (Id p = 0; p < 40; ++p)
  {
    if (!bench.edited.Star(p).empty())
    {
      const Triangle corners = bench.edited.Corners(bench.edited.Star(p).front());
      bench.edited.Merge(corners[0], corners[1], true);
    }
  }
  const Id alive = bench.Alive();
  const double volume = Volume(bench.Written());
  ASSERT_LT(alive, bench.edited.TriangleCount());
  bench.edited.Renumber();
  EXPECT_EQ(bench.edited.TriangleCount(), alive);
  EXPECT_EQ(bench.Alive(), alive);
  EXPECT_EQ(2 * (bench.edited.PointCount() - 2), alive); // a closed surface without unused points
  EXPECT_NEAR(Volume(bench.Written()), volume, 1e-12);
  // It can be edited on, and edits are still held against the input.
  Id relaxed = 0;
  for (Id p = 0; p < bench.edited.PointCount(); ++p)
  {
    relaxed += bench.edited.Relax(p) ? 1 : 0;
  }
  EXPECT_GT(relaxed, 20);
  EXPECT_NEAR(Volume(bench.Written()), volume, 1e-10);
}

TEST(EditableSurface, UncoveringBettersTheSightAndOnlyThere)
{
  // A spike in a sphere: its tip sees none of its faces well.
  TriangleComplex spiky = RoughSphere();
  spiky.points[0] = 1.5 * spiky.points[0];
  Bench bench(spiky, 0.6);
  const double before = bench.edited.Visibility(0);
  ASSERT_LT(before, 0.4);
  for (int i = 0; i < 50 && bench.edited.Uncover(0, 0.04); ++i)
  {
  }
  EXPECT_GT(bench.edited.Star(0).empty() ? 1 : bench.edited.Visibility(0), 0.45);
  Bench smooth(RoughSphere(), 0.6);
  const Id clock = smooth.edited.Clock();
  EXPECT_FALSE(smooth.edited.Uncover(0, 0.04)); // sees all of them already
  EXPECT_EQ(smooth.edited.Clock(), clock);
  Bench narrow(spiky, 1e-6);
  EXPECT_FALSE(narrow.edited.Uncover(0, 0.04)); // the tolerance holds it
}

TEST(EditableSurface, ReshapingBettersTheWorstTriangleOfASheetsPoint)
{
  TriangleComplex skewed = RoughSphere();
  const Triangle first = skewed.triangles[0]; // drawn along the sphere
  const Vec3 place = 0.3 * skewed.points[static_cast<std::size_t>(first[0])] +
                     0.7 * skewed.points[static_cast<std::size_t>(first[1])];
  skewed.points[static_cast<std::size_t>(first[0])] = Normalized(place);
  Bench bench(skewed, 0.2);
  const auto worst = [&]
  {
    double q = 1;
    for (Id t : bench.edited.Star(first[0]))
    {
      q = std::min(q, bench.edited.Quality(t));
    }
    return q;
  };
  const double before = worst();
  const double volume = Volume(bench.Written());
  ASSERT_TRUE(bench.edited.Reshape(first[0]));
  EXPECT_GT(worst(), before);
  EXPECT_NEAR(Volume(bench.Written()), volume, 1e-12);
}

TEST(EditableSurface, ReshapingAPointOfACurveMovesItAlongTheCurve)
{
  Bench bench(TwoStoreys(), 0.5);
  const Id middle = bench.edited.Split(0, 1);
  const Id quarter =
    bench.edited.Split(0, middle); // short edges on one side of the middle, a long one beyond
  const auto worst = [&]
  {
    double q = 1;
    for (Id t : bench.edited.Star(middle))
    {
      q = std::min(q, bench.edited.Quality(t));
    }
    return q;
  };
  const double before = worst();
  const Vec3 place = bench.edited.Point(middle);
  const double volume = Volume(bench.Written());
  ASSERT_TRUE(bench.edited.Reshape(middle));
  EXPECT_GT(worst(), before);
  const Vec3 along = bench.edited.Point(1) - bench.edited.Point(0);
  const Vec3 moved = bench.edited.Point(middle) - place;
  EXPECT_GT(Dot(moved, along), 0); // towards the long edge
  EXPECT_LT(Norm(Cross(moved, along)), 1e-12);
  EXPECT_NEAR(Volume(bench.Written()), volume, 1e-12);
  EXPECT_GE(quarter, 0);
  Bench corner(TwoStoreys(), 1e-9);
  EXPECT_FALSE(corner.edited.Reshape(0)); // the tolerance holds the end of the storeys' edges
}

TEST(EditableSurface, FlatTrianglesAreSplitWhereThatHelps)
{
  TriangleComplex flat; // its first triangle is nearly a line
  flat.points = { { 0, 0, 0 }, { 4, 0, 0 }, { 2, 0.3, 0 }, { 2, 0.1, 3 } };
  flat.triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 2 } };
  flat.materials.assign(4, { 1, 0 });
  flat.targetEdgeLength.assign(4, 1);
  Bench bench(flat, 1);
  const double before = bench.edited.Quality(0);
  ASSERT_LT(before, 0.3);
  ASSERT_TRUE(bench.edited.SplitFlat(0));
  EXPECT_EQ(bench.Alive(), 6);
  for (Id t : bench.edited.Star(4))
  {
    EXPECT_GT(bench.edited.Quality(t), 1.5 * before);
  }
  EXPECT_FALSE(bench.edited.SplitFlat(2)); // not flat: its halves would be no better
  flat.targetEdgeLength.assign(4, 10);
  Bench coarse(flat, 1);
  EXPECT_FALSE(coarse.edited.SplitFlat(0)); // the halves would be too short
}
