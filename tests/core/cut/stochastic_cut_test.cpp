// SPDX-License-Identifier: MIT
#include <lightcuts/core/cut/stochastic_cut.h>

#include <array>
#include <cmath>
#include <cstring>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <lightcuts/core/cut/sum_lights.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <tests/support/allocation_count.h>
#include <tests/support/check_property.h>
#include <tests/support/cut_promises.h>
#include <tests/support/generators.h>

namespace lightcuts {
namespace {

using ByIntensity = BasicStochasticCutSelector<IntensityImportance>;

bool same_bits(const glm::vec3& a, const glm::vec3& b) {
  return std::memcmp(&a, &b, sizeof(a)) == 0;
}

template <class Selector>
class StochasticCut : public testing::Test {};

using Selectors = testing::Types<ByIntensity, StochasticCutSelector>;
TYPED_TEST_SUITE(StochasticCut, Selectors);

TYPED_TEST(StochasticCut, CertifiesItsErrorAndCountsItsRays) {
  check_property("radiance is within certified_error of the truth", [] {
    const CutCase given = *cut_case();
    const LightTree tree = build(given.scene.light_set());
    const ShadingPoint point = given.scene.view.point();
    TypeParam select(tree, given.config, *rc::gen::arbitrary<std::uint64_t>());
    std::vector<int> calls(tree.lights().size());
    const Cut cut = select(point, 0, [&](std::uint32_t i) {
      ++calls[i];
      return given.visibility()(i);
    });
    RC_ASSERT(promises::partitions(tree, cut));
    RC_ASSERT(promises::certified(cut, precise::sum(tree.lights(), point, given.visibility())));
    RC_ASSERT(promises::leaves_are_exact(tree, cut));
    std::uint32_t total = 0;
    for (const int n : calls) {
      RC_ASSERT(n <= 1);
      total += std::uint32_t(n);
    }
    RC_ASSERT(total == cut.shadow_rays);
    RC_ASSERT(total <= cut.clusters.size());
  });
}

TYPED_TEST(StochasticCut, GivesTheSameBitsAgainAsAnew) {
  check_property("again() is a call with that query at the point of the last call", [] {
    const CutCase given = *cut_case();
    const LightTree tree = build(given.scene.light_set());
    const ShadingPoint point = given.scene.view.point();
    const ShadingPoint other(point.position() * 0.5F, -point.normal(), point.to_viewer(),
                             point.material());
    TypeParam once(tree, given.config), anew(tree, given.config);
    for (const ShadingPoint& at : {other, point}) {
      std::ignore = once(at, 99, given.visibility());
      for (std::uint64_t query = 0; query < 5; ++query) {
        const Cut a = once.again(at, query, given.visibility());
        const Cut b = anew(at, query, given.visibility());
        RC_ASSERT(same_bits(a.radiance, b.radiance));
        RC_ASSERT(same_bits(a.certified_error, b.certified_error));
        RC_ASSERT(a.shadow_rays == b.shadow_rays);
        RC_ASSERT(a.end == b.end);
        RC_ASSERT(a.clusters.size() == b.clusters.size());
        for (std::size_t i = 0; i < a.clusters.size(); ++i) {
          RC_ASSERT(a.clusters[i].node == b.clusters[i].node);
          RC_ASSERT(a.clusters[i].visible == b.clusters[i].visible);
          RC_ASSERT(a.clusters[i].estimate == b.clusters[i].estimate);
        }
      }
    }
  });
}

TYPED_TEST(StochasticCut, HasTheCutThatIsChosenAsIfAllWereSeen) {
  check_property("the cut depends neither on what is drawn nor on what is seen", [] {
    const CutCase given = *cut_case();
    const LightTree tree = build(given.scene.light_set());
    const ShadingPoint point = given.scene.view.point();
    CutSelector choose(tree, given.config);
    TypeParam select(tree, given.config, *rc::gen::arbitrary<std::uint64_t>());
    const Cut chosen = choose(point, everything);
    const Cut cut = select(point, *rc::gen::arbitrary<std::uint64_t>(), given.visibility());
    RC_ASSERT(cut.end == chosen.end);
    RC_ASSERT(std::equal(cut.clusters.begin(), cut.clusters.end(), chosen.clusters.begin(),
                         chosen.clusters.end(), [](const CutCluster& a, const CutCluster& b) {
                           return a.node == b.node && a.bound == b.bound;
                         }));
  });
}

TYPED_TEST(StochasticCut, YieldsTheSameBitsForTheSameSeedAndQuery) {
  check_property("the same numbers, also after another query", [] {
    const CutCase given = *cut_case();
    const LightTree tree = build(given.scene.light_set());
    const ShadingPoint point = given.scene.view.point();
    TypeParam fresh(tree, given.config, 7), used(tree, given.config, 7);
    (void)used((*gen::scene(1)).view.point(), 5, everything);
    const Cut a = fresh(point, 3, given.visibility()), b = used(point, 3, given.visibility());
    RC_ASSERT(a.radiance == b.radiance);
    RC_ASSERT(a.certified_error == b.certified_error);
    RC_ASSERT(a.shadow_rays == b.shadow_rays);
  });
}

TYPED_TEST(StochasticCut, DoesNotAllocateOnceWarm) {
  check_property("no allocation", [] {
    const CutCase given = *cut_case();
    const LightTree tree = build(given.scene.light_set());
    const ShadingPoint point = given.scene.view.point();
    TypeParam select(tree, given.config);
    (void)select(point, 0, everything);
    const std::size_t before = allocation_count();
    (void)select(point, 1, everything);
    const std::size_t after = allocation_count();
    RC_ASSERT(before == after);
  });
}

TYPED_TEST(StochasticCut, CastsNoRaysWhereNothingOccludes) {
  check_property("visible is not called, and the radiance is the same", [] {
    const gen::Scene scene = *gen::scene();
    const LightTree tree = build(scene.light_set());
    const ShadingPoint point = scene.view.point();
    CutConfig config{0.3F, 5};
    TypeParam select(tree, config);
    config.unoccluded = true;
    TypeParam select_unoccluded(tree, config);
    const auto never_asked = [](std::uint32_t) -> bool { throw std::logic_error("asked"); };
    const Cut cut = select_unoccluded(point, 0, never_asked);
    RC_ASSERT(cut.radiance == select(point, 0, everything).radiance);
    RC_ASSERT(cut.shadow_rays == 0U);
  });
}

/// Lights of several kinds and intensities above a floor, every third of them hidden.
LightSet mixed_lights() {
  LightSet lights;
  gen::Dice dice(3);
  const auto intensity = [&] { return glm::vec3(0.5) + 0.5F * dice.in_cube(); };
  for (int i = 0; i < 150; ++i) {
    const glm::vec3 p = 4.0F * dice.in_cube() + glm::vec3(0, 0, 3);
    lights.add_omni(p, intensity());
    lights.add_oriented(p + dice.in_cube(), glm::normalize(dice.in_cube()), intensity());
    if (i % 10 == 0) lights.add_directional(glm::normalize(dice.in_cube()), 0.02F * intensity());
  }
  return lights;
}

bool two_in_three(std::uint32_t light) { return light % 3 != 0; }

ShadingPoint shiny_point() {
  return {{0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {{0.5F, 0.4F, 0.3F}, Phong{glm::vec3(0.2F), 8}}};
}

/// Of what a selector that draws by this importance gives for a cut, by the probabilities.
template <class Importance>
struct Moments {
  glm::dvec3 mean{0}, variance{0};

  Moments(const LightTree& tree, const Cut& cut, const ShadingPoint& point) {
    for (const CutCluster& c : cut.clusters) {
      glm::dvec3 first(0), second(0);
      visit_probabilities(Importance(), tree, c.node, point, [&](std::uint32_t i, double p) {
        if (p == 0 || !two_in_three(i)) return;
        const Light& light = tree.lights()[i];
        const glm::dvec3 f = transfer(point, light) * glm::dvec3(light.intensity);
        first += f;
        second += f * f / p;
      });
      mean += first;
      variance += second - first * first;
    }
  }
};

template <class Selector>
struct ImportanceOf;
template <class Importance>
struct ImportanceOf<BasicStochasticCutSelector<Importance>> {
  using Type = Importance;
};

// The mean of n independent samples has the exact mean, and a deviation of sqrt(variance / n); the
// mean square deviation from it is the variance, give or take sqrt(kurtosis / n) of it.
TYPED_TEST(StochasticCut, HasTheExactMeanAndTheVarianceOfIndependentDraws) {
  const LightTree tree = build(mixed_lights());
  const ShadingPoint point = shiny_point();
  const CutConfig config{0.3F, 30};
  constexpr int n = 20000;
  glm::dvec3 sum(0), squares(0);
  CutSelector choose(tree, config);
  const Cut cut = choose(point, everything);
  ASSERT_GT(cut.clusters.size(), 10U);
  const Moments<typename ImportanceOf<TypeParam>::Type> expected(tree, cut, point);
  for (int k = 0; k < n; ++k) {
    TypeParam select(tree, config, std::uint64_t(k));
    const glm::dvec3 d = glm::dvec3(select(point, 11, two_in_three).radiance) - expected.mean;
    sum += d;
    squares += d * d;
  }
  const LightSum exact = sum_lights(tree.lights(), point, two_in_three);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(expected.mean[c], exact.radiance[c], exact.radiance[c] * estimate_error);
    // 6 sigma: a chance of 10^-9; 2^-24: radiance is a float.
    EXPECT_LE(std::abs(sum[c] / n),
              6 * std::sqrt(expected.variance[c] / n) + 0x1p-24 * expected.mean[c]);
    EXPECT_NEAR(squares[c] / n / expected.variance[c], 1, 0.15);
  }
}

/// Two pairs of lights, far apart; the cut has a cluster for each.
LightTree two_pairs() {
  LightSet lights;
  for (const float x : {-100.0F, 100.0F})
    for (const float dx : {-0.1F, 0.1F}) lights.add_omni({x + dx, 0, 100}, glm::vec3(1));
  return build(lights);
}

using Counts = std::array<int, 4>;

/// Binomial with p = 1/4: a deviation of sqrt(3/16 n).
void expect_even(const Counts& counts) {
  const double n = counts[0] + counts[1] + counts[2] + counts[3];
  for (const int count : counts) EXPECT_NEAR(count, n / 4, 6 * std::sqrt(3 * n / 16));
}

/// Bit k: the second light of pair k is drawn.
template <class Selector>
int drawn_pair(const LightTree& tree, std::uint64_t seed, std::uint64_t query) {
  Selector select(tree, {.max_size = 2}, seed);
  int drawn = 0;
  (void)select(ShadingPoint({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {glm::vec3(1)}), query,
               [&](std::uint32_t i) {
                 drawn |= int(i % 2) << (i / 2);
                 return true;
               });
  return drawn;
}

TYPED_TEST(StochasticCut, DrawsIndependentlyForClustersQueriesAndSeeds) {
  const LightTree tree = two_pairs();
  Counts clusters{}, queries{}, seeds{};
  for (std::uint64_t k = 0; k < 4000; ++k) {
    const int here = drawn_pair<TypeParam>(tree, 1, k);
    ++clusters[std::size_t(here)];
    ++queries[std::size_t(here % 2 + 2 * (drawn_pair<TypeParam>(tree, 1, k + 1) % 2))];
    ++seeds[std::size_t(here % 2 + 2 * (drawn_pair<TypeParam>(tree, 2, k) % 2))];
  }
  expect_even(clusters);
  expect_even(queries);
  expect_even(seeds);
}

TEST(StochasticCut, OfNoLightsIsBlackAndEmpty) {
  const LightTree tree;
  StochasticCutSelector select(tree);
  const Cut cut = select(shiny_point(), 0, everything);
  EXPECT_TRUE(cut.clusters.empty());
  EXPECT_EQ(cut.radiance, glm::vec3(0));
}

TEST(StochasticCut, RefusesWhatACutSelectorRefuses) {
  const LightTree tree = two_pairs();
  EXPECT_THROW(StochasticCutSelector(tree, {.max_size = 0}), InputError);
}

TEST(RandomNumber, IsBelowOne) {
  for (std::uint32_t node = 0; node < 10000; ++node) {
    const double u = random_number(1, 2, node);
    EXPECT_GE(u, 0);
    EXPECT_LT(u, 1);
  }
}

} // namespace
} // namespace lightcuts
