// SPDX-License-Identifier: MIT
#include <lightcuts/core/kernels/contribution_bound.h>

#include <string>
#include <tuple>
#include <variant>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <lightcuts/core/tree/tree_builder.h>
#include <tests/support/box_reference.h>
#include <tests/support/float_limits.h>
#include <tests/support/generators.h>
#include <tests/support/precise.h>

namespace lightcuts {
namespace {

using precise::Colour;
using precise::Exact;
using precise::Quad;

glm::vec3 bound_of(const LightTree& tree, std::uint32_t node, const ShadingPoint& point) {
  return contribution_bound(tree, node, point);
}

glm::vec3 product_of(const LightTree& tree, std::uint32_t node, const ShadingPoint& point) {
  return contribution_bound(tree, node, point, BoundRule::product);
}

/// Of one omni light alone.
glm::vec3 bound_of_light(const glm::vec3& y, const glm::vec3& intensity,
                         const ShadingPoint& point) {
  LightSet lights;
  lights.add_omni(y, intensity);
  return bound_of(build(lights), 0, point);
}

/// The expression that contribution_bound() stands for, in real numbers; nothing if infinite. Omni
/// lights, diffuse and Phong.
std::array<std::optional<Quad>, 3> real_bound(const TreeNode& node, const ShadingPoint& point) {
  const glm::vec3& x = point.position();
  const auto joint = precise::max_cosine_over_distance2(point.normal(), x, node.box);
  const Quad cosine =
      Quad(precise::max_cosine(point.mirror(), x, node.box)) / precise::length(point.mirror());
  const auto* phong = std::get_if<Phong>(&point.material().lobe);
  Quad lobe = 0;
  if (phong && cosine > 0)
    lobe =
        (Quad(phong->exponent) + 2) / (2 * precise::pi()) * precise::power(cosine, phong->exponent);
  std::array<std::optional<Quad>, 3> bound;
  for (int c = 0; c < 3; ++c) {
    Quad f = Quad(point.material().diffuse[c]) / precise::pi();
    if (phong) f += Quad(phong->reflectance[c]) * lobe;
    const Quad factor = f * Quad(node.intensity[c]);
    if (factor == 0)
      bound[c] = Quad(0);
    else if (joint)
      bound[c] = Quad(factor * Quad(*joint) / precise::length(point.normal()));
  }
  return bound;
}

void check_dominates(const gen::Scene& scene) {
  const LightTree tree = build(scene.light_set());
  const ShadingPoint point = scene.view.point();
  const std::vector<Colour> truth = precise::contributions(tree, point);
  for (std::uint32_t i = 0; i < truth.size(); ++i) {
    const glm::vec3 bound = bound_of(tree, i, point);
    const glm::vec3 product = product_of(tree, i, point);
    for (int c = 0; c < 3; ++c) {
      RC_ASSERT(!std::isnan(bound[c]));
      RC_ASSERT(bound[c] == inf || Quad(bound[c]) >= truth[i][c]);
      RC_ASSERT(!std::isnan(product[c]));
      RC_ASSERT(product[c] == inf || Quad(product[c]) >= truth[i][c]);
    }
  }
}

void check_shrinks(const gen::Scene& scene) {
  const LightTree tree = build(scene.light_set());
  const ShadingPoint point = scene.view.point();
  for (std::uint32_t i = 0; i < tree.nodes().size(); ++i) {
    const TreeNode& node = tree.node(i);
    if (node.is_leaf()) continue;
    const glm::vec3 parent = bound_of(tree, i, point);
    const glm::vec3 a = bound_of(tree, node.first_child, point);
    const glm::vec3 b = bound_of(tree, node.first_child + 1, point);
    for (int c = 0; c < 3; ++c)
      // Each child's bound may exceed its real expression by that and one smallest subnormal.
      RC_ASSERT(double(a[c]) + b[c] <= double(parent[c]) * (1 + bound_excess) + 2 * smallest_float);
  }
}

void check_lower_bound(const gen::Scene& scene) {
  const LightTree tree = build(scene.light_set());
  const ShadingPoint point = scene.view.point();
  const std::vector<Colour> truth = precise::contributions(tree, point);
  for (std::uint32_t i = 0; i < truth.size(); ++i) {
    const glm::vec3 low = contribution_lower_bound(tree, i, point);
    for (int c = 0; c < 3; ++c) RC_ASSERT(low[c] >= 0 && Quad(low[c]) <= truth[i][c]);
  }
}

/// One test for each kind of light, lobe, and clamped or not.
class BoundsOf : public testing::TestWithParam<std::tuple<int, int, bool>> {
protected:
  template <class Check>
  static void for_all(const char* what, Check&& check) {
    const auto [kind, lobe, clamped] = GetParam();
    const auto scenes = gen::scene_of(LightKind(kind), std::size_t(lobe), clamped);
    EXPECT_TRUE(rc::check(what, [&] { check(*scenes); }));
  }
};

TEST_P(BoundsOf, DominateTheTrueContribution) { for_all("dominates", check_dominates); }
TEST_P(BoundsOf, ShrinkOnRefinement) { for_all("shrinks", check_shrinks); }
TEST_P(BoundsOf, HaveALowerOneBelowTheTrueContribution) { for_all("lower", check_lower_bound); }

std::string name_of_case(const testing::TestParamInfo<std::tuple<int, int, bool>>& tested) {
  constexpr const char* kinds[] = {"Omni", "Oriented", "Spot", "Directional", "Profile"};
  constexpr const char* lobes[] = {"Diffuse", "Phong", "Ward", "CookTorrance"};
  const auto [kind, lobe, clamped] = tested.param;
  return std::string(kinds[kind]) + lobes[lobe] + (clamped ? "Clamped" : "");
}

INSTANTIATE_TEST_SUITE_P(All, BoundsOf,
                         testing::Combine(testing::Range(0, light_kind_count),
                                          testing::Range(0, int(std::variant_size_v<Lobe>)),
                                          testing::Bool()),
                         name_of_case);

RC_GTEST_PROP(ContributionBound, HoldsForAMixtureOfLights, ()) {
  const gen::Scene scene = *gen::scene();
  check_dominates(scene);
  check_shrinks(scene);
  check_lower_bound(scene);
}

RC_GTEST_PROP(ContributionBound, DominatesTheEstimateMadeAtAnyLightOfTheCluster, ()) {
  const gen::Scene scene = *gen::plain_scene();
  const LightTree tree = build(scene.light_set());
  const ShadingPoint point = scene.view.point();
  const TreeNode& root = tree.node(0);
  const glm::vec3 bound = bound_of(tree, 0, point);
  for (const Light& light : scene.lights) {
    const Colour f = precise::transfer(point, light.position);
    for (int c = 0; c < 3; ++c)
      RC_ASSERT(bound[c] == inf || Quad(bound[c]) >= f[c] * Quad(root.intensity[c]));
  }
}

RC_GTEST_PROP(ContributionBound, ExceedsTheRealExpressionByNoMoreThanStated, ()) {
  const gen::Scene scene = *gen::plain_scene(6);
  const LightTree tree = build(scene.light_set());
  const ShadingPoint point = scene.view.point();
  for (std::uint32_t i = 0; i < tree.nodes().size(); ++i) {
    const glm::vec3 bound = bound_of(tree, i, point);
    const auto real = real_bound(tree.node(i), point);
    for (int c = 0; c < 3; ++c) {
      if (!real[c]) {
        RC_ASSERT(bound[c] == inf);
        continue;
      }
      const Quad most = *real[c] * (1 + bound_excess) + Quad(smallest_float);
      RC_ASSERT((bound[c] == inf ? most > Quad(largest_float) : Quad(bound[c]) <= most));
      RC_ASSERT(bound[c] == inf || Quad(bound[c]) >= *real[c]);
      RC_ASSERT((bound[c] == 0) == (*real[c] == 0));
    }
  }
}

// Computed and real value differ by about 2^-32 here, floats by 2^-23: about one light in 500 finds
// a float between the two.
TEST(ContributionBound, DominatesInTheSharpestLobe) {
  const Material mirror{glm::vec3(0), Phong{glm::vec3(1), Phong::max_exponent}};
  gen::Dice dice(1);
  for (int i = 0; i < 20000; ++i) {
    const glm::vec3 n = dice.unit_vector();
    const ShadingPoint point({0, 0, 0}, n, n, mirror);
    const glm::vec3 y = point.mirror() + 1e-3F * dice.in_cube();
    const glm::vec3 bound = bound_of_light(y, glm::vec3(1), point);
    EXPECT_GE(Quad(bound.x), precise::transfer(point, y)[0]);
  }
}

// The lobe is so narrow that the rounding of the stored mirror direction is a thousandth of it.
TEST(ContributionBound, DominatesWhereTheMirrorDirectionsRoundingShows) {
  gen::Dice dice(2);
  for (int i = 0; i < 4000; ++i) {
    const glm::vec3 n = dice.unit_vector();
    const Lobe lobes[] = {Ward{glm::vec3(1), Ward::min_alpha},
                          CookTorrance{glm::vec3(1), CookTorrance::min_alpha}};
    const ShadingPoint point({0, 0, 0}, n, n, {glm::vec3(0), lobes[i % 2]});
    const glm::vec3 y = 1000.0F * n + 0.1F * dice.in_cube();
    const glm::vec3 bound = bound_of_light(y, glm::vec3(1), point);
    EXPECT_GE(Quad(bound.x), precise::transfer(point, y)[0]);
  }
}

TEST(ContributionBound, OfALeafIsItsContributionRoundedUp) {
  const ShadingPoint point({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {glm::vec3(1), {}});
  const glm::vec3 bound = bound_of_light({0, 0, 2}, {1, 0, 4}, point);
  EXPECT_GE(bound.x, std::numbers::inv_pi / 4);
  EXPECT_LE(bound.x, std::numbers::inv_pi / 4 * (1 + bound_excess));
  EXPECT_EQ(bound.y, 0);
  EXPECT_GE(bound.z, std::numbers::inv_pi);
}

TEST(ContributionBound, IsInfiniteWhereALightMayTouchThePointButNotInADarkChannel) {
  const ShadingPoint point({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {{1, 1, 0}, {}});
  LightSet lights;
  lights.add_omni({-1, -1, -1}, {1, 0, 1});
  lights.add_omni({1, 1, 1}, {1, 0, 1});
  EXPECT_EQ(bound_of(build(lights), 0, point), glm::vec3(inf, 0, 0));
}

// Each input was found by reasoning about the ends of the range, one NaN or violation each.
TEST(ContributionBound, HoldsAtTheEndsOfTheRange) {
  const Material mirror{glm::vec3(0), Phong{glm::vec3(1e-45F), Phong::max_exponent}};
  const ShadingPoint dim({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, mirror);
  const glm::vec3 side(3, 0, 4);
  EXPECT_GT(bound_of_light(side, glm::vec3(1e-45F), dim).x, 0);

  const Material glare{glm::vec3(0), Phong{glm::vec3(largest_float), Phong::max_exponent}};
  const ShadingPoint bright({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, glare);
  const glm::vec3 near = 0x1p-147F * side;
  EXPECT_EQ(bound_of_light(near, glm::vec3(largest_float), bright).x, 0x1p-149F);
}

TEST(ContributionLowerBound, OfADiffuseLeafIsItsContributionRoundedDown) {
  const ShadingPoint point({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {glm::vec3(1), {}});
  LightSet lights;
  lights.add_omni({0, 0, 2}, {1, 0, 4});
  const glm::vec3 low = contribution_lower_bound(build(lights), 0, point);
  EXPECT_LE(low.x, std::numbers::inv_pi / 4);
  EXPECT_GE(low.x, std::numbers::inv_pi / 4 * (1 - bound_excess));
  EXPECT_EQ(low.y, 0);
}

// n.l is 2^-135 and the clamp the largest float: squared, n.l falloff is below what doubles hold.
TEST(ContributionLowerBound, IsBelowTheContributionOfWhatIsTinyInAllButBrightness) {
  constexpr float tiny = 0x1p-149F;
  for (const float x : {4 * tiny, 6 * tiny, 100 * tiny, 0x1p-120F}) {
    LightSet lights;
    lights.set_min_distance(largest_float);
    lights.add_omni({x, 0, 0}, glm::vec3(largest_float));
    const ShadingPoint point({0, 0, 0}, {0x1.0d34p-135F, 1, 0}, {1, 0, 0},
                             {glm::vec3(largest_float), {}});
    const Quad exact = precise::contribution(point, lights[0], largest_float)[0];
    EXPECT_GT(exact, 0);
    const float low = contribution_lower_bound(build(lights), 0, point).x;
    EXPECT_LE(Quad(low), exact) << x;
    EXPECT_GE(Quad(low), exact * (1 - 0x1p-20) - Quad(tiny)) << x;
  }
}

RC_GTEST_PROP(ProductBound, IsNotBelowTheJointOneButForRounding, ()) {
  const gen::Scene scene = *gen::scene();
  const LightTree tree = build(scene.light_set());
  const ShadingPoint point = scene.view.point();
  for (std::uint32_t i = 0; i < tree.nodes().size(); ++i) {
    const glm::vec3 joint = bound_of(tree, i, point);
    const glm::vec3 product = product_of(tree, i, point);
    for (int c = 0; c < 3; ++c) {
      RC_ASSERT(!std::isnan(product[c]));
      RC_ASSERT(double(product[c]) * (1 + bound_excess) + smallest_float >= double(joint[c]));
    }
  }
}

} // namespace
} // namespace lightcuts
