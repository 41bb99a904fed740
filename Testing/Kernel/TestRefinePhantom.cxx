// SPDX-License-Identifier: BSD-3-Clause
// Refinement of surfaces from images: the nodes around the coronaries of the phantom heart, and the same
// shape in two sizes.
#include "Images.h"
#include "Mesh/Adjacency.h"
#include "Segmentation/HeartPhantom.h"
#include "Sizing/FeatureSize.h"
#include "Surface/ExtractInterfaces.h"
#include "Surface/RefineSurface.h"
#include "Surface/SmoothSurface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

using namespace lamina;

namespace
{

constexpr double Pi = 3.14159265358979323846;
constexpr int Blood = 2;

TriangleComplex Smoothed(const LabelImage& labels)
{
  ThreadMonitor monitor(2);
  TriangleComplex surface;
  EXPECT_TRUE(ExtractInterfaces(labels, surface, {}, monitor));
  EXPECT_TRUE(SmoothSurface(surface, {}, monitor));
  return surface;
}

/// What a plane cuts out of a surface around a place: a closed ring, or nothing.
struct Section
{
  int above = 0; ///< triangles that the plane goes through with two corners above it: the nodes there
  int below = 0;
  double length = 0;
  double turns = 0; ///< of the ring around the place
};

class SectionCutter
{
public:
  SectionCutter(const TriangleComplex& surface, int material)
    : Surface(surface)
  {
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
      if (SideOf(surface.materials[t], material) != 0)
      {
        this->Own.push_back(t);
      }
    }
  }

  /// The ring nearest to `centre` in the plane through it across `axis` (unit).
  Section Cut(const Vec3& centre, const Vec3& axis, double reach) const
  {
    std::map<std::pair<Id, Id>, std::vector<std::size_t>> atEdge;
    std::size_t first = 0;
    double nearest = reach;
    for (std::size_t t : this->Own)
    {
      const Triangle& c = this->Surface.triangles[t];
      const Vec3 middle = (1.0 / 3) * (this->At(c[0]) + this->At(c[1]) + this->At(c[2])) - centre;
      if (Norm(middle) > 2 * reach)
      {
        continue;
      }
      bool crosses = false;
      for (std::size_t k = 0; k < 3; ++k)
      {
        const auto edge = std::minmax(c[k], c[(k + 1) % 3]);
        if (this->Height(edge.first, centre, axis) > 0 != this->Height(edge.second, centre, axis) > 0)
        {
          atEdge[edge].push_back(t);
          crosses = true;
        }
      }
      if (crosses && Norm(middle) < nearest)
      {
        nearest = Norm(middle);
        first = t;
      }
    }
    return nearest < reach ? this->Walk(first, atEdge, centre, axis) : Section{};
  }

private:
  const Vec3& At(Id p) const { return this->Surface.points[static_cast<std::size_t>(p)]; }
  double Height(Id p, const Vec3& centre, const Vec3& axis) const { return Dot(this->At(p) - centre, axis); }

  Section Walk(std::size_t first, const std::map<std::pair<Id, Id>, std::vector<std::size_t>>& atEdge,
               const Vec3& centre, const Vec3& axis) const
  {
    const auto crossing = [&](const std::pair<Id, Id>& edge)
    {
      const double a = this->Height(edge.first, centre, axis);
      const double b = this->Height(edge.second, centre, axis);
      return this->At(edge.first) + (a / (a - b)) * (this->At(edge.second) - this->At(edge.first)) - centre;
    };
    Section section;
    std::set<std::size_t> seen;
    std::pair<Id, Id> behind{ -1, -1 };
    std::size_t t = first;
    while (seen.insert(t).second)
    {
      std::vector<std::pair<Id, Id>> edges; // of this triangle, the one it was entered through first
      const Triangle& c = this->Surface.triangles[t];
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::pair<Id, Id> edge = std::minmax(c[k], c[(k + 1) % 3]);
        if (atEdge.count(edge) > 0)
        {
          edges.insert(edge == behind ? edges.begin() : edges.end(), edge);
        }
      }
      if (edges.size() != 2 || atEdge.at(edges[1]).size() != 2)
      {
        return {};
      }
      const Vec3 from = crossing(edges[0]);
      const Vec3 to = crossing(edges[1]);
      section.length += Norm(to - from);
      section.turns += std::atan2(Dot(axis, Cross(from, to)), Dot(from, to)) / (2 * Pi);
      const auto high =
        std::count_if(c.begin(), c.end(), [&](Id p) { return this->Height(p, centre, axis) > 0; });
      ++(high == 2 ? section.above : section.below);
      const std::vector<std::size_t>& pair = atEdge.at(edges[1]);
      behind = edges[1];
      t = pair[0] == t ? pair[1] : pair[0];
    }
    return t == first ? section : Section{};
  }

  const TriangleComplex& Surface;
  std::vector<std::size_t> Own;
};

} // namespace

