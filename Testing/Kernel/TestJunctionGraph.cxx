// SPDX-License-Identifier: BSD-3-Clause
#include "Images.h"
#include "Mesh/JunctionGraph.h"
#include "Shapes.h"
#include "Surface/ExtractInterfaces.h"

#include <gtest/gtest.h>

#include <map>

using namespace lamina;

namespace
{

TriangleComplex Extract(const LabelImage& image)
{
  ThreadMonitor monitor;
  TriangleComplex surface;
  EXPECT_TRUE(ExtractInterfaces(image, surface, {}, monitor));
  surface.junctionKind.clear();
  surface.junctionOrder.clear();
  return surface;
}

/// How many points have each (kind, order).
std::map<std::array<int, 2>, int> Census(const TriangleComplex& surface)
{
  std::map<std::array<int, 2>, int> census;
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    ++census[{ { surface.junctionKind[p], surface.junctionOrder[p] } }];
  }
  return census;
}

int CountFeatures(const TriangleComplex& surface)
{
  int count = 0;
  for (char flag : FeatureEdges(surface, MakeEdgeTable(surface.triangles)))
  {
    count += flag ? 1 : 0;
  }
  return count;
}

using Expected = std::map<std::array<int, 2>, int>;

} // namespace

TEST(JunctionGraph, ASphereIsOneSheet)
{
  TriangleComplex surface;
  shapes::AddSphere(surface, {}, 1, 2, { 1, 0 });
  ClassifyJunctions(surface);
  EXPECT_EQ(Census(surface), (Expected{ { { { 0, 2 } }, static_cast<int>(surface.points.size()) } }));
  EXPECT_EQ(CountFeatures(surface), 0);
}

TEST(JunctionGraph, TwoBoxesShareARing)
{
  // Two cubes of 2^3 voxels side by side: the rim of their common square is the only curve.
  const auto image = images::Make({ { 6, 4, 4 } },
                                  [](Id i, Id j, Id k)
                                  {
                                    const bool in = i >= 1 && i <= 4 && j >= 1 && j <= 2 && k >= 1 && k <= 2;
                                    return in ? (i <= 2 ? 1 : 2) : 0;
                                  });
  TriangleComplex surface = Extract(image);
  ClassifyJunctions(surface);
  const int sheet = static_cast<int>(surface.points.size()) - 8;
  EXPECT_EQ(Census(surface), (Expected{ { { { 0, 2 } }, sheet }, { { { 1, 3 } }, 8 } }));
  EXPECT_EQ(CountFeatures(surface), 8);
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    if (surface.junctionKind[p] == JunctionCurve)
    {
      EXPECT_EQ(surface.points[p].x, 2.5);
    }
  }
}

TEST(JunctionGraph, ThreeBoxesMeetInTwoCorners)
{
  // Material 1 beside 2 and 3, which stand on each other: the line where the three meet ends in two corners.
  const auto image = images::Make({ { 6, 6, 4 } },
                                  [](Id i, Id j, Id k)
                                  {
                                    const bool in = i >= 1 && i <= 4 && j >= 1 && j <= 4 && k >= 1 && k <= 2;
                                    return in ? (i <= 2 ? 1 : (j <= 2 ? 2 : 3)) : 0;
                                  });
  TriangleComplex surface = Extract(image);
  ClassifyJunctions(surface);
  int corners = 0;
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    const Vec3& x = surface.points[p];
    const bool onLine = x.x == 2.5 && x.y == 2.5;
    const bool onEnd = x.z == 0.5 || x.z == 2.5;
    if (surface.junctionKind[p] == JunctionCorner)
    {
      ++corners;
      EXPECT_TRUE(onLine && onEnd) << ToString(x);
      EXPECT_EQ(surface.junctionOrder[p], 4);
    }
    else if (onLine)
    {
      EXPECT_EQ(surface.junctionKind[p], JunctionCurve);
      EXPECT_EQ(surface.junctionOrder[p], 3);
    }
  }
  EXPECT_EQ(corners, 2);
}

TEST(JunctionGraph, BorderPlanesMeetInCurvesAndCorners)
{
  TriangleComplex surface = Extract(images::Make({ { 3, 3, 3 } }, [](Id, Id, Id) { return 4; }));
  ClassifyJunctions(surface);
  EXPECT_EQ(Census(surface), (Expected{ { { { 4, 2 } }, 24 }, { { { 5, 2 } }, 24 }, { { { 6, 2 } }, 8 } }));
  EXPECT_EQ(CountFeatures(surface), 36);
}

TEST(JunctionGraph, ARimIsAFeature)
{
  TriangleComplex square;
  square.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  square.triangles = { { { 0, 1, 2 } }, { { 0, 2, 3 } } };
  square.materials = { { 1, 0 }, { 1, 0 } };
  EXPECT_EQ(CountFeatures(square), 4);
  square.patches = { 0, 1 };
  EXPECT_EQ(CountFeatures(square), 5);
  square.patches.clear();
  square.materials[1] = { 1, 2 };
  EXPECT_EQ(CountFeatures(square), 5);
}
