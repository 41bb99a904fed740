// SPDX-License-Identifier: BSD-3-Clause
#include "Images.h"
#include "Mesh/VolumeCorrection.h"
#include "Shapes.h"
#include "Surface/EdgeRelaxation.h"
#include "Surface/ExtractInterfaces.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

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

/// Takes the points out of the staircase's special position, along the directions they may move in.
void Perturb(TriangleComplex& surface, const SmoothingState& state, double by)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> shift(-by, by);
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    surface.points[p] += state.freedom[p].Project({ shift(random), shift(random), shift(random) });
  }
}

struct Outcome
{
  int done = 0;
  int refused = 0;
  double largestChange = 0; ///< of a material's volume, over the volume of all
  double largestMove = 0;
};

/// Applies one relaxation, measures, and takes it back.
void Try(TriangleComplex& surface, const SmoothingState& state, const std::vector<int>& materials, Id a, Id b,
         double weight, Outcome& outcome)
{
  Relaxation r;
  if (!RelaxEdge(state, a, b, weight, r))
  {
    ++outcome.refused;
    return;
  }
  ++outcome.done;
  EXPECT_EQ(r.a, a);
  EXPECT_EQ(r.b, b);
  const auto before = MaterialVolumes(surface, materials);
  const std::vector<Vec3> points = surface.points;
  surface.points[static_cast<std::size_t>(a)] += r.moveA;
  if (b >= 0)
  {
    surface.points[static_cast<std::size_t>(b)] += r.moveB;
  }
  const auto after = MaterialVolumes(surface, materials);
  surface.points = points;
  double all = 0;
  double change = 0;
  for (std::size_t m = 0; m < materials.size(); ++m)
  {
    all += before[m];
    change = std::max(change, std::abs(after[m] - before[m]));
  }
  outcome.largestChange = std::max(outcome.largestChange, change / all);
  outcome.largestMove = std::max({ outcome.largestMove, Norm(r.moveA), Norm(r.moveB) });
}

/// All relaxations of a surface, by the kind of their ends; lone points under kind + 100.
std::map<int, Outcome> TryAll(TriangleComplex& surface, const SmoothingState& state, double weight)
{
  const std::vector<int> materials = MaterialsOf(surface);
  std::map<int, Outcome> outcomes;
  for (std::size_t e = 0; e < state.table.edges.size(); ++e)
  {
    const Edge& edge = state.table.edges[e];
    const int kind = surface.junctionKind[static_cast<std::size_t>(edge.a)];
    const bool curve = (kind & 3) == JunctionCurve && state.feature[e];
    if (kind == surface.junctionKind[static_cast<std::size_t>(edge.b)] &&
        ((kind & 3) == JunctionSheet || curve) &&
        state.freedom[static_cast<std::size_t>(edge.a)].dimensions > 1)
    {
      Try(surface, state, materials, edge.a, edge.b, weight, outcomes[kind]);
    }
  }
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    const int kind = surface.junctionKind[p];
    if ((kind & 3) != JunctionCorner)
    {
      Try(surface, state, materials, static_cast<Id>(p), -1, weight, outcomes[kind + 100]);
    }
  }
  return outcomes;
}

void ExpectConserved(const std::map<int, Outcome>& outcomes, int kind, double share)
{
  ASSERT_EQ(outcomes.count(kind), 1u) << kind;
  const Outcome& o = outcomes.at(kind);
  EXPECT_GT(o.done, share * (o.done + o.refused)) << kind;
  EXPECT_GT(o.largestMove, 0.05) << kind;
  EXPECT_LT(o.largestChange, 1e-12) << kind;
}

} // namespace

TEST(EdgeRelaxation, AVolumeIsLinearInEveryPoint)
{
  // What the conditions stand on: six times the gradient of a volume is the sum of the area vectors around.
  TriangleComplex surface;
  shapes::AddSphere(surface, {}, 1, 2, { 1, 0 });
  const Lists star = TrianglesOfPoints(static_cast<Id>(surface.points.size()), surface.triangles);
  const double before = MaterialVolumes(surface, { 1 })[0];
  const Vec3 move{ 0.03, -0.02, 0.05 };
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    Vec3 area;
    for (Id t : Row(star, static_cast<Id>(p)))
    {
      area += AreaVector2(surface.points, surface.triangles[static_cast<std::size_t>(t)]);
    }
    const Vec3 place = surface.points[p];
    surface.points[p] += move;
    EXPECT_NEAR(MaterialVolumes(surface, { 1 })[0] - before, Dot(area, move) / 6, 1e-15) << p;
    surface.points[p] = place;
  }
}

TEST(EdgeRelaxation, SheetsOfABall)
{
  TriangleComplex surface = Extract(images::Ball(11, 3.9));
  const SmoothingState state(surface);
  Perturb(surface, state, 0.2);
  for (const double weight : { 1.0, 0.5 })
  {
    const auto outcomes = TryAll(surface, state, weight);
    ExpectConserved(outcomes, JunctionSheet, 0.99);
    ExpectConserved(outcomes, JunctionSheet + 100, 0.99);
  }
}

