// SPDX-License-Identifier: MIT
#include <lightcuts/core/numerics/angle.h>

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <tests/support/generators.h>

namespace lightcuts {
namespace {

Angle of(double radians) { return {std::cos(radians), std::sin(radians)}; }

void expect_angle(const Angle& angle, double radians) {
  // The C library's cosine and sine add their own rounding to angle_error.
  constexpr double error = angle_error + 0x1p-51;
  EXPECT_NEAR(angle.cos, std::cos(radians), error) << radians;
  EXPECT_NEAR(angle.sin, std::sin(radians), error) << radians;
}

TEST(Angle, AddsSubtractsAndHalvesAsItsRadiansDo) {
  gen::Dice dice(3);
  for (int i = 0; i < 20000; ++i) {
    const double a = std::min(std::abs(double(dice.log_uniform(-12, 0.497))), std::numbers::pi);
    const double b = dice.uniform(0, std::numbers::pi);
    expect_angle(sum(of(a), of(b)), std::min(a + b, std::numbers::pi));
    expect_angle(difference(of(a), of(b)), std::max(a - b, 0.0));
    expect_angle(difference(of(b), of(a)), std::max(b - a, 0.0));
    expect_angle(half(of(b)), b / 2);
    expect_angle(supplement(of(a)), std::numbers::pi - a);
  }
}

TEST(Angle, KeepsTheDigitsOfSmallHalves) {
  EXPECT_DOUBLE_EQ(half(of(1e-12)).sin, 0.5e-12);
  EXPECT_DOUBLE_EQ(half({-1, 0}).sin, 1);
}

TEST(Angle, EndsAtAHalfTurn) {
  EXPECT_EQ(sum({-1, 0}, {-1, 0}).cos, -1);
  EXPECT_EQ(sum(of(3), of(3)).cos, -1);
  EXPECT_EQ(difference({-1, 0}, {1, 0}).cos, -1);
  EXPECT_EQ(difference({1, 0}, {-1, 0}).cos, 1);
}

TEST(Angle, BetweenVectorsNeedsNoUnitLength) {
  expect_angle(angle_between({3e30, 0, 0}, {1e-30, 1e-30, 0}), std::numbers::pi / 4);
  expect_angle(angle_between({1, 2, 3}, {-1, -2, -3}), std::numbers::pi);
  EXPECT_NEAR(angle_between({1, 0, 0}, {1, 1e-20, 0}).sin / 1e-20, 1, 1e-15);
}

} // namespace
} // namespace lightcuts
