// SPDX-License-Identifier: MIT
#include <lightcuts/core/cut/certified_error.h>

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <tests/support/float_limits.h>
#include <tests/support/generators.h>
#include <tests/support/precise.h>

namespace lightcuts {
namespace {

using precise::Quad;

/// A double >= 0 of any scale that sums of estimates reach.
double some_total(gen::Dice& dice) {
  if (dice.one_in(4)) return std::abs(double(dice.finite_float())) * dice.uniform(0, 2);
  return dice.one_in(8) ? 0.0 : std::pow(10.0, dice.uniform(-320, 45));
}

RC_GTEST_PROP(CertifiedError, CoversTheBoundsAndTheRoundingOfTheTotal, ()) {
  const double total = *gen::from_dice(some_total);
  const double bounds = *gen::from_dice(some_total);
  const float error = certified_error(total, bounds);
  RC_ASSERT(!std::isnan(error));
  const float radiance = to_float(total);
  RC_ASSERT(error == inf || Quad(error) >= Quad(bounds) + abs(Quad(radiance) - Quad(total)));
  if (radiance == inf) RC_ASSERT(error == inf);
}

TEST(CertifiedError, IsInfiniteWhereTheRadianceIs) {
  EXPECT_EQ(certified_error(1e39, 0), inf);
  EXPECT_EQ(certified_error(1, std::numeric_limits<double>::infinity()), inf);
}

TEST(CertifiedError, AllowsForUnderflowAndNoMoreWhereTheTotalIsZero) {
  EXPECT_GT(certified_error(0, 0), 0);
  EXPECT_LE(certified_error(0, 0), 2 * 0x1p-149F);
}

} // namespace
} // namespace lightcuts
