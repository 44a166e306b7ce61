// SPDX-License-Identifier: MIT
#include <lightcuts/core/numerics/exact_dot.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <tests/support/generators.h>
#include <tests/support/precise.h>

namespace lightcuts {
namespace {

using precise::Exact;

/// n and two points. Half the time y - x is all but orthogonal to n.
struct DotOperands {
  glm::vec3 n, x, y;
};

std::ostream& operator<<(std::ostream& out, const DotOperands& o) {
  return out << gen::BoxView{{o.y, o.y}, o.x, o.n};
}

/// The float z that brings n.(y - x) closest to 0, or a neighbour of it.
float cancelling_z(gen::Dice& dice, const DotOperands& o) {
  Exact rest = 0;
  for (int i = 0; i < 2; ++i) rest += Exact(o.n[i]) * (Exact(o.y[i]) - Exact(o.x[i]));
  const Exact z = Exact(o.x.z) - rest / Exact(o.n.z);
  const float nearest = gen::Dice::finite(static_cast<double>(z));
  return gen::Dice::finite(std::nextafter(nearest, dice.pick({-1e38F, nearest, 1e38F})));
}

rc::Gen<DotOperands> dot_operands() {
  return gen::from_dice<DotOperands>([](gen::Dice& dice) {
    DotOperands o{dice.one_in(2) ? dice.unit_vector() : dice.finite_vector(), dice.finite_vector(),
                  dice.finite_vector()};
    if (dice.one_in(2)) o.y = dice.in_cube(), o.x = dice.in_cube();
    if (dice.one_in(2) && o.n.z != 0) o.y.z = cancelling_z(dice, o);
    return o;
  });
}

RC_GTEST_PROP(ExactDot, HasTheSignOfTheRealNumberAndAFewRoundings, ()) {
  const DotOperands o = *dot_operands();
  const Exact exact = precise::dot(o.n, o.x, o.y);
  const double value = exact_dot(o.n, o.x, o.y);
  RC_ASSERT(precise::same_sign(value, exact));
  // The terms do not overlap: what the final sum of 6 loses is less than 2 ulps.
  RC_ASSERT(abs(Exact(value) - exact) <= abs(exact) * 0x1p-51);
}

RC_GTEST_PROP(DotBetween, HasTheSignOfTheRealNumberAndTheStatedError, ()) {
  const DotOperands o = *dot_operands();
  const Exact exact = precise::dot(o.n, o.x, o.y);
  const double value = dot_between(o.n, o.x, o.y);
  RC_ASSERT(precise::same_sign(value, exact));
  RC_ASSERT(abs(Exact(value) - exact) <= abs(exact) * dot_error);
}

RC_GTEST_PROP(DotBetween, ChangesSignWithTheDirection, ()) {
  const DotOperands o = *dot_operands();
  RC_ASSERT(dot_between(-o.n, o.x, o.y) == -dot_between(o.n, o.x, o.y));
  RC_ASSERT(dot_between(o.n, o.x, o.x) == 0);
}

TEST(DotBetween, SeesTheLastBitOfACancellation) {
  EXPECT_EQ(dot_between({1, 1, 1}, {0, 0, 0}, {0x1p100F, 0x1p-149F, -0x1p100F}), 0x1p-149);
  EXPECT_EQ(dot_between({0x1p-149F, 1, 0}, {0, 1e30F, 0}, {0x1p-149F, 1e30F, 0}), 0x1p-298);
  EXPECT_EQ(dot_between({1, 1, 0}, {0x1p-149F, 1e8F, 0}, {1e8F, 0, 0}), -0x1p-149);
}

} // namespace
} // namespace lightcuts
