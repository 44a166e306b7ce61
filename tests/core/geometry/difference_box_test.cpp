// SPDX-License-Identifier: MIT
#include <lightcuts/core/geometry/difference_box.h>

#include <gtest/gtest.h>
#include <oracle/numbers/dice.h>

#include <tests/support/precise.h>

namespace lightcuts {
namespace {

using precise::Exact;

// Every difference of two floats, in real numbers, lies between the ends, which are its neighbours
// among doubles at most.
TEST(DifferenceBox, BetweenBoxesIsRoundedOutwards) {
  gen::Dice dice(7);
  int inexact = 0;
  for (int n = 0; n < 20000; ++n) {
    Box x, y;
    for (int i = 0; i < 3; ++i) {
      x.lo[i] = x.hi[i] = dice.log_uniform(-30, 30);
      y.lo[i] = y.hi[i] = dice.log_uniform(-30, 30);
    }
    const DifferenceBox q = DifferenceBox::between(x, y);
    for (int i = 0; i < 3; ++i) {
      const Exact real = Exact(y.lo[i]) - Exact(x.lo[i]);
      ASSERT_LE(Exact(q.lo[i]), real);
      ASSERT_GE(Exact(q.hi[i]), real);
      if (q.lo[i] == q.hi[i]) continue;
      ++inexact;
      ASSERT_EQ(std::nextafter(q.lo[i], q.hi[i]), q.hi[i]);
    }
  }
  EXPECT_GT(inexact, 1000);
}

TEST(DifferenceBox, DotProductsAtCornersAreExactWhereTheyCancel) {
  const glm::vec3 n(1, 1, -1), x(0x1p-40F, 1, 1);
  const Box y{glm::vec3(1), glm::vec3(1)};
  // (1 - 2^-40) + 0 - 0 ; and where two differences cancel:
  EXPECT_EQ(DifferenceBox(x, y).dot_at(0, n), 1 - 0x1p-40);
  const glm::vec3 z(0, 0x1p-60F, 0);
  const Box w{{1, 0, 1}, {1, 0, 1}};
  EXPECT_EQ(DifferenceBox(z, w).dot_at(0, n), -0x1p-60);
}

} // namespace
} // namespace lightcuts