TEST(EdgeRelaxation, CurvesAndBorderPlanesOfSectors)
{
  TriangleComplex surface = Extract(images::Sectors(11, 4.2, false));
  const SmoothingState state(surface);
  Perturb(surface, state, 0.15);
  const auto outcomes = TryAll(surface, state, 1);
  ExpectConserved(outcomes, JunctionSheet, 0.99);
  ExpectConserved(outcomes, JunctionCurve, 0.8);
  ExpectConserved(outcomes, JunctionSheet + JunctionInBorderPlane, 0.99);
  ExpectConserved(outcomes, JunctionCurve + JunctionInBorderPlane, 0.8);
  ExpectConserved(outcomes, JunctionCurve + 100, 0.5);
}

TEST(EdgeRelaxation, BorderPointsStayInTheirPlane)
{
  TriangleComplex surface = Extract(images::Sectors(11, 4.2, false));
  const SmoothingState state(surface);
  Perturb(surface, state, 0.15);
  int moved = 0;
  for (const Edge& edge : state.table.edges)
  {
    const int kind = surface.junctionKind[static_cast<std::size_t>(edge.a)];
    Relaxation r;
    if ((kind & JunctionInBorderPlane) && (kind & 3) != JunctionCorner &&
        kind == surface.junctionKind[static_cast<std::size_t>(edge.b)] &&
        RelaxEdge(state, edge.a, edge.b, 1, r))
    {
      ++moved;
      EXPECT_NEAR(r.moveA.z, 0, 1e-14);
      EXPECT_NEAR(r.moveB.z, 0, 1e-14);
    }
  }
  EXPECT_GT(moved, 100);
}

TEST(EdgeRelaxation, APlaneSheetStaysPlane)
{
  // In the middle of a flat face nothing pulls points out of the face.
  TriangleComplex surface;
  shapes::AddBox(surface, { 0, 0, 0 }, { 8, 8, 8 }, { { 8, 8, 8 } }, { 1, 0 });
  ClassifyJunctions(surface);
  const SmoothingState state(surface);
  const auto isInner = [&](Id p)
  {
    const Vec3& x = surface.points[static_cast<std::size_t>(p)];
    return x.z == 8 && x.x > 2 && x.x < 6 && x.y > 2 && x.y < 6;
  };
  int tested = 0;
  for (const Edge& edge : state.table.edges)
  {
    Relaxation r;
    if (isInner(edge.a) && isInner(edge.b))
    {
      ++tested;
      ASSERT_TRUE(RelaxEdge(state, edge.a, edge.b, 1, r));
      EXPECT_NEAR(r.moveA.z, 0, 1e-14);
      EXPECT_NEAR(r.moveB.z, 0, 1e-14);
    }
  }
  EXPECT_GT(tested, 10);
}

TEST(EdgeRelaxation, CurvesOfFourMaterials)
{
  // Four quadrants meet in a zigzag: both ends of its edges have to move on their own.
  ThreadMonitor monitor;
  const LabelImage image = images::MakeCentred(
    14, [](double x, double y, double z)
    { return x * x + y * y > 25 || std::abs(z) > 5 ? 0 : (x < 0 ? (y < 0 ? 1 : 2) : (y < 0 ? 3 : 4)); });
  TriangleComplex surface;
  ASSERT_TRUE(ExtractInterfaces(image, surface, {}, monitor));
  std::vector<Id> curve;
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    if (surface.junctionOrder[p] == 4 && surface.junctionKind[p] == JunctionCurve)
    {
      surface.points[p] += (curve.size() % 2 ? 0.2 : -0.2) * Vec3{ 1, 0.4, 0 };
      curve.push_back(static_cast<Id>(p));
    }
  }
  ASSERT_GT(curve.size(), 6u);
  const auto zigzag = [&]()
  {
    double sum = 0;
    for (std::size_t i = 1; i + 1 < curve.size(); ++i)
    {
      const auto x = [&](std::size_t j) { return surface.points[static_cast<std::size_t>(curve[j])]; };
      sum += Norm2(x(i) - 0.5 * (x(i - 1) + x(i + 1)));
    }
    return std::sqrt(sum);
  };
  const std::vector<int> materials = MaterialsOf(surface);
  const std::vector<double> before = MaterialVolumes(surface, materials);
  const SmoothingState state(surface);
  const double rough = zigzag();
  int done = 0;
  for (int sweep = 0; sweep < 10; ++sweep)
  {
    for (std::size_t i = 0; i + 1 < curve.size(); ++i)
    {
      Relaxation r;
      if (RelaxEdge(state, curve[i], curve[i + 1], 1, r) && Norm(r.moveA) + Norm(r.moveB) < 1)
      {
        ++done;
        surface.points[static_cast<std::size_t>(r.a)] += r.moveA;
        surface.points[static_cast<std::size_t>(r.b)] += r.moveB;
      }
    }
  }
  EXPECT_GT(done, 30);
  EXPECT_LT(zigzag(), 0.5 * rough);
  const std::vector<double> after = MaterialVolumes(surface, materials);
  for (std::size_t m = 0; m < materials.size(); ++m)
  {
    EXPECT_NEAR(after[m], before[m], 1e-12 * before[m]) << materials[m];
  }
}