TEST(RefinePhantom, CoronariesKeepTheirNodesRound)
{
  ThreadMonitor monitor(2);
  HeartPhantomOptions heart;
  heart.resolution = 96;
  GreyImage grey;
  LabelImage labels;
  const auto phantom = MakeHeartPhantom(grey, labels, heart, monitor);
  ASSERT_TRUE(phantom);
  TriangleComplex surface = Smoothed(labels);
  FeatureSizeOptions sizing;
  sizing.minimum = 2; // 1.6 voxels: below that of the program's own choice
  const auto sized = ComputeFeatureSize(surface, sizing, monitor);
  ASSERT_TRUE(sized);
  ASSERT_TRUE(RefineSurface(surface, {}, monitor));
  const SectionCutter cutter(surface, Blood);
  // The size that gives a circle its nodes, over the diameter.
  const double sizeOfCircle = Pi / sizing.nodesPerCircumference * sizing.layers / sizing.anisotropy;
  int sections = 0;
  int least = 1000;
  double thinnest = 1e9;
  double thickest = 0;
  for (const HeartPhantomRod& rod : phantom->coronaries)
  {
    const auto world = [&](const Vec3& p) { return labels.grid.ToWorld(p.x, p.y, p.z); };
    const Vec3 way = world(rod.to) - world(rod.from);
    for (double w = 0.1; w < 0.95; w += 0.1)
    {
      const double width = (1 - w) * rod.fromDiameter + w * rod.toDiameter;
      const Section ring =
        cutter.Cut(world(rod.from) + w * way, Normalized(way), width * labels.grid.spacing.x);
      const double diameter = ring.length / Pi;
      // A ring around the vessel alone, away from branches, that asks for no less than the least size.
      if (std::abs(std::abs(ring.turns) - 1) > 1e-6 || diameter > 1.4 * width * labels.grid.spacing.x ||
          sizeOfCircle * diameter < sized->minimum)
      {
        continue;
      }
      ++sections;
      const int nodes = std::max(ring.above, ring.below);
      least = std::min(least, nodes);
      thinnest = std::min(thinnest, diameter);
      thickest = std::max(thickest, diameter);
      EXPECT_GE(nodes, sizing.nodesPerCircumference)
        << "diameter " << diameter << " at " << w << " of the piece from " << rod.from.x << " " << rod.from.y;
    }
  }
  std::printf("%d sections, diameters %.2f to %.2f, at least %d nodes round\n", sections, thinnest, thickest,
              least);
  EXPECT_GT(sections, 100);
}

TEST(RefinePhantom, TheSameShapeFourTimesAsLargeInOneImage)
{
  // Two egg-shaped bodies; half axes of 6, 5, 4.5 voxels, and four times that. So far apart that the slope of
  // the sizes does not carry the small one's to the large one.
  const auto inside = [](Id i, Id j, Id k, const Vec3& centre, double scale)
  {
    const Vec3 d{ (static_cast<double>(i) - centre.x) / 6, (static_cast<double>(j) - centre.y) / 5,
                  (static_cast<double>(k) - centre.z) / 4.5 };
    return Norm2(d) < scale * scale;
  };
  const LabelImage image = images::Make(
    { { 166, 48, 44 } },
    [&](Id i, Id j, Id k) {
      return inside(i, j, k, { 26.3, 23.6, 21.4 }, 4) || inside(i, j, k, { 153.3, 23.6, 21.4 }, 1) ? 1 : 0;
    });
  TriangleComplex surface = Smoothed(image);
  FeatureSizeOptions sizing;
  sizing.layers = 18;
  sizing.minimum = 1;
  sizing.maximum = 100;
  ThreadMonitor monitor(2);
  ASSERT_TRUE(ComputeFeatureSize(surface, sizing, monitor));
  const double smallest = *std::min_element(surface.targetEdgeLength.begin(), surface.targetEdgeLength.end());
  RefineSurfaceOptions options;
  options.tolerance = 0.5; // of a voxel, which is less than a tenth of either
  ASSERT_TRUE(RefineSurface(surface, options, monitor));
  Id small = 0;
  double area = 0;
  for (const Triangle& t : surface.triangles)
  {
    small += surface.points[static_cast<std::size_t>(t[0])].x > 100 ? 1 : 0;
    area += 0.5 * Norm(AreaVector2(surface.points, t));
  }
  const Id large = static_cast<Id>(surface.triangles.size()) - small;
  const double asUniform = area / (std::sqrt(3.0) / 4 * smallest * smallest);
  std::printf("%lld triangles on the large, %lld on the small; uniform: %.1f times as many\n", large, small,
              asUniform / static_cast<double>(large + small));
  EXPECT_NEAR(static_cast<double>(large) / static_cast<double>(small), 1, 0.1);
  EXPECT_GT(asUniform, 5 * static_cast<double>(large + small));
}
