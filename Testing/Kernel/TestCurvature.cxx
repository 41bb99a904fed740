// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"
#include "Sizing/Curvature.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace lamina;

namespace
{

Curvatures Fit(const TriangleComplex& surface, int threads = 2)
{
  ThreadMonitor monitor(threads);
  return FitCurvatures(surface, TrianglesOfPoints(static_cast<Id>(surface.points.size()), surface.triangles),
                       monitor);
}

/// The largest error over the points that `choose` picks, as a share of `unit`.
template<typename Choose, typename Truth>
double WorstError(const TriangleComplex& surface, const std::vector<double>& values, double unit,
                  Choose&& choose, Truth&& truth)
{
  double worst = 0;
  int count = 0;
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    if (choose(surface.points[p]))
    {
      worst = std::max(worst, std::abs(values[p] - truth(surface.points[p])) / unit);
      ++count;
    }
  }
  EXPECT_GT(count, 100);
  return worst;
}

const auto Everywhere = [](const Vec3&) { return true; };
auto Constant(double value)
{
  return [value](const Vec3&) { return value; };
}

/// Promised errors for 20 and 40 edges a diameter.
double Promised(int edges)
{
  return edges == 20 ? 0.02 : 0.007;
}

void Tell(const char* shape, int edges, double maximum, double minimum)
{
  ::testing::Test::RecordProperty(std::string(shape) + std::to_string(edges), std::to_string(maximum));
  std::printf("%s, %d edges a diameter: worst error %.4f%% and %.4f%% of 1 / radius\n", shape, edges,
              100 * maximum, 100 * minimum);
}

} // namespace

TEST(Curvature, Sphere)
{
  for (int edges : { 20, 40 })
  {
    TriangleComplex surface;
    // A level has edges of a quarter turn over 2^level: 16 and 32 along it are 20 and 41 a diameter.
    shapes::AddSphere(surface, { 1, 2, 3 }, 2.5, edges == 20 ? 4 : 5, { 1, 0 });
    shapes::JitterSphere(surface, { 1, 2, 3 }, 2.5, 0.4 / edges);
    const Curvatures found = Fit(surface);
    const double maximum = WorstError(surface, found.maximum, 0.4, Everywhere, Constant(0.4));
    const double minimum = WorstError(surface, found.minimum, 0.4, Everywhere, Constant(0.4));
    Tell("sphere", edges, maximum, minimum);
    EXPECT_LT(maximum, Promised(edges));
    EXPECT_LT(minimum, Promised(edges));
  }
}

TEST(Curvature, CylinderWithItsDirection)
{
  for (int edges : { 20, 40 })
  {
    const double edge = 2.0 / edges;
    TriangleComplex surface;
    shapes::AddTube(surface, { 5, 0, 0 }, 1, 3, edge, 0.25, { 1, 0 });
    const Curvatures found = Fit(surface);
    const auto inside = [](const Vec3& p) { return p.z > 0.5 && p.z < 2.5; };
    const double maximum = WorstError(surface, found.maximum, 1, inside, Constant(1));
    const double minimum = WorstError(surface, found.minimum, 1, inside, Constant(0));
    Tell("cylinder", edges, maximum, minimum);
    EXPECT_LT(maximum, Promised(edges));
    EXPECT_LT(minimum, Promised(edges));
    for (std::size_t p = 0; p < surface.points.size(); ++p)
    {
      if (inside(surface.points[p]))
      {
        const Vec3 radial{ surface.points[p].x - 5, surface.points[p].y, 0 };
        const Vec3& d = found.maximumDirection[p];
        EXPECT_NEAR(Norm(d), 1, 1e-12);
        EXPECT_NEAR(d.z, 0, 0.03);
        EXPECT_NEAR(Dot(d, radial), 0, 0.03);
      }
    }
    // Seen from within, the bend is the other way.
    for (Triangle& t : surface.triangles)
    {
      std::swap(t[1], t[2]);
    }
    const Curvatures turned = Fit(surface);
    EXPECT_LT(WorstError(surface, turned.minimum, 1, inside, Constant(-1)), Promised(edges));
    EXPECT_LT(WorstError(surface, turned.maximum, 1, inside, Constant(0)), Promised(edges));
  }
}

