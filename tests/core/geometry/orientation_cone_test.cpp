// SPDX-License-Identifier: MIT
#include <lightcuts/core/geometry/orientation_cone.h>

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <tests/support/generators.h>
#include <tests/support/precise.h>

namespace lightcuts {
namespace {

using precise::Quad;

/// 2 - 2 cos between two directions.
Quad chord2_between(const glm::vec3& u, const glm::vec3& v) {
  const Quad lengths = precise::length(u) * precise::length(v);
  return 2 - 2 * Quad(precise::dot(u, glm::vec3(0), v)) / lengths;
}

bool contains(const OrientationCone& cone, const glm::vec3& direction) {
  // Quad rounds by 2^-127 a few times.
  return chord2_between(cone.axis, direction) <= Quad(cone.chord2) + Quad(0x1p-120);
}

OrientationCone cone_around(const glm::vec3& axis) { return {axis, 0}; }

/// Axes in a clump, on a great circle, opposite, or anywhere; and what their cones merge to, in a
/// chain or by pairs.
RC_GTEST_PROP(OrientationCone, KeepsEveryAxisItWasMergedFrom, ()) {
  const auto axes =
      *rc::gen::container<std::vector<glm::vec3>>(*rc::gen::inRange(1, 40), gen::unit_vector());
  OrientationCone chain = cone_around(axes[0]);
  std::vector<OrientationCone> pairs;
  for (const glm::vec3& axis : axes) {
    chain = merged(chain, cone_around(axis));
    pairs.push_back(cone_around(axis));
  }
  while (pairs.size() > 1) {
    pairs.front() = merged(pairs.front(), pairs.back());
    pairs.pop_back();
    if (pairs.size() > 2) std::swap(pairs[0], pairs[pairs.size() / 2]);
  }
  for (const glm::vec3& axis : axes) {
    RC_ASSERT(contains(chain, axis));
    RC_ASSERT(contains(pairs.front(), axis));
  }
}

RC_GTEST_PROP(OrientationCone, KeepsEveryAxisOfAClump, ()) {
  const glm::dvec3 centre(*gen::unit_vector());
  const double size = std::pow(10.0, -*rc::gen::inRange(0, 12));
  std::vector<glm::vec3> axes;
  OrientationCone cone;
  for (int i = 0; i < 10; ++i) {
    axes.emplace_back(glm::normalize(centre + size * glm::dvec3(*gen::unit_vector()) * 0.9));
    cone = i == 0 ? cone_around(axes[0]) : merged(cone, cone_around(axes.back()));
  }
  for (const glm::vec3& axis : axes) RC_ASSERT(contains(cone, axis));
  // Ten merges of a clump this size: not wider than a few times it, and what floats round by.
  RC_ASSERT(cone.chord2 <= std::pow(6 * size + 1e-6, 2));
}

/// Half-angles in degrees.
double degrees(const OrientationCone& cone) {
  return 2 * std::asin(std::min(1.0, std::sqrt(double(cone.chord2)) / 2)) * 180 / std::numbers::pi;
}

TEST(OrientationCone, OfTwoAxesIsHalfTheAngleBetweenThem) {
  const OrientationCone right = merged(cone_around({1, 0, 0}), cone_around({0, 1, 0}));
  EXPECT_NEAR(degrees(right), 45, 1e-5);
  EXPECT_NEAR(right.axis.x, std::sqrt(0.5), 1e-6);
  const OrientationCone three = merged(right, cone_around({-1, 0, 0}));
  EXPECT_NEAR(degrees(three), 90, 1e-4);
  EXPECT_NEAR(three.axis.y, 1, 1e-6);
}

TEST(OrientationCone, OfOppositeAxesIsAHalfSpaceAroundAPerpendicular) {
  for (const glm::vec3& axis :
       {glm::vec3(1, 0, 0), glm::vec3(0, -1, 0), glm::vec3(0.6F, 0, 0.8F)}) {
    const OrientationCone cone = merged(cone_around(axis), cone_around(-axis));
    EXPECT_NEAR(degrees(cone), 90, 1e-4);
    EXPECT_NEAR(glm::dot(cone.axis, axis), 0, 1e-6);
    EXPECT_TRUE(contains(cone, axis) && contains(cone, -axis));
  }
}

TEST(OrientationCone, FillsAllDirectionsAndThenStaysSo) {
  OrientationCone cone = cone_around({1, 0, 0});
  for (const glm::vec3& axis : {glm::vec3(-1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, -1, 0),
                                glm::vec3(0, 0, 1), glm::vec3(0, 0, -1)})
    cone = merged(cone, cone_around(axis));
  EXPECT_EQ(cone.chord2, 4);
  EXPECT_EQ(merged(cone, cone_around({0, 1, 0})).chord2, 4);
  EXPECT_EQ(cone.half_angle().cos, -1);
}

TEST(OrientationCone, OfEqualAxesIsTheWiderOfTheTwo) {
  const OrientationCone wide{{0, 0, 1}, 0.25F};
  EXPECT_EQ(merged(wide, cone_around({0, 0, 1})).chord2, 0.25F);
  EXPECT_EQ(merged(cone_around({0, 0, 1}), cone_around({0, 0, 1})).chord2, 0);
}

TEST(OrientationCone, ThatHoldsTheOtherIsTheResult) {
  const OrientationCone wide{{0, 0, 1}, 1};
  const OrientationCone merged_cone = merged({{0.1F, 0, 0.995F}, 0.01F}, wide);
  EXPECT_EQ(merged_cone.chord2, 1);
  EXPECT_EQ(merged_cone.axis, wide.axis);
}

} // namespace
} // namespace lightcuts
