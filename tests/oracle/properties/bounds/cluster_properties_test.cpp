// SPDX-License-Identifier: MIT
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <lightcuts/core/methods/paper.h>
#include <tests/oracle/support/judged_point.h>
#include <tests/support/float_limits.h>
#include <tests/support/generators.h>

namespace lightcuts::oracle {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr auto contribution_property = Property::bound_dominates_contribution;
constexpr auto error_property = Property::bound_dominates_error;
constexpr auto ordered = Property::bounds_are_ordered;
constexpr auto shrinks = Property::bound_shrinks_on_refinement;
constexpr auto finite = Property::results_are_finite;
constexpr auto bound_finite = Property::bound_is_finite;

/// What is found wrong with bounds bent so, of the four lights, all seen.
std::vector<Property> violated_by(const BentTree::Bend& bend) {
  const JudgedPoint judged(four_lights(), diffuse_point(), {1, 1, 1, 1});
  return violated(judged_clusters(BentTree(judged.tree, bend), judged));
}

glm::vec3 rounded_up(const Wide& value) {
  glm::vec3 bound;
  for (int c = 0; c < 3; ++c) {
    bound[c] = static_cast<float>(value[c]);
    if (bound[c] < value[c]) bound[c] = std::nextafter(bound[c], inf);
  }
  return bound;
}

RC_GTEST_PROP(ClusterProperties, HoldForTheLibrary, ()) {
  const gen::Scene scene = *gen::scene();
  const auto mask = *rc::gen::arbitrary<std::uint32_t>();
  std::vector<char> visible;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) visible.push_back((mask >> i) & 1U);
  const JudgedPoint judged(build(scene.light_set()), scene.view.point(), visible);
  const Tally tally = judged_clusters(judged.library(), judged);
  for (const Property p : all_properties) RC_ASSERT(tally[p].first_violation == "");
  const std::size_t nodes = judged.tree.nodes().size();
  RC_ASSERT(tally[contribution_property].cases == nodes);
  RC_ASSERT(tally[error_property].cases == nodes);
  RC_ASSERT(tally[finite].cases == 2 * nodes);
  RC_ASSERT(tally[bound_finite].cases == nodes);
  RC_ASSERT(tally[shrinks].cases == nodes - scene.lights.size());
}

TEST(ClusterProperties, HoldForUnbentBounds) {
  EXPECT_THAT(violated_by([](std::uint32_t, glm::vec3 bound) { return bound; }), IsEmpty());
}

// The bound is the smallest float that dominates the truth, then the largest that does not.
TEST(ClusterProperties, ConvictABoundThatIsOneUlpTooLow) {
  const JudgedPoint judged(four_lights(), diffuse_point({0.25F, 0, 0}), {1, 1, 1, 1});
  const BentTree tight(judged.tree, [&](std::uint32_t node, glm::vec3) {
    return rounded_up(judged.truth.open(node));
  });
  EXPECT_EQ(judged_clusters(BentTree(tight), judged)[contribution_property].violations, 0U);
  for (int channel = 0; channel < 3; ++channel) {
    BentTree low(judged.tree, [&](std::uint32_t node, glm::vec3) {
      glm::vec3 bound = rounded_up(judged.truth.open(node));
      if (node == 2) bound[channel] = std::nextafter(bound[channel], 0.0F);
      return bound;
    });
    const Tally tally = judged_clusters(std::move(low), judged);
    EXPECT_EQ(tally[contribution_property].violations, 1U);
    EXPECT_THAT(tally[contribution_property].first_violation,
                testing::AllOf(testing::HasSubstr("node 2"),
                               testing::HasSubstr("point (0.25, 0, 0)"),
                               testing::HasSubstr(std::string("channel ") + "rgb"[channel])));
  }
}

/// Estimates by the representative instead of the centroid.
class ByRepresentative : public BentTree {
public:
  using BentTree::BentTree;
  glm::dvec3 estimate(std::uint32_t node, const ShadingPoint& point,
                      const glm::vec3& bound) override {
    return cluster_estimate(this->tree(), node, point, bound, EstimateRule::representative);
  }
};

// 10 times the near light's transfer, of which only the near light itself is there.
TEST(ClusterProperties, ConvictABoundOfTheTruthButNotOfTheError) {
  LightSet lights;
  lights.add_omni({0, 0, 1}, glm::vec3(1));
  lights.add_omni({0, 0, 100}, glm::vec3(9));
  const LightTree built = build(lights);
  std::vector<TreeNode> nodes(built.nodes().begin(), built.nodes().end());
  nodes[0].representative = 0;
  const JudgedPoint judged(LightTree(lights, nodes), diffuse_point(), {1, 0});
  const ByRepresentative tight(judged.tree, [&](std::uint32_t node, glm::vec3) {
    return rounded_up(judged.truth.open(node));
  });
  EXPECT_THAT(violated(judged_clusters(ByRepresentative(tight), judged)),
              ElementsAre(error_property));
  EXPECT_NEAR(judged_clusters(ByRepresentative(tight), judged)[error_property].worst_ratio, 9, 0.1);
}

