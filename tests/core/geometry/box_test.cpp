// SPDX-License-Identifier: MIT
#include <lightcuts/core/geometry/box.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <tests/support/generators.h>
#include <tests/support/precise.h>

namespace lightcuts {
namespace {

using precise::Exact;

Box make_box() { return (*gen::box_view()).box; }

TEST(Box, EmptyContainsNothing) { EXPECT_FALSE(Box::empty().contains(glm::vec3(0))); }

TEST(Box, EmptyExtendedByAPointIsThatPoint) {
  Box box = Box::empty();
  box.extend(glm::vec3(1, 2, 3));
  EXPECT_EQ(box, (Box{{1, 2, 3}, {1, 2, 3}}));
}

TEST(Box, ContainsItsFacesAndNothingBeyond) {
  const Box box{{0, 0, 0}, {1, 1, 1}};
  EXPECT_TRUE(box.contains(glm::vec3(1, 0, 0.5F)));
  EXPECT_FALSE(box.contains(glm::vec3(0x1.000002p0F, 0, 0)));
  EXPECT_FALSE(box.contains(glm::vec3(0, -0x1p-149F, 0)));
}

RC_GTEST_PROP(Box, UnionContainsBothAndTouchesOneInEachDirection, ()) {
  const Box a = make_box();
  const Box b = make_box();
  Box both = a;
  both.extend(b);
  RC_ASSERT(both.contains(a) && both.contains(b));
  for (int i = 0; i < 3; ++i) {
    RC_ASSERT(both.lo[i] == a.lo[i] || both.lo[i] == b.lo[i]);
    RC_ASSERT(both.hi[i] == a.hi[i] || both.hi[i] == b.hi[i]);
  }
}

RC_GTEST_PROP(SquaredDiagonalOfUnion, NeverFallsAsABoxGrows, ()) {
  const Box a = make_box();
  const Box b = make_box();
  Box larger = a;
  larger.extend(make_box());
  RC_ASSERT(squared_diagonal_of_union(a, b) <= squared_diagonal_of_union(larger, b));
  RC_ASSERT(squared_diagonal_of_union(b, a) <= squared_diagonal_of_union(b, larger));
}

RC_GTEST_PROP(SquaredDiagonalOfUnion, IsThatOfTheUnionInRealNumbers, ()) {
  const Box a = make_box();
  const Box b = make_box();
  Box both = a;
  both.extend(b);
  const Exact exact = precise::distance2(both.lo, both.hi);
  // Per axis a difference (twice, for the square), a product; two sums: 5 roundings.
  RC_ASSERT(abs(Exact(squared_diagonal_of_union(a, b)) - exact) <= exact * 0x1p-50);
}

} // namespace
} // namespace lightcuts
