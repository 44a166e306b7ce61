// SPDX-License-Identifier: MIT
#include <lightcuts/core/geometry/box_bounds.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <tests/support/box_reference.h>
#include <tests/support/float_limits.h>
#include <tests/support/generators.h>

namespace lightcuts {
namespace {

using gen::BoxView;
using precise::Exact;
using precise::Point;

double least_cosine_over_distance2(const BoxView& v) {
  return min_cosine_times(v.n, v.x, v.box, [](double length2) { return 1 / length2; });
}

/// A grid over the box with its corners, edges and faces.
std::vector<Point> grid(const precise::ExactBox& box) {
  constexpr int steps = 4;
  std::vector<Point> list;
  for (int i = 0; i < (steps + 1) * (steps + 1) * (steps + 1); ++i) {
    const std::array<int, 3> at{i % (steps + 1), i / (steps + 1) % (steps + 1),
                                i / (steps + 1) / (steps + 1)};
    Point q;
    for (int k = 0; k < 3; ++k) {
      const Exact t = Exact(at[k]) / steps;
      q[k] = box.lo[k] * (1 - t) + box.hi[k] * t;
    }
    list.push_back(q);
  }
  return list;
}

/// Points clamp(s n, lo, hi): at every s where a coordinate starts or stops moving, and beside it.
std::vector<Point> path(const Point& n, const precise::ExactBox& box) {
  std::vector<Point> list;
  for (int i = 0; i < 3; ++i)
    for (const Exact& face : {box.lo[i], box.hi[i]})
      for (const double beside : {0.5, 0.99, 1.0, 1.01, 2.0}) {
        if (n[i] == 0 || face / n[i] <= 0) continue;
        const Exact s = face / n[i] * beside;
        Point q;
        for (int k = 0; k < 3; ++k)
          q[k] = std::min(std::max(Exact(s * n[k]), box.lo[k]), box.hi[k]);
        list.push_back(q);
      }
  return list;
}

template <int K>
void expect_no_sample_above(double bound, const BoxView& v) {
  const precise::ExactBox box(v.x, v.box);
  const Point n = precise::exact_vector(v.n);
  std::vector<Point> samples = grid(box);
  for (const Point& q : path(n, box)) samples.push_back(q);
  RC_ASSERT(!std::isnan(bound));
  if (bound == inf) return;
  for (const Point& q : samples)
    RC_ASSERT(Exact(bound) >= precise::objective<K>(n, q) * (1 - box_bound_error));
}

RC_GTEST_PROP(MaxCosine, IsNotBelowAnySampleOfTheBox, ()) {
  const BoxView v = *gen::box_view();
  expect_no_sample_above<1>(max_cosine(v.n, v.x, v.box), v);
}

RC_GTEST_PROP(MaxCosineOverDistance2, IsNotBelowAnySampleOfTheBox, ()) {
  const BoxView v = *gen::box_view();
  expect_no_sample_above<3>(max_cosine_over_distance2(v.n, v.x, v.box), v);
}

RC_GTEST_PROP(MaxCosine, EqualsTheLargestOfRayCornersAndEdges, ()) {
  const BoxView v = *gen::box_view();
  const Exact exact = precise::max_cosine(v.n, v.x, v.box);
  const double value = max_cosine(v.n, v.x, v.box);
  RC_ASSERT(std::isfinite(value));
  RC_ASSERT(abs(Exact(value) - exact) <= exact * box_bound_error);
}

RC_GTEST_PROP(MaxCosineOverDistance2, EqualsTheLargestOfCornersEdgesAndFaces, ()) {
  const BoxView v = *gen::box_view();
  const auto exact = precise::max_cosine_over_distance2(v.n, v.x, v.box);
  const double value = max_cosine_over_distance2(v.n, v.x, v.box);
  RC_ASSERT((value == inf) == !exact.has_value());
  if (exact) RC_ASSERT(abs(Exact(value) - *exact) <= *exact * box_bound_error);
}

RC_GTEST_PROP(BoxBounds, AreZeroExactlyWhereTheWholeBoxIsBehind, ()) {
  const BoxView v = *gen::box_view();
  const bool front = precise::reaches_front(v.n, v.x, v.box);
  RC_ASSERT((max_cosine(v.n, v.x, v.box) == 0) == !front);
  RC_ASSERT((max_cosine_over_distance2(v.n, v.x, v.box) == 0) == !front);
}

RC_GTEST_PROP(BoxBounds, AreThoseOfTheOnlyPointWhenTheBoxIsOne, ()) {
  BoxView v = *gen::box_view();
  v.box.hi = v.box.lo;
  const Point q = precise::ExactBox(v.x, v.box).lo;
  const Point n = precise::exact_vector(v.n);
  const Exact cosine = precise::objective<1>(n, q);
  const Exact joint = precise::objective<3>(n, q);
  RC_ASSERT(abs(Exact(max_cosine(v.n, v.x, v.box)) - cosine) <= cosine * box_bound_error);
  RC_ASSERT(abs(Exact(max_cosine_over_distance2(v.n, v.x, v.box)) - joint) <=
            joint * box_bound_error);
}

RC_GTEST_PROP(BoxBounds, NeverFallAsTheBoxGrows, ()) {
  BoxView v = *gen::box_view();
  const double cosine = max_cosine(v.n, v.x, v.box);
  const double joint = max_cosine_over_distance2(v.n, v.x, v.box);
  v.box.extend((*gen::box_view()).box);
  // Both values may err by box_bound_error, in opposite directions.
  RC_ASSERT(max_cosine(v.n, v.x, v.box) >= cosine * (1 - 2 * box_bound_error));
  RC_ASSERT(max_cosine_over_distance2(v.n, v.x, v.box) >= joint * (1 - 2 * box_bound_error));
}

RC_GTEST_PROP(MinDistance2, IsExactButForRounding, ()) {
  const BoxView v = *gen::box_view();
  const Exact exact = precise::min_distance2(v.x, v.box);
  const double value = min_distance2(v.x, v.box);
  RC_ASSERT((value == 0) == v.box.contains(v.x));
  // Stated with the function: 5 roundings.
  RC_ASSERT(abs(Exact(value) - exact) <= exact * 0x1p-50);
}

TEST(MaxCosine, IsTheLengthOfTheNormalWhereItsRayMeetsTheBox) {
  const Box box{{-1, -1, 1}, {1, 1, 2}};
  EXPECT_EQ(max_cosine({0, 0, 1}, {0, 0, 0}, box), 1);
  EXPECT_EQ(max_cosine({0, 0, 3}, {0, 0, 0}, box), 3);
  EXPECT_EQ(max_cosine({0, 0, -1}, {0, 0, 0}, box), 0);
}

TEST(MaxCosine, LooksInsideAnEdgeToo) {
  // At (1, 0, 1), inside the nearest edge, 45 degrees; the corners are at 60.
  EXPECT_DOUBLE_EQ(max_cosine({0, 0, 1}, {0, 0, 0}, {{1, -1, 0}, {2, 1, 1}}), std::sqrt(0.5));
}

TEST(MaxCosine, IsNotThatOfTheRayWhereRoundingHidesThatItMissesTheBox) {
  const Box box{{0, -0x1p-59F, 0}, {0x1.8p-47F, 0, 0}};
  // The nearest direction is that of x: 0.875; the length of n is 1.008.
  EXPECT_NEAR(max_cosine({-0.875F, -0.5F, 0}, {1, 0, 0}, box), 0.875, 0.875 * box_bound_error);
}

TEST(MaxCosineOverDistance2, IsInfiniteOnlyWhereALightInFrontMayTouchThePoint) {
  const Box box{{0, 0, 0}, {1, 1, 1}};
  EXPECT_EQ(max_cosine_over_distance2({0, 0, 1}, {0, 0, 0}, box), inf);
  EXPECT_EQ(max_cosine_over_distance2({0, 0, -1}, {0, 0, 0}, box), 0);
  EXPECT_EQ(max_cosine_over_distance2({0, 0, 1}, {0.5F, 0.5F, 1}, box), 0);
}

TEST(MaxCosineOverDistance2, IsFiniteForAFarLightBarelyAboveTheHorizon) {
  const glm::vec3 light(0, 0x1p-149F, 3e38F);
  const double value = max_cosine_over_distance2({1, 0x1p-149F, 0}, glm::vec3(0), {light, light});
  EXPECT_GT(value, 0);
  EXPECT_LT(value, 1e-200);
}

RC_GTEST_PROP(MinCosineOverDistance2, IsBelowEverySampleOfTheBoxAndEqualsOne, ()) {
  const BoxView v = *gen::box_view();
  const double least = least_cosine_over_distance2(v);
  RC_ASSERT(least >= 0);
  bool reached = false;
  bool behind = false;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 y((corner & 1) != 0 ? v.box.hi.x : v.box.lo.x,
                      (corner & 2) != 0 ? v.box.hi.y : v.box.lo.y,
                      (corner & 4) != 0 ? v.box.hi.z : v.box.lo.z);
    const Exact n_dot_q = precise::dot(v.n, v.x, y);
    behind = behind || n_dot_q <= 0;
    if (n_dot_q <= 0) continue;
    const Exact length2 = precise::distance2(v.x, y);
    const Exact value = n_dot_q / (length2 * sqrt(length2));
    RC_ASSERT(Exact(least) <= value * (1 + Exact(box_bound_error)));
    reached = reached || Exact(least) >= value * (1 - Exact(box_bound_error));
  }
  const bool right = behind ? least == 0 : reached;
  RC_ASSERT(right);
}

// Corners are enough: what is said of them holds for the points between.
RC_GTEST_PROP(MinCosineOverDistance2, IsBelowThePointsInside, ()) {
  const BoxView v = *gen::box_view();
  const double least = least_cosine_over_distance2(v);
  const Point n{Exact(v.n.x), Exact(v.n.y), Exact(v.n.z)};
  for (const Point& q : grid(precise::ExactBox(v.x, v.box))) {
    const Exact n_dot_q = n[0] * q[0] + n[1] * q[1] + n[2] * q[2];
    const Exact length2 = q[0] * q[0] + q[1] * q[1] + q[2] * q[2];
    if (n_dot_q <= 0) RC_ASSERT(least == 0);
    if (n_dot_q > 0)
      RC_ASSERT(Exact(least) * (1 - Exact(box_bound_error)) * length2 * sqrt(length2) <= n_dot_q);
  }
}

} // namespace
} // namespace lightcuts