TEST(Curvature, Torus)
{
  for (int edges : { 20, 40 })
  {
    TriangleComplex surface;
    shapes::AddTorus(surface, 3, 1, 2.0 / edges, 0.2, { 1, 0 });
    const Curvatures found = Fit(surface);
    const auto around = [](const Vec3& p)
    {
      const double r = std::hypot(p.x, p.y);
      return (r - 3) / r; // cos of the angle around the tube, over the distance to the axis
    };
    const double maximum = WorstError(surface, found.maximum, 1, Everywhere, Constant(1));
    const double minimum = WorstError(surface, found.minimum, 1, Everywhere, around);
    Tell("torus", edges, maximum, minimum);
    EXPECT_LT(maximum, Promised(edges));
    EXPECT_LT(minimum, Promised(edges));
  }
}

TEST(Curvature, JunctionsTakeTheMostCurvedSheetFromItsOwnSide)
{
  // A tube of materials 1 inside and 2 outside above z = 1.5, of 1 and 3 below: two sheets meet in a ring,
  // and a fin of materials 2 and 3 goes on from it, flat.
  TriangleComplex surface;
  const double edge = 0.1;
  shapes::AddTube(surface, { 0, 0, 0 }, 1, 3, edge, 0.2, { 1, 2 });
  for (std::size_t t = 0; t < surface.triangles.size() / 2; ++t)
  {
    surface.materials[t] = { 1, 3 };
  }
  // The fin: from the ring of nodes in the middle outwards, each node to a copy further out.
  std::map<std::pair<Id, Id>, int> uses;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id a = surface.triangles[t][k];
      const Id b = surface.triangles[t][(k + 1) % 3];
      uses[{ std::min(a, b), std::max(a, b) }] |= surface.materials[t].second == 2 ? 1 : 2;
    }
  }
  std::vector<char> onRing(surface.points.size(), 0);
  std::map<Id, Id> outer;
  const auto out = [&](Id p)
  {
    onRing[static_cast<std::size_t>(p)] = 1;
    surface.points[static_cast<std::size_t>(p)].z = 1.5;
    const auto entry = outer.emplace(p, static_cast<Id>(surface.points.size()));
    if (entry.second)
    {
      const Vec3 at = surface.points[static_cast<std::size_t>(p)];
      surface.points.push_back({ 1.15 * at.x, 1.15 * at.y, at.z });
    }
    return entry.first->second;
  };
  for (const auto& use : uses)
  {
    if (use.second == 3)
    {
      const Id a = use.first.first;
      const Id b = use.first.second;
      surface.triangles.push_back({ { a, b, out(a) } });
      surface.triangles.push_back({ { b, out(b), out(a) } });
      surface.materials.insert(surface.materials.end(), 2, { 2, 3 });
    }
  }
  const Curvatures found = Fit(surface);
  int ring = 0;
  for (std::size_t p = 0; p < onRing.size(); ++p)
  {
    if (onRing[p])
    {
      ++ring;
      const double strongest = std::max(std::abs(found.maximum[p]), std::abs(found.minimum[p]));
      EXPECT_GT(strongest, 0.97);
      EXPECT_LT(strongest, 1.03);
    }
  }
  EXPECT_EQ(ring, 63);
}

