// SPDX-License-Identifier: MIT
#include <lightcuts/core/numerics/exponential.h>

#include <limits>

#include <gtest/gtest.h>

#include <tests/support/generators.h>
#include <tests/support/precise.h>

namespace lightcuts {
namespace {

TEST(ExpOfMinus, KeepsToTheStatedError) {
  gen::Dice dice(5);
  for (int i = 0; i < 5000; ++i) {
    const double t = i % 2 == 0 ? dice.uniform(0, 700) : std::abs(double(dice.log_uniform(-30, 2)));
    const precise::Quad exact = exp(-precise::Quad(t));
    EXPECT_LE(abs(precise::Quad(exp_of_minus(t)) - exact), exact * exponential_error) << t;
  }
}

TEST(ExpOfMinus, IsExactAtTheEnds) {
  EXPECT_EQ(exp_of_minus(0), 1);
  EXPECT_EQ(exp_of_minus(701), 0);
  EXPECT_EQ(exp_of_minus(std::numeric_limits<double>::infinity()), 0);
}

} // namespace
} // namespace lightcuts
