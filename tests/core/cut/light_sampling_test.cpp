// SPDX-License-Identifier: MIT
#include <lightcuts/core/cut/light_sampling.h>

#include <cmath>
#include <map>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <lightcuts/core/cut/certified_error.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <tests/support/check_property.h>
#include <tests/support/generators.h>
#include <tests/support/precise.h>

namespace lightcuts {
namespace {

using precise::Colour;
using precise::Quad;
using Probabilities = std::map<std::uint32_t, double>; // of the cluster's lights

/// A scene, its tree, and how a light is drawn there.
template <class Importance>
struct Draw {
  gen::Scene scene;
  LightTree tree = build(scene.light_set());
  ShadingPoint point = scene.view.point();

  [[nodiscard]] LightSample sample(std::uint32_t node, double u) const {
    return sample_light(Importance(), tree, node, point, u);
  }
  [[nodiscard]] Probabilities probabilities(std::uint32_t node) const {
    Probabilities result;
    visit_probabilities(Importance(), tree, node, point,
                        [&](std::uint32_t i, double p) { result[i] = p; });
    return result;
  }
  [[nodiscard]] double probability(std::uint32_t node, std::uint32_t light) const {
    return light_probability(Importance(), tree, node, light, point);
  }
  [[nodiscard]] ChildShares shares(std::uint32_t node) const {
    return Importance::shares(tree, node, point);
  }
  [[nodiscard]] glm::dvec3 contribution(std::uint32_t light) const {
    const Light& l = tree.lights()[light];
    return transfer(point, l, scene.min_distance) * glm::dvec3(l.intensity);
  }
};

/// Probability that the descent from the node ends where no child can contribute.
template <class Importance>
double probability_of_none(const Draw<Importance>& draw, std::uint32_t node) {
  const TreeNode& cluster = draw.tree.node(node);
  if (cluster.is_leaf()) return 0;
  const ChildShares share = draw.shares(node);
  if (share.first == 0 && share.second == 0) return 1;
  double none = 0;
  if (share.first > 0) none += share.first * probability_of_none(draw, cluster.first_child);
  if (share.second > 0) none += share.second * probability_of_none(draw, cluster.first_child + 1);
  return none;
}

/// Three roundings of 2^-53 per level: of a share, of its product, and of a sum of two.
double rounding(const LightTree& tree) { return 3 * 0x1p-53 * double(tree.lights().size()); }

double sum_of(const Probabilities& probabilities) {
  double sum = 0;
  for (const auto& [light, p] : probabilities) sum += p;
  return sum;
}

template <class Importance>
class LightSampling : public testing::Test {};

using Importances = testing::Types<IntensityImportance, HierarchicalImportance>;
TYPED_TEST_SUITE(LightSampling, Importances);

TYPED_TEST(LightSampling, HasProbabilitiesThatSumToOne) {
  check_property("those of all lights and of none sum to 1", [] {
    const Draw<TypeParam> draw{*gen::scene()};
    for (std::uint32_t i = 0; i < draw.tree.nodes().size(); ++i) {
      const Probabilities p = draw.probabilities(i);
      RC_ASSERT(p.size() == draw.tree.node(i).light_count);
      for (const auto& [light, probability] : p) RC_ASSERT(probability >= 0);
      RC_ASSERT(std::abs(sum_of(p) + probability_of_none(draw, i) - 1) <= rounding(draw.tree));
    }
  });
}

// More nodes than it remembers, in any order, and more than once.
TYPED_TEST(LightSampling, RemembersTheSharesAtAPoint) {
  check_property("SharesAtPoint has the same bits", [] {
    const Draw<TypeParam> draw{*gen::scene(100)};
    const ShadingPoint other(draw.point.position() + glm::vec3(1), -draw.point.normal(),
                             draw.point.to_viewer(), draw.point.material());
    SharesAtPoint<TypeParam> remembered;
    for (const ShadingPoint& point : {draw.point, other}) {
      remembered.forget();
      for (int i = 0; i < 200; ++i) {
        const auto node = *rc::gen::inRange<std::uint32_t>(0, draw.tree.nodes().size());
        if (draw.tree.node(node).is_leaf()) continue;
        const ChildShares a = remembered.shares(draw.tree, node, point);
        const ChildShares b = TypeParam::shares(draw.tree, node, point);
        RC_ASSERT(a.first == b.first);
        RC_ASSERT(a.second == b.second);
      }
    }
  });
}

TYPED_TEST(LightSampling, MayDrawEveryLightThatContributes) {
  check_property("a contribution above 0 has a probability above 0", [] {
    const Draw<TypeParam> draw{*gen::scene()};
    for (std::uint32_t i = 0; i < draw.tree.nodes().size(); ++i)
      for (const auto& [light, p] : draw.probabilities(i)) {
        const Colour f =
            precise::contribution(draw.point, draw.tree.lights()[light], draw.scene.min_distance);
        RC_ASSERT(p > 0 || (f[0] == 0 && f[1] == 0 && f[2] == 0));
      }
  });
}

TYPED_TEST(LightSampling, ExpectsTheExactSum) {
  check_property("sum p (f/p) is the cluster's contribution", [] {
    const Draw<TypeParam> draw{*gen::scene()};
    const std::vector<Colour> truth = precise::contributions(draw.tree, draw.point);
    for (std::uint32_t i = 0; i < draw.tree.nodes().size(); ++i) {
      glm::dvec3 mean(0);
      for (const auto& [light, p] : draw.probabilities(i))
        if (p > 0) mean += p * (draw.contribution(light) / p);
      for (int c = 0; c < 3; ++c)
        // 2^-149: what underflows in transfer(), see certified_error().
        RC_ASSERT(std::isinf(mean[c]) || abs(Quad(mean[c]) - truth[i][c]) <=
                                             truth[i][c] * estimate_error + Quad(0x1p-149));
    }
  });
}

TYPED_TEST(LightSampling, SaysWithWhichProbabilityItDrew) {
  check_property("the sample's probability is light_probability(), bit for bit", [] {
    const Draw<TypeParam> draw{*gen::scene()};
    gen::Dice dice(std::uint64_t(*rc::gen::arbitrary<std::uint64_t>()));
    for (std::uint32_t i = 0; i < draw.tree.nodes().size(); ++i) {
      const double u = dice.one_in(4) ? dice.pick({0.0, 1 - 0x1p-53, 0.5}) : dice.uniform(0, 1);
      const LightSample sample = draw.sample(i, u);
      if (sample.probability > 0)
        RC_ASSERT(sample.probability == draw.probability(i, sample.light));
      else
        RC_ASSERT(probability_of_none(draw, i) > 0);
    }
  });
}

TYPED_TEST(LightSampling, DrawsEachLightAsOftenAsItSays) {
  check_property("the measure of u is the probability", [] {
    constexpr int steps = 1 << 12;
    const Draw<TypeParam> draw{*gen::scene()};
    std::map<std::uint32_t, int> drawn;
    int none = 0;
    for (int k = 0; k < steps; ++k) {
      const LightSample sample = draw.sample(0, (k + 0.5) / steps);
      ++(sample.probability > 0 ? drawn[sample.light] : none);
    }
    // An interval of length p has p / (1 / steps) of evenly spaced points, give or take one.
    const double slack = 1 + steps * rounding(draw.tree);
    for (const auto& [light, p] : draw.probabilities(0))
      RC_ASSERT(std::abs(drawn[light] - p * steps) <= slack);
    // What is drawn for none is as many intervals as there are ends of the kind.
    RC_ASSERT(std::abs(none - probability_of_none(draw, 0) * steps) <=
              slack * double(draw.tree.lights().size()));
  });
}

TYPED_TEST(LightSampling, DrawsTheLightOfALeaf) {
  check_property("a leaf's light has probability 1", [] {
    const Draw<TypeParam> draw{*gen::scene()};
    for (std::uint32_t i = 0; i < draw.tree.nodes().size(); ++i)
      if (draw.tree.node(i).is_leaf()) {
        const LightSample sample = draw.sample(i, 0.5);
        RC_ASSERT(sample.probability == 1.0);
        RC_ASSERT(sample.light == draw.tree.node(i).representative);
      }
  });
}

/// A share of its own at the root; below it only the first child can contribute.
struct RootShare {
  double first;

