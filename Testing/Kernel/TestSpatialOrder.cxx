// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/SpatialOrder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

using namespace lamina;

TEST(SpatialOrder, EachPointOnceAndNeighboursTogether)
{
  std::mt19937 random(5);
  std::vector<Vec3> points; // of a lattice, shuffled, one of them twice
  for (int i = 0; i < 4096; ++i)
  {
    points.push_back({ i % 16 - 300.0, i / 16 % 16 + 7.0, i / 256 * 1.0 });
  }
  std::shuffle(points.begin(), points.end(), random);
  points.push_back(points[1000]);
  std::vector<Id> order = SpatialOrder(points);
  double way = 0;
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    way += Norm(points[static_cast<std::size_t>(order[i])] - points[static_cast<std::size_t>(order[i - 1])]);
  }
  EXPECT_LT(way, 2.5 * 4096); // in the order given it would be ten lattice steps from each to the next
  const auto twin = std::find(order.begin(), order.end(), Id{ 1000 });
  EXPECT_EQ(*(twin + 1), 4096);
  std::sort(order.begin(), order.end());
  std::vector<Id> all(points.size());
  std::iota(all.begin(), all.end(), Id{ 0 });
  EXPECT_EQ(order, all);
  EXPECT_TRUE(SpatialOrder({}).empty());
  EXPECT_EQ(SpatialOrder({ { 1, 2, 3 }, { 1, 2, 3 } }), (std::vector<Id>{ 0, 1 }));
}
