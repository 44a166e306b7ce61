// SPDX-License-Identifier: MIT
#include <oracle/numbers/dice.h>

#include <array>
#include <vector>

#include <gtest/gtest.h>

namespace lightcuts::gen {
namespace {

TEST(Dice, RollTheSameNumbersOfTheSameSeed) {
  Dice a(7), b(7);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(a.bits(), b.bits());
}

TEST(Dice, RollWhatBytesSay) {
  const std::array<std::uint8_t, 14> bytes{5, 200, 0x12, 0x34, 0x56, 0x78, 1, 2, 3, 4, 5, 6, 7, 8};
  Dice dice(bytes);
  EXPECT_EQ(dice.below(4), 1);
  EXPECT_EQ(dice.below(256), 200);
  EXPECT_EQ(dice.below(1 << 30), 0x78563412 % (1 << 30));
  EXPECT_EQ(dice.bits(), 0x0807060504030201U);
}

TEST(Dice, RollTheNumbersOfSeed0AfterTheLastByte) {
  const std::array<std::uint8_t, 2> bytes{3, 4};
  Dice dice(bytes), seeded(0);
  EXPECT_EQ(dice.bits(), 0x0403U); // what there is
  for (int i = 0; i < 10; ++i) EXPECT_EQ(dice.bits(), seeded.bits());
  EXPECT_EQ(Dice(std::vector<std::uint8_t>{}).bits(), Dice(0).bits());
}

// Else what is one in eight of those that are not one in eight would never be.
TEST(Dice, AsideOfBytesAreNotInStep) {
  const std::array<std::uint8_t, 4> bytes{1, 2, 3, 4};
  Dice dice(bytes);
  EXPECT_EQ(dice.aside().below(100), 2);
  EXPECT_EQ(dice.aside().aside().below(100), 3);
  EXPECT_EQ(dice.below(100), 1);
}

} // namespace
} // namespace lightcuts::gen
