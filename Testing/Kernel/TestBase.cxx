// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Monitor.h"
#include "Base/Result.h"
#include "Base/Text.h"

#include <gtest/gtest.h>

using namespace lamina;

TEST(Monitor, EveryItemIsVisitedOnce)
{
  for (int threads : { 1, 2, 5 })
  {
    ThreadMonitor monitor(threads);
    std::vector<int> visits(1003, 0);
    monitor.For(1003, 10,
                [&](Id begin, Id end)
                {
                  for (Id i = begin; i < end; ++i)
                  {
                    ++visits[static_cast<std::size_t>(i)];
                  }
                });
    EXPECT_EQ(visits, std::vector<int>(1003, 1));
  }
}

TEST(Monitor, CancelStopsTheLoop)
{
  ThreadMonitor monitor(1);
  Id done = 0;
  monitor.For(1000, 1,
              [&](Id, Id)
              {
                if (++done == 10)
                {
                  monitor.Cancel();
                }
              });
  EXPECT_EQ(done, 10);
  EXPECT_TRUE(monitor.Cancelled());
}

TEST(Result, PlacesAreDescribed)
{
  EXPECT_EQ(DescribePlaces({}), "");
  EXPECT_EQ(DescribePlaces({ { 1, 2, 3 } }), " at (1, 2, 3)");
  EXPECT_EQ(DescribePlaces({ { 1, 2, 3 }, { 1, 2, 4 }, { 1, 2, 5 }, { 0, 0, 0 }, { 0, 0, 1 } }),
            " at (1, 2, 3), (1, 2, 4), (1, 2, 5) and 2 more");
}

TEST(Text, TellsAmountsAsAPersonReadsThem)
{
  EXPECT_EQ(Amount(0, "opening"), "0 openings");
  EXPECT_EQ(Amount(1, "opening"), "1 opening");
  EXPECT_EQ(Amount(9999, "cell"), "9999 cells");
  EXPECT_EQ(Amount(10000, "cell"), "10.0 k cells");
  EXPECT_EQ(Amount(123456, "cell"), "123 k cells");
  EXPECT_EQ(Amount(999499, "cell"), "999 k cells");
  EXPECT_EQ(Amount(999500, "cell"), "1.0 M cells");
  EXPECT_EQ(Amount(1234567, "tetrahedron", "tetrahedra"), "1.2 M tetrahedra");
  EXPECT_EQ(Short(0.14159), "0.142");
  EXPECT_EQ(Short(1.5e-12), "1.5e-12");
}
