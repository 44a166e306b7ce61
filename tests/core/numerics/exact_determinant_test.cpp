// SPDX-License-Identifier: MIT
#include <lightcuts/core/numerics/exact_determinant.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <tests/support/generators.h>
#include <tests/support/precise.h>

namespace lightcuts {
namespace {

using precise::Exact;

/// Two directions and two points. Half the time y - x is all but in their plane.
struct DeterminantOperands {
  glm::vec3 a, x, y, b;
};

std::ostream& operator<<(std::ostream& out, const DeterminantOperands& o) {
  return out << gen::BoxView{{o.y, o.y}, o.x, o.a} << gen::BoxView{{o.y, o.y}, o.x, o.b};
}

glm::vec3 finite(const glm::dvec3& v) {
  return {gen::Dice::finite(v.x), gen::Dice::finite(v.y), gen::Dice::finite(v.z)};
}

rc::Gen<DeterminantOperands> determinant_operands() {
  return gen::from_dice<DeterminantOperands>([](gen::Dice& dice) {
    DeterminantOperands o{dice.unit_vector(), dice.finite_vector(), dice.finite_vector(),
                          dice.unit_vector()};
    if (dice.one_in(3)) o.b = -o.a;
    if (dice.one_in(3)) o.b[dice.below(3)] = dice.subnormal();
    if (dice.one_in(2)) o.x = dice.one_in(2) ? glm::vec3(0) : dice.in_cube();
    if (dice.one_in(2))
      o.y = finite(glm::dvec3(o.x) + dice.uniform(-1, 1) * glm::dvec3(o.a) -
                   double(dice.between(-2, 2)) * glm::dvec3(o.b));
    return o;
  });
}

Exact real_determinant(const DeterminantOperands& o) {
  Exact sum = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const Exact cross = Exact(o.b[j]) * Exact(o.a[k]) - Exact(o.b[k]) * Exact(o.a[j]);
    sum += (Exact(o.y[i]) - Exact(o.x[i])) * cross;
  }
  return sum;
}

RC_GTEST_PROP(ExactDeterminant, HasTheSignOfTheRealNumberAndAFewRoundings, ()) {
  const DeterminantOperands o = *determinant_operands();
  const Exact exact = real_determinant(o);
  const double value = exact_determinant(o.a, o.x, o.y, o.b);
  RC_ASSERT(precise::same_sign(value, exact));
  // The terms do not overlap: what their last sum loses is less than 2 ulps.
  RC_ASSERT(abs(Exact(value) - exact) <= abs(exact) * 0x1p-51);
}

RC_GTEST_PROP(DeterminantBetween, HasTheSignOfTheRealNumberAndTheStatedError, ()) {
  const DeterminantOperands o = *determinant_operands();
  const Exact exact = real_determinant(o);
  const double value = determinant_between(o.a, o.x, o.y, o.b);
  RC_ASSERT(precise::same_sign(value, exact));
  RC_ASSERT(abs(Exact(value) - exact) <= abs(exact) * determinant_error);
}

TEST(DeterminantBetween, IsThatOfItsColumns) {
  EXPECT_EQ(determinant_between({1, 0, 0}, {1, 1, 1}, {1, 3, 1}, {0, 0, 4}), 8);
  EXPECT_EQ(determinant_between({0, 0, 4}, {1, 1, 1}, {1, 3, 1}, {1, 0, 0}), -8);
}

TEST(DeterminantBetween, SeesTheLastBitOfACancellation) {
  EXPECT_EQ(determinant_between({1, 1, 0}, {0x1p-149F, 0, 0}, {0x1p100F, 0x1p100F, 0}, {0, 0, 1}),
            0x1p-149);
  EXPECT_EQ(determinant_between({0, 1, 0}, {0, 0, 0}, {1, 0, 1}, {1, 0, 1}), 0);
}

} // namespace
} // namespace lightcuts