  [[nodiscard]] ChildShares shares(const LightTree& /*tree*/, std::uint32_t node,
                                   const ShadingPoint& /*point*/) const {
    return node == 0 ? ChildShares{first, 1 - first} : ChildShares{1, 0};
  }
};

// For one share in 26 the second child's u rounds to 1, where nothing is drawn.
TEST(SampleLight, KeepsRandomNumbersBelowOne) {
  LightSet lights;
  for (const float x : {0.0F, 1.0F, 10.0F, 11.0F}) lights.add_omni({x, 0, 1}, glm::vec3(1));
  const LightTree tree = build(lights);
  const ShadingPoint point({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {glm::vec3(1)});
  gen::Dice dice(1);
  for (int i = 0; i < 10000; ++i) {
    const RootShare importance{std::ldexp(dice.uniform(0.5, 1), -dice.below(12))};
    const LightSample last = sample_light(importance, tree, 0, point, 1 - 0x1p-53);
    EXPECT_EQ(last.probability, 1 - importance.first);
  }
}

TEST(SharesOf, AreInProportion) {
  EXPECT_EQ(shares_of(1, 3).first, 0.25);
  EXPECT_EQ(shares_of(1, 3).second, 0.75);
}

TEST(SharesOf, AreNotZeroForAPositiveWeightHoweverSmall) {
  EXPECT_EQ(shares_of(1e-300, 1e300).first, min_share);
  EXPECT_EQ(shares_of(1e300, 1e-300).second, min_share);
  EXPECT_EQ(shares_of(0, 1e-300).second, 1);
  EXPECT_EQ(shares_of(1e-300, 0).first, 1);
}

TEST(SharesOf, AreZeroWhereBothWeightsAre) {
  EXPECT_EQ(shares_of(0, 0).first, 0);
  EXPECT_EQ(shares_of(0, 0).second, 0);
}

/// Probability of light 0 against light 1, drawn from both.
template <class Importance>
double share_of_first(const std::vector<Light>& lights, const Material& material = {glm::vec3(1)},
                      float min_distance = 0) {
  const gen::Scene scene{lights, {{0, 0, 0}, {0, 0, 1}, {0, 0, 1}, material}, min_distance};
  return Draw<Importance>{scene}.probability(0, 0);
}

Light omni(const glm::vec3& position, float intensity = 1) {
  return {.position = position, .intensity = glm::vec3(intensity)};
}

TEST(IntensityImportance, AsksForTheIntensityAlone) {
  EXPECT_EQ(share_of_first<IntensityImportance>({omni({0, 0, 1}), omni({0, 0, -9}, 3)}), 0.25);
}

TEST(HierarchicalImportance, WeighsByIntensityOverSquaredDistance) {
  const double share =
      share_of_first<HierarchicalImportance>({omni({0, 0, 1}), omni({0, 0, 2}, 12)});
  EXPECT_NEAR(share, 0.25, bound_excess);
}

TEST(HierarchicalImportance, ClampsTheDistance) {
  const double share = share_of_first<HierarchicalImportance>({omni({0, 0, 1}), omni({0, 0, 2}, 3)},
                                                              {glm::vec3(1)}, 8);
  EXPECT_NEAR(share, 0.25, bound_excess);
}

TEST(HierarchicalImportance, WeighsByCosineAndLobe) {
  const std::vector<Light> lights{omni({0, 0, 5}), omni({3, 0, 4})};
  EXPECT_NEAR(share_of_first<HierarchicalImportance>(lights), 1 / 1.8, bound_excess);
  const Material shiny{glm::vec3(0), Phong{glm::vec3(1), 2}};
  EXPECT_NEAR(share_of_first<HierarchicalImportance>(lights, shiny), 1 / (1 + 0.8 * 0.64),
              4 * bound_excess);
}

TEST(HierarchicalImportance, NeverDrawsLightsBelowTheHorizonOrFacingAway) {
  EXPECT_EQ(share_of_first<HierarchicalImportance>({omni({0, 0, -1}), omni({0, 0, 2})}), 0);
  Light away = omni({0, 0, 1});
  away.kind = LightKind::oriented;
  away.axis = {0, 0, 1};
  Light facing = away;
  facing.axis = {0, 0, -1};
  EXPECT_EQ(share_of_first<HierarchicalImportance>({away, facing}), 0);
}

TEST(HierarchicalImportance, OfDirectionalLightsHasNoDistance) {
  Light sun{.kind = LightKind::directional, .position = {0, 0, 1}, .intensity = glm::vec3(1)};
  Light dim = sun;
  dim.intensity = glm::vec3(3);
  EXPECT_NEAR(share_of_first<HierarchicalImportance>({sun, dim}), 0.25, bound_excess);
}

// W/sr over m^2 against W/m^2.
TEST(HierarchicalImportance, ComparesKindsByTheirIrradiance) {
  const Light sun{.kind = LightKind::directional, .position = {0, 0, 1}, .intensity = glm::vec3(3)};
  EXPECT_NEAR(share_of_first<HierarchicalImportance>({omni({0, 0, 2}, 4), sun}), 0.25,
              bound_excess);
}

// Each child is two lights 2 m apart; the first is 1 m away at the least, less than its diagonal.
TEST(HierarchicalImportance, LeavesDistancesOutWhereOneIsBelowTheDiagonal) {
  const auto share_at = [](float distance) {
    const gen::Scene scene{
        {omni({-1, 0, distance}), omni({1, 0, distance}), omni({-1, 0, 100}), omni({1, 0, 100})},
        {}};
    const Draw<HierarchicalImportance> draw{scene};
    return draw.probability(0, 0) + draw.probability(0, 1);
  };
  EXPECT_NEAR(share_at(1), 0.5, bound_excess);
  EXPECT_NEAR(share_at(4), 10000.0 / 10016, bound_excess);
}

} // namespace
} // namespace lightcuts
