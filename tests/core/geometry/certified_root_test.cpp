// SPDX-License-Identifier: MIT
#include <lightcuts/core/geometry/certified_root.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <lightcuts/core/geometry/box_bounds.h>
#include <tests/support/box_reference.h>
#include <tests/support/float_limits.h>
#include <tests/support/generators.h>

namespace lightcuts {
namespace {

using gen::BoxView;
using precise::Exact;

RC_GTEST_PROP(CertifiedSup, IsTheSupremumWhereItIsDecided, ()) {
  const BoxView v = *gen::box_view();
  const double value = detail::certified_sup(v.n, {v.x, v.box});
  RC_PRE(value != detail::undecided);
  const auto exact = precise::max_cosine_over_distance2(v.n, v.x, v.box);
  RC_ASSERT((value == inf) == !exact.has_value());
  if (exact) RC_ASSERT(abs(Exact(value) - *exact) <= *exact * box_bound_error);
}

RC_GTEST_PROP(CertifiedValue, IsThatOfThePointWhereItIsDecided, ()) {
  const BoxView v = *gen::box_view();
  const double value = detail::certified_value(v.n, {v.x, {v.box.lo, v.box.lo}});
  RC_PRE(value != detail::undecided);
  const Exact exact =
      precise::objective<3>(precise::exact_vector(v.n), precise::ExactBox(v.x, v.box).lo);
  RC_ASSERT(abs(Exact(value) - exact) <= exact * box_bound_error);
}

/// Boxes of all sizes around a point, and how many of them are not decided.
TEST(CertifiedSup, IsHardlyEverUndecided) {
  gen::Dice dice(5);
  int undecided = 0;
  for (int i = 0; i < 100000; ++i) {
    const glm::vec3 n = i % 2 == 0 ? dice.unit_vector() : glm::vec3(0, 0, 1);
    const glm::vec3 half = std::ldexp(1.0F, -(i % 20)) * glm::abs(dice.in_cube());
    const glm::vec3 at = 2.0F * dice.in_cube();
    const Box box{at - half, at + half};
    undecided += detail::certified_sup(n, {glm::vec3(0), box}) == detail::undecided;
  }
  EXPECT_LT(undecided, 100);
}

TEST(CertifiedSup, LeavesWhatCancelsToOthers) {
  const glm::vec3 n(0.6F, -0.8F, 0x1p-100F);
  const Box box{{0.8F, 0.6F, 1}, {0.8F, 0.6F, 2}};
  EXPECT_EQ(detail::certified_sup(n, {glm::vec3(0), box}), detail::undecided);
  EXPECT_EQ(detail::certified_value(n, {glm::vec3(0), {box.lo, box.lo}}), detail::undecided);
  EXPECT_GT(max_cosine_over_distance2(n, glm::vec3(0), box), 0);
}

// a b - b a + 2^-100 is above 0, whatever rounding makes of it.
TEST(CertifiedSup, DoesNotTakeRoundingForTheSide) {
  gen::Dice dice(6);
  for (int i = 0; i < 1000; ++i) {
    const float a = 1 + std::abs(dice.in_cube().x), b = 1 + std::abs(dice.in_cube().y);
    const Box box{{b - 1, a, 0}, {b, a + 1, 1}};
    EXPECT_NE(detail::certified_sup({a, -b, 0x1p-100F}, {glm::vec3(0), box}), 0);
    EXPECT_GT(max_cosine_over_distance2({a, -b, 0x1p-100F}, glm::vec3(0), box), 0);
  }
}

} // namespace
} // namespace lightcuts
