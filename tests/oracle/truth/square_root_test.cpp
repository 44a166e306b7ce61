// SPDX-License-Identifier: MIT
#include <oracle/truth/square_root.h>

#include <gtest/gtest.h>

#include <oracle/numbers/dice.h>

namespace lightcuts::oracle::radiometry {
namespace {

/// Of any exponent, of up to 64 bits or hundreds.
Exact random_number(gen::Dice& dice) {
  const Exact whole = Exact(dice.bits() >> dice.below(64)) + 1;
  const Exact longer = dice.one_in(2) ? whole : Exact(whole + Exact(dice.bits()) / 3);
  return ldexp(longer, dice.between(-900, 900));
}

TEST(SquareRoot, IsThatOfBoostButForTheLastBits) {
  gen::Dice dice(1);
  for (int i = 0; i < 2000; ++i) {
    const Exact x = random_number(dice), root = square_root<Exact>(x);
    EXPECT_LE(abs(root - sqrt(x)), ldexp(root, -698)) << x;
  }
}

TEST(SquareRoot, IsExactWhereThereIsOne) {
  gen::Dice dice(2);
  for (int i = 0; i < 2000; ++i) {
    const Exact whole = ldexp(Exact(dice.bits()) * dice.bits() + 1, dice.between(-400, 400));
    EXPECT_EQ(square_root<Exact>(whole * whole), whole);
  }
}

TEST(SquareRoot, OfNothingIsNothing) {
  EXPECT_EQ(square_root<Exact>(Exact(0)), 0);
  EXPECT_EQ(square_root(0.0L), 0.0L);
  EXPECT_EQ(square_root(2.25L), 1.5L);
}

} // namespace
} // namespace lightcuts::oracle::radiometry