TEST(ClusterProperties, ConvictChildrenWithLargerBounds) {
  EXPECT_THAT(violated_by([](std::uint32_t node, glm::vec3 bound) {
                return node == 0 ? bound : 1000.0F * bound;
              }),
              ElementsAre(shrinks));
}

// Twice the excess that rounding of bounds accounts for.
TEST(ClusterProperties, ConvictChildrenWithSlightlyLargerBounds) {
  const JudgedPoint judged(four_lights(), diffuse_point(), {1, 1, 1, 1});
  LibraryTree library = judged.library();
  const std::uint32_t a = judged.tree.node(0).first_child;
  const glm::vec3 children = library.bound(a, judged.point) + library.bound(a + 1, judged.point);
  const auto with_root = [&](float factor) {
    BentTree subject(judged.tree, [&](std::uint32_t node, glm::vec3 bound) {
      return node == 0 ? factor * children : bound;
    });
    return judged_clusters(std::move(subject), judged)[shrinks].violations;
  };
  EXPECT_EQ(with_root(1), 0U);
  EXPECT_EQ(with_root(1 - 0x1p-20F), 1U);
}

TEST(ClusterProperties, ConvictABoundThatIsNotANumber) {
  EXPECT_THAT(violated_by([](std::uint32_t node, glm::vec3 bound) {
                if (node == 0) bound.y = std::nanf("");
                return bound;
              }),
              ElementsAre(contribution_property, error_property, ordered, shrinks, finite));
}

TEST(ClusterProperties, ConvictABoundBelowTheLowerOne) {
  EXPECT_THAT(violated_by([](std::uint32_t node, glm::vec3 bound) {
                return node == 0 ? 0.01F * bound : bound;
              }),
              Contains(ordered));
}

TEST(ClusterProperties, ConvictANegativeBound) {
  EXPECT_THAT(violated_by([](std::uint32_t, glm::vec3 bound) { return -bound; }), Contains(finite));
}

TEST(ClusterProperties, ConvictAnInfiniteBoundOutsideTheBox) {
  EXPECT_THAT(violated_by([](std::uint32_t node, glm::vec3 bound) {
                return node == 0 ? glm::vec3(inf) : bound;
              }),
              ElementsAre(bound_finite));
}

TEST(ClusterProperties, ConvictAnInfiniteBoundOfALightAtADistance) {
  LightSet lights;
  lights.add_omni({0, 0, 1}, glm::vec3(1e30F));
  const JudgedPoint judged(build(lights), diffuse_point(), {1});
  BentTree infinite(judged.tree, [](std::uint32_t, glm::vec3) { return glm::vec3(inf); });
  EXPECT_THAT(violated(judged_clusters(std::move(infinite), judged)), ElementsAre(bound_finite));
}

TEST(ClusterProperties, AllowAnInfiniteBoundWithinTheBox) {
  const JudgedPoint judged(four_lights(), diffuse_point({0.5F, 0.5F, 1.5F}), {1, 1, 1, 1});
  LibraryTree library = judged.library();
  EXPECT_EQ(library.bound(0, judged.point), glm::vec3(inf));
  EXPECT_THAT(violated(judged_clusters(std::move(library), judged)), IsEmpty());
}

TEST(ClusterProperties, AllowAnInfiniteBoundOfWhatExceedsTheLargestFloat) {
  LightSet lights;
  lights.add_omni({0, 0, 0x1p-20F}, glm::vec3(1e30F));
  const JudgedPoint judged(build(lights), diffuse_point(), {1});
  LibraryTree library = judged.library();
  EXPECT_EQ(library.bound(0, judged.point), glm::vec3(inf));
  EXPECT_THAT(violated(judged_clusters(std::move(library), judged)), IsEmpty());
}

TEST(ClusterProperties, ConvictABoxThatMissesALight) {
  const LightTree tree = four_lights();
  std::vector<TreeNode> nodes(tree.nodes().begin(), tree.nodes().end());
  nodes[0].box.lo = nodes[0].box.hi; // all at the farthest light
  const JudgedPoint judged(LightTree(tree.lights(), nodes), diffuse_point(), {1, 1, 1, 1});
  EXPECT_THAT(violated(judged_clusters(judged.library(), judged)), Contains(contribution_property));
}

TEST(ClusterProperties, ConvictABoundOfTheRepresentativesIntensity) {
  const JudgedPoint judged(four_lights(), diffuse_point(), {1, 1, 1, 1});
  EXPECT_THAT(violated(judged_clusters(BentTree(judged.tree,
                                                [&](std::uint32_t node, const glm::vec3& bound) {
                                                  const TreeNode& n = judged.tree.node(node);
                                                  const Light& light =
                                                      judged.tree.lights()[n.representative];
                                                  return bound *
                                                         (light.intensity.x / float(n.intensity.x));
                                                }),
                                       judged)),
              Contains(contribution_property));
}

} // namespace
} // namespace lightcuts::oracle
