// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/RegionList.h"

#include <gtest/gtest.h>

using namespace lamina;

namespace
{

Box Cube(double low, double high)
{
  Box box;
  box.Add(Vec3{ low, low, low });
  box.Add(Vec3{ high, high, high });
  return box;
}

} // namespace

TEST(RegionList, TakesWhatNeitherReadsNorIsReadByTheOthers)
{
  RegionList list;
  EXPECT_TRUE(list.Admit({ Cube(0, 1), Cube(-1, 2) }));
  EXPECT_FALSE(list.Admit({ Cube(1.5, 1.8), Cube(1.5, 1.8) })) << "the first reads what this one writes";
  EXPECT_FALSE(list.Admit({ Cube(5, 6), Cube(0.5, 6) })) << "this one reads what the first writes";
  EXPECT_FALSE(list.Admit({ Cube(2, 3), Cube(2, 3) })) << "they touch";
  EXPECT_TRUE(list.Admit({ Cube(3, 4), Cube(1.5, 5) })) << "both may read the same";
  EXPECT_FALSE(list.Admit({ Cube(4.5, 4.6), Cube(4.5, 4.6) })) << "the second is there too";
  list.Clear();
  EXPECT_TRUE(list.Admit({ Cube(1.5, 1.8), Cube(1.5, 1.8) }));
}

TEST(RegionList, RoundsOutwardsFarFromTheOrigin)
{
  RegionList list;
  const double far = 1e6; // where floats are a sixteenth apart
  EXPECT_TRUE(list.Admit({ Cube(far, far + 1), Cube(far, far + 1) }));
  EXPECT_FALSE(list.Admit({ Cube(far + 1.01, far + 2), Cube(far + 1.01, far + 2) })) << "too near to tell";
  EXPECT_TRUE(list.Admit({ Cube(far + 1.5, far + 2), Cube(far + 1.5, far + 2) }));
}
