// SPDX-License-Identifier: BSD-3-Clause
#include "Segmentation/Specks.h"

#include <gtest/gtest.h>

using namespace lamina;

TEST(Specks, GoToTheLabelAroundThem)
{
  // Region 3 with a hole, an island of region 7 at its edge, and an island of region 3 in a corner.
  const std::vector<int> drawing{
    3, 0, 0, 0, 0, 0, 0, 0, //
    0, 0, 3, 3, 3, 3, 0, 0, //
    0, 0, 3, 0, 3, 3, 7, 0, //
    0, 0, 3, 3, 3, 3, 7, 0, //
    0, 0, 0, 0, 0, 0, 0, 0, //
  };
  const std::vector<int> ids{ 3, 7 };
  EXPECT_EQ(SmallestParts(drawing, 8, ids), (std::vector<Id>{ 1, 1, 2 }));
  EXPECT_GT(SmallestParts(std::vector<int>(40, 3), 8, ids)[0], 1000000);
  std::vector<int> cleaned = drawing;
  RemoveSpecks(cleaned, 8, ids, { 2, 2, 2 });
  std::vector<int> expected = drawing;
  expected[0] = 0;
  expected[19] = 3;
  EXPECT_EQ(cleaned, expected);
  RemoveSpecks(cleaned, 8, ids, { 2, 2, 3 });
  expected[22] = expected[30] = 0;
  EXPECT_EQ(cleaned, expected) << "four edges with the background, two with region 3";
  cleaned = drawing;
  RemoveSpecks(cleaned, 8, ids, { 1, 1, 1 });
  EXPECT_EQ(cleaned, drawing);
}
