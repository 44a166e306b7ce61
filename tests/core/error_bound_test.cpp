// SPDX-License-Identifier: MIT
#include <lightcuts/error_bound.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "../support/box_reference.h"
#include "../support/dice.h"
#include "../support/generators.h"
#include "../support/precise.h"
#include <lightcuts/tree_builder.h>

namespace lightcuts {
namespace {

using precise::Colour;
using precise::Exact;
using precise::Quad;

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float largest = std::numeric_limits<float>::max();
constexpr double least = 0x1p-149; ///< smallest subnormal float

/// The expression that contribution_bound() stands for, in real numbers; nothing if infinite.
std::array<std::optional<Quad>, 3> real_bound(const TreeNode& node, const ShadingPoint& point) {
  const glm::vec3& x = point.position();
  const auto joint = precise::max_cosine_over_distance2(point.normal(), x, node.box);
  const Quad cosine =
      Quad(precise::max_cosine(point.mirror(), x, node.box)) / precise::length(point.mirror());
  const Colour f = precise::brdf(point.material(), cosine);
  std::array<std::optional<Quad>, 3> bound;
  for (int c = 0; c < 3; ++c) {
    const Quad factor = f[c] * Quad(node.intensity[c]);
    if (factor == 0)
      bound[c] = Quad(0);
    else if (joint)
      bound[c] = Quad(factor * Quad(*joint) / precise::length(point.normal()));
  }
  return bound;
}

RC_GTEST_PROP(ContributionBound, DominatesTheTrueContribution, ()) {
  const gen::Scene scene = *gen::scene();
  const LightTree tree = build(scene.light_set());
  const ShadingPoint point = scene.view.point();
  const std::vector<Colour> truth = precise::contributions(tree, point);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const glm::vec3 bound = contribution_bound(tree.nodes()[i], point);
    for (int c = 0; c < 3; ++c) {
      RC_ASSERT(!std::isnan(bound[c]));
      RC_ASSERT(bound[c] == inf || Quad(bound[c]) >= truth[i][c]);
    }
  }
}

RC_GTEST_PROP(ContributionBound, DominatesTheEstimateMadeAtAnyLightOfTheCluster, ()) {
  const gen::Scene scene = *gen::scene();
  const LightTree tree = build(scene.light_set());
  const ShadingPoint point = scene.view.point();
  const TreeNode& root = tree.node(0);
  const glm::vec3 bound = contribution_bound(root, point);
  for (const OmniLight& light : scene.lights) {
    const Colour f = precise::transfer(point, light.position);
    for (int c = 0; c < 3; ++c)
      RC_ASSERT(bound[c] == inf || Quad(bound[c]) >= f[c] * Quad(root.intensity[c]));
  }
}

RC_GTEST_PROP(ContributionBound, ExceedsTheRealExpressionByNoMoreThanStated, ()) {
  const gen::Scene scene = *gen::scene(6);
  const LightTree tree = build(scene.light_set());
  const ShadingPoint point = scene.view.point();
  for (const TreeNode& node : tree.nodes()) {
    const glm::vec3 bound = contribution_bound(node, point);
    const auto real = real_bound(node, point);
    for (int c = 0; c < 3; ++c) {
      if (!real[c]) {
        RC_ASSERT(bound[c] == inf);
        continue;
      }
      const Quad most = *real[c] * (1 + bound_excess) + Quad(least);
      RC_ASSERT((bound[c] == inf ? most > Quad(largest) : Quad(bound[c]) <= most));
      RC_ASSERT(bound[c] == inf || Quad(bound[c]) >= *real[c]);
    }
  }
}

RC_GTEST_PROP(ContributionBound, ShrinksOnRefinement, ()) {
  const gen::Scene scene = *gen::scene();
  const LightTree tree = build(scene.light_set());
  const ShadingPoint point = scene.view.point();
  for (const TreeNode& node : tree.nodes()) {
    if (node.is_leaf()) continue;
    const glm::vec3 parent = contribution_bound(node, point);
    const glm::vec3 a = contribution_bound(tree.node(node.first_child), point);
    const glm::vec3 b = contribution_bound(tree.node(node.first_child + 1), point);
    for (int c = 0; c < 3; ++c)
      // Each child's bound may exceed its real expression by that and one smallest subnormal.
      RC_ASSERT(double(a[c]) + b[c] <= double(parent[c]) * (1 + bound_excess) + 2 * least);
  }
}

RC_GTEST_PROP(ContributionBound, IsZeroOnlyWhereNoLightCanContribute, ()) {
  const gen::Scene scene = *gen::scene();
  const LightTree tree = build(scene.light_set());
  const ShadingPoint point = scene.view.point();
  for (const TreeNode& node : tree.nodes()) {
    const glm::vec3 bound = contribution_bound(node, point);
    const auto real = real_bound(node, point);
    for (int c = 0; c < 3; ++c) RC_ASSERT((bound[c] == 0) == (real[c] && *real[c] == 0));
  }
}

// Computed and real value differ by about 2^-32 here, floats by 2^-23: about one light in 500 finds
// a float between the two.
TEST(ContributionBound, DominatesInTheSharpestLobe) {
  const Material mirror{glm::vec3(0), glm::vec3(1), Material::max_exponent};
  gen::Dice dice{rc::Random(1)};
  for (int i = 0; i < 20000; ++i) {
    const glm::vec3 n = dice.unit_vector();
    const ShadingPoint point({0, 0, 0}, n, n, mirror);
    const glm::vec3 y = point.mirror() + 1e-3F * dice.in_cube();
    const glm::vec3 bound = contribution_bound({{y, y}, glm::dvec3(1)}, point);
    EXPECT_GE(Quad(bound.x), precise::transfer(point, y)[0]);
  }
}

TEST(ContributionBound, OfALeafIsItsContributionRoundedUp) {
  const ShadingPoint point({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {glm::vec3(1)});
  const TreeNode leaf{{{0, 0, 2}, {0, 0, 2}}, {1, 0, 4}};
  const glm::vec3 bound = contribution_bound(leaf, point);
  EXPECT_GE(bound.x, std::numbers::inv_pi / 4);
  EXPECT_LE(bound.x, std::numbers::inv_pi / 4 * (1 + bound_excess));
  EXPECT_EQ(bound.y, 0);
  EXPECT_GE(bound.z, std::numbers::inv_pi);
}

TEST(ContributionBound, IsInfiniteWhereALightMayTouchThePointButNotInADarkChannel) {
  const ShadingPoint point({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {{1, 1, 0}});
  const TreeNode around{{{-1, -1, -1}, {1, 1, 1}}, {1, 0, 1}};
  EXPECT_EQ(contribution_bound(around, point), glm::vec3(inf, 0, 0));
}

// Each input was found by reasoning about the ends of the range, one NaN or violation each.
TEST(ContributionBound, HoldsAtTheEndsOfTheRange) {
  const Material mirror{glm::vec3(0), glm::vec3(1e-45F), Material::max_exponent};
  const ShadingPoint dim({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, mirror);
  const glm::vec3 side(3, 0, 4);
  EXPECT_GT(contribution_bound({{side, side}, glm::dvec3(1e-45F)}, dim).x, 0);

  const Material glare{glm::vec3(0), glm::vec3(largest), Material::max_exponent};
  const ShadingPoint bright({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, glare);
  const glm::vec3 near = 0x1p-147F * side;
  EXPECT_EQ(contribution_bound({{near, near}, glm::dvec3(largest)}, bright).x, 0x1p-149F);
}

RC_GTEST_PROP(ContributionLowerBound, IsBelowTheTrueContribution, ()) {
  const gen::Scene scene = *gen::scene();
  const LightTree tree = build(scene.light_set());
  const ShadingPoint point = scene.view.point();
  const std::vector<Colour> truth = precise::contributions(tree, point);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const glm::vec3 low = contribution_lower_bound(tree.nodes()[i], point);
    for (int c = 0; c < 3; ++c) RC_ASSERT(low[c] >= 0 && Quad(low[c]) <= truth[i][c]);
  }
}

TEST(ContributionLowerBound, OfADiffuseLeafIsItsContributionRoundedDown) {
  const ShadingPoint point({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {glm::vec3(1)});
  const TreeNode leaf{{{0, 0, 2}, {0, 0, 2}}, {1, 0, 4}};
  const glm::vec3 low = contribution_lower_bound(leaf, point);
  EXPECT_LE(low.x, std::numbers::inv_pi / 4);
  EXPECT_GE(low.x, std::numbers::inv_pi / 4 * (1 - bound_excess));
  EXPECT_EQ(low.y, 0);
}

RC_GTEST_PROP(ProductBound, IsNotBelowTheJointOneButForRounding, ()) {
  const gen::Scene scene = *gen::scene();
  const LightTree tree = build(scene.light_set());
  const ShadingPoint point = scene.view.point();
  for (const TreeNode& node : tree.nodes()) {
    const glm::vec3 joint = contribution_bound(node, point);
    const glm::vec3 product = product_bound(node, point);
    for (int c = 0; c < 3; ++c) {
      RC_ASSERT(!std::isnan(product[c]));
      RC_ASSERT(double(product[c]) * (1 + bound_excess) + least >= double(joint[c]));
    }
  }
}

} // namespace
} // namespace lightcuts
