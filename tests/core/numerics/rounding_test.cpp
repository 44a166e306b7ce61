// SPDX-License-Identifier: MIT
#include <lightcuts/core/numerics/rounding.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <lightcuts/core/lobes/material.h>
#include <tests/support/float_limits.h>
#include <tests/support/generators.h>
#include <tests/support/precise.h>

namespace lightcuts {
namespace {

using precise::Quad;

/// A double >= 0: a float, a neighbour of one, between two, or beyond them all.
double some_value(gen::Dice& dice) {
  const double value = std::abs(dice.finite_float());
  switch (dice.below(4)) {
  case 0:
    return value;
  case 1:
    return std::nextafter(value, 1e300);
  case 2:
    return value * dice.uniform(0, 2);
  default:
    return std::pow(10.0, dice.uniform(-320, 300));
  }
}

RC_GTEST_PROP(RoundUp, YieldsTheSmallestFloatThatIsNotBelow, ()) {
  const double value = *gen::from_dice(some_value);
  const float up = round_up(value);
  RC_ASSERT(double(up) >= value);
  RC_ASSERT(up == 0 || double(std::nextafter(up, 0.0F)) < value);
}

RC_GTEST_PROP(ToFloat, YieldsTheNearestFloat, ()) {
  const double value = *gen::from_dice(some_value);
  const float f = to_float(value);
  if (value > largest_float) {
    RC_ASSERT(f == inf);
    return;
  }
  const double error = std::abs(double(f) - value);
  RC_ASSERT(error <= std::abs(double(std::nextafter(f, inf)) - value));
  RC_ASSERT(f == 0 || error <= std::abs(double(std::nextafter(f, 0.0F)) - value));
}

TEST(RoundUp, KeepsFloatsAndNeverLosesAPositiveValue) {
  EXPECT_EQ(round_up(0.0), 0.0F);
  EXPECT_EQ(round_up(1.0), 1.0F);
  EXPECT_EQ(round_up(0x1p-1074), 0x1p-149F);
  EXPECT_EQ(round_up(largest_float), largest_float);
  EXPECT_EQ(round_up(std::nextafter(double(largest_float), 1e300)), inf);
  EXPECT_EQ(round_up(std::numeric_limits<double>::infinity()), inf);
}

/// An exponent, and a base in [0, 1] for which the power does not underflow.
struct PowerCase {
  double base;
  float exponent;
};

std::ostream& operator<<(std::ostream& out, const PowerCase& p) {
  return out << std::hexfloat << p.base << " ^ " << p.exponent << std::defaultfloat;
}

rc::Gen<PowerCase> power_case() {
  return gen::from_dice<PowerCase>([](gen::Dice& dice) {
    const float exponent =
        dice.pick({0.0F, 1.0F, 10.0F, 1000.0F, 0x1p20F, 0x1.ffffep19F, float(dice.uniform(0, 8)),
                   float(dice.uniform(0, 0x1p20)), std::abs(dice.subnormal())});
    const double least = std::pow(10.0, -300.0 / std::max(exponent, 1.0F));
    const double base = dice.one_in(8) ? 1.0 : dice.uniform(least, 1);
    return PowerCase{base, exponent};
  });
}

RC_GTEST_PROP(Power, KeepsToTheStatedError, ()) {
  const PowerCase p = *power_case();
  const Quad exact = precise::power(Quad(p.base), p.exponent);
  RC_ASSERT(abs(Quad(power(p.base, p.exponent)) - exact) <= exact * power_error);
}

RC_GTEST_PROP(Power, RisesWithTheBase, ()) {
  const PowerCase p = *power_case();
  const double other = (*power_case()).base;
  const double next = std::nextafter(p.base, 2.0);
  RC_ASSERT(power(p.base, p.exponent) <= power(next, p.exponent));
  RC_ASSERT(power(std::min(p.base, other), p.exponent) <=
            power(std::max(p.base, other), p.exponent));
}

TEST(Power, KnowsItsSpecialCases) {
  EXPECT_EQ(power(0, 0), 1);
  EXPECT_EQ(power(0, 0.5F), 0);
  EXPECT_EQ(power(1, Phong::max_exponent), 1);
  EXPECT_EQ(power(0.25, 0.5F), 0.5);
  EXPECT_EQ(power(2, 10), 1024);
}

TEST(RoundDown, IsTheLargestFiniteFloatNotAbove) {
  for (const double v : {0.0, 1e-60, 0x1p-149, 1.0, 1 + 0x1p-30, 2 - 0x1p-30, 3e38, 1e40}) {
    const float down = round_down(v);
    EXPECT_LE(double(down), v);
    EXPECT_TRUE(std::isfinite(down));
    const float next = std::nextafter(down, std::numeric_limits<float>::infinity());
    EXPECT_GT(double(next), v);
  }
}

} // namespace
} // namespace lightcuts