TEST(Curvature, DoesNotDependOnScalePlaceOrThreads)
{
  TriangleComplex surface;
  shapes::AddTorus(surface, 3, 1, 0.2, 0.2, { 1, 0 });
  const Curvatures found = Fit(surface, 1);
  const Curvatures threads = Fit(surface, 3);
  EXPECT_EQ(found.maximum, threads.maximum);
  EXPECT_EQ(found.minimum, threads.minimum);
  for (double scale : { 1000.0, 1e-3 })
  {
    TriangleComplex other = surface;
    for (Vec3& p : other.points)
    {
      p = scale * (p + Vec3{ 2000, -5000, 1000 });
    }
    const Curvatures moved = Fit(other);
    for (std::size_t p = 0; p < surface.points.size(); ++p)
    {
      EXPECT_NEAR(moved.maximum[p] * scale, found.maximum[p], 1e-8);
      EXPECT_NEAR(moved.minimum[p] * scale, found.minimum[p], 1e-8);
    }
  }
}

TEST(Curvature, SpikesDoNotCount)
{
  // What smoothing leaves of voxels: some roughness, and single points half an edge off among short edges.
  TriangleComplex surface;
  shapes::AddSphere(surface, { 0, 0, 0 }, 1, 5, { 1, 0 });
  const double edge = MeanEdgeLength(surface);
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> rough(-0.02 * edge, 0.02 * edge);
  for (Vec3& p : surface.points)
  {
    p *= 1 + rough(generator);
  }
  int spikes = 0;
  for (std::size_t p = 0; p < surface.points.size(); p += 97)
  {
    const Vec3 at = surface.points[p];
    for (Vec3& q : surface.points)
    {
      if (Norm(q - at) < 1.6 * edge)
      {
        q = Norm(q) * Normalized(q + 0.5 * (at - q));
      }
    }
    surface.points[p] = at * (1 + 0.5 * edge);
    ++spikes;
  }
  ASSERT_GT(spikes, 40);
  const Curvatures found = Fit(surface);
  std::vector<double> errors;
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    errors.push_back(std::max(std::abs(found.maximum[p] - 1), std::abs(found.minimum[p] - 1)));
  }
  std::sort(errors.begin(), errors.end());
  const double most = errors[errors.size() * 99 / 100];
  std::printf("%d spikes: errors up to %.1f%% at half, %.1f%% at 99 in 100, %.1f%% at all points\n", spikes,
              100 * errors[errors.size() / 2], 100 * most, 100 * errors.back());
  EXPECT_LT(most, 0.16);
  EXPECT_LT(errors.back(), 0.22) << "twice as much where all points are trusted";
}

TEST(Curvature, FewPointsAndPlanePatches)
{
  // An octahedron: six points for six unknowns. A flat box: nothing bends away from its edges.
  TriangleComplex surface;
  shapes::AddSphere(surface, { 0, 0, 0 }, 1, 0, { 1, 0 });
  for (double value : Fit(surface).maximum)
  {
    EXPECT_TRUE(std::isfinite(value));
  }
  surface = {};
  shapes::AddBox(surface, { 0, 0, 0 }, { 4, 4, 4 }, { { 16, 16, 16 } }, { 1, 0 });
  const Curvatures box = Fit(surface);
  const auto flat = [](const Vec3& p) { return p.z == 4 && std::hypot(p.x - 2, p.y - 2) < 1; };
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    if (flat(surface.points[p]))
    {
      EXPECT_NEAR(box.maximum[p], 0, 1e-12);
      EXPECT_NEAR(box.minimum[p], 0, 1e-12);
    }
  }
  surface.patches.assign(surface.triangles.size(), 0);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const Triangle& c = surface.triangles[t];
    surface.patches[t] = std::all_of(
      c.begin(), c.end(), [&](Id p) { return surface.points[static_cast<std::size_t>(p)].z == 4; });
  }
  const Curvatures open = Fit(surface);
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    const Vec3& at = surface.points[p];
    if (at.z == 4 && at.x > 0 && at.x < 4 && at.y > 0 && at.y < 4)
    {
      EXPECT_EQ(Norm(open.maximumDirection[p]), 0) << "no fit in an opening";
    }
    if (at.z == 4 && at.x == 4 && std::abs(at.y - 2) < 1)
    {
      EXPECT_NEAR(open.maximum[p], 0, 1e-12) << "the rim is fitted from the wall's side alone";
    }
  }
}
