// SPDX-License-Identifier: MIT
#include <oracle/campaign/ladder.h>

#include <gtest/gtest.h>

namespace lightcuts::oracle {
namespace {

TEST(Ladder, DaresAnythingAtFirst) { EXPECT_TRUE(Ladder().dares(1'000'000)); }

TEST(Ladder, StopsWhereTheCubeWouldTakeTooLong) {
  Ladder ladder;
  ladder.went(100, 1);
  EXPECT_TRUE(ladder.dares(215));
  EXPECT_FALSE(ladder.dares(216));
  ladder.went(200, 0.5);
  EXPECT_TRUE(ladder.dares(500));
  EXPECT_FALSE(ladder.dares(600));
}

TEST(Ladder, GoesByTheMostLights) {
  Ladder ladder;
  ladder.went(1000, 9);
  ladder.went(10, 0.001);
  EXPECT_FALSE(ladder.dares(2000));
  EXPECT_TRUE(ladder.dares(1000));
  ladder.went(1000, 11);
  EXPECT_FALSE(ladder.dares(10));
}

} // namespace
} // namespace lightcuts::oracle
