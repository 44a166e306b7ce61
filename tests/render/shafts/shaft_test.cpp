// SPDX-License-Identifier: MIT
#include <lightcuts/render/shafts/shaft.h>

#include <gtest/gtest.h>
#include <oracle/numbers/dice.h>

namespace lightcuts {
namespace {

Box around(const glm::vec3& a, const glm::vec3& b) {
  Box box = Box::empty();
  box.extend(a);
  box.extend(b);
  return box;
}

glm::vec3 within(gen::Dice& dice, const Box& box) {
  return box.lo + (box.hi - box.lo) * (0.5F + 0.5F * dice.in_cube());
}

TEST(Shaft, IsNoWiderThanItsSides) {
  const Shaft shaft({{0, 0, 0}, {1, 1, 1}}, {{10, 10, 0}, {11, 11, 1}});
  const Box aside{{7, 2, 0}, {8, 3, 1}};
  // The side goes through (1, 0) and (11, 10); the corner that is next to it is (7, 3).
  EXPECT_NEAR(shaft.separation(aside), 3 / std::sqrt(2.0), 1e-12);
  EXPECT_LE(shaft.separation(Box{{5, 5, 0}, {6, 6, 1}}), 0);
  EXPECT_NEAR(shaft.separation(Box{{5, 5, 3}, {6, 6, 4}}), 2, 1e-12);
}

TEST(Shaft, IsNotApartFromAnySegmentInIt) {
  gen::Dice dice(4);
  int apart = 0;
  for (int i = 0; i < 2000; ++i) {
    const Box from = around(dice.in_cube(), dice.in_cube());
    const glm::vec3 off = 3.0F * dice.in_cube();
    const Box to = around(off + dice.in_cube() * 0.5F, off + dice.in_cube() * 0.5F);
    const Shaft shaft(from, to);
    const Box box = around(2.0F * dice.in_cube(), 2.0F * dice.in_cube());
    const double separation = shaft.separation(box);
    apart += separation > 0 ? 1 : 0;
    for (int k = 0; k < 20; ++k) {
      const glm::dvec3 a(within(dice, from)), b(within(dice, to)), p(within(dice, box));
      const glm::dvec3 on = a + dice.uniform(0, 1) * (b - a);
      EXPECT_GE(glm::distance(on, p), separation - 1e-6);
    }
  }
  EXPECT_GT(apart, 300);
}

} // namespace
} // namespace lightcuts
