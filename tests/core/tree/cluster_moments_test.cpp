// SPDX-License-Identifier: MIT
#include <lightcuts/core/tree/cluster_moments.h>

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <lightcuts/core/tree/tree_builder.h>
#include <tests/support/generators.h>

namespace lightcuts {
namespace {

LightSet lights_at(const std::vector<glm::vec3>& positions) {
  LightSet lights;
  for (const glm::vec3& p : positions) lights.add_omni(p, glm::vec3(1));
  return lights;
}

TEST(ClusterMoments, OfTwoLightsAreTheirWeightedMeanAndSpread) {
  LightSet lights;
  lights.add_omni({0, 0, 0}, glm::vec3(1));
  lights.add_omni({4, 0, 8}, glm::vec3(3));
  const ClusterMoments m = build(lights).moments(0);
  EXPECT_EQ(m.centroid, glm::vec3(3, 0, 6));
  EXPECT_EQ(m.variance, glm::vec3(3, 0, 12)); // share 1/4 times 3/4 of the squares 16 and 64
  EXPECT_EQ(m.covariance, glm::vec3(0, 6, 0));
}

TEST(ClusterMoments, OfManyLightsEqualThePlainSums) {
  std::vector<glm::vec3> positions;
  for (int i = 0; i < 60; ++i)
    positions.emplace_back(float(i % 7), float(i * i % 11), float(i * 3 % 5));
  const ClusterMoments m = build(lights_at(positions)).moments(0);
  glm::dvec3 mean(0), square(0);
  double yz = 0;
  for (const glm::dvec3 p : positions) {
    mean += p / 60.0;
    square += p * p / 60.0;
    yz += p.y * p.z / 60.0;
  }
  // 60 additions in double, then one rounding to float, of numbers below 100.
  constexpr double rounding = 100 * (60 * 0x1p-52 + 0x1p-24);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(m.centroid[i], mean[i], rounding);
    EXPECT_NEAR(m.variance[i], square[i] - mean[i] * mean[i], rounding);
  }
  EXPECT_NEAR(m.covariance.x, yz - mean.y * mean.z, rounding);
}

RC_GTEST_PROP(ClusterMoments, LieInTheBoxAndAreFinite, ()) {
  const gen::Scene scene = *gen::scene();
  const LightTree tree = build(scene.light_set());
  for (std::uint32_t i = 0; i < tree.nodes().size(); ++i) {
    const ClusterMoments& m = tree.moments(i);
    if (tree.node(i).is_mixed()) continue;
    RC_ASSERT(tree.node(i).box.contains(m.centroid));
    for (int k = 0; k < 3; ++k) {
      RC_ASSERT(std::isfinite(m.variance[k]) && m.variance[k] >= 0);
      RC_ASSERT(std::isfinite(m.covariance[k]));
      if (tree.node(i).is_leaf()) RC_ASSERT(m.variance[k] == 0 && m.covariance[k] == 0);
    }
  }
}

} // namespace
} // namespace lightcuts
