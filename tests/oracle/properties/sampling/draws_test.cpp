// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <oracle/cases/case.h>
#include <oracle/cases/random_case.h>
#include <oracle/cases/random_pixels.h>
#include <oracle/mutants/mutants.h>
#include <oracle/properties/sampling/statistics.h>
#include <tests/oracle/support/made_draws.h>

namespace lightcuts::oracle {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

// ---- the library

TEST(SamplingProperties, HoldForTheLibrary) {
  std::array<std::uint64_t, 3> judged{};
  for (std::uint64_t i = 0; i < 12; ++i) {
    const Lottery lottery(i);
    ASSERT_TRUE(lottery.on.draws) << i;
    const Tally tally = draws_of(own(lottery.judged), lottery.judged, lottery.on.cut);
    EXPECT_THAT(violated(tally), IsEmpty()) << i;
    for (std::size_t k = 0; k < judged.size(); ++k)
      judged[k] += tally[random_properties[k]].cases > 0 ? 1 : 0;
    EXPECT_THAT(violated(probabilities_of(own(lottery.judged), lottery.judged)), IsEmpty());
  }
  for (const std::uint64_t count : judged) EXPECT_GE(count, 6U);
}

TEST_F(FourLights, AreDrawnRightByTheLibrary) {
  for (const std::uint32_t size : {1U, 2U, 3U, 4U}) {
    const Tally tally = draws_of(own(judged), judged, cut_of(size));
    EXPECT_THAT(violated(tally), IsEmpty()) << size;
    EXPECT_EQ(tally[Property::stochastic_is_unbiased].cases, 3U);
    // The same cut; successive queries, if there is anything to draw; each two clusters.
    EXPECT_EQ(tally[Property::draws_are_independent].cases,
              1 + (size < 4 ? 1 : 0) + std::uint64_t(size) * (size - 1) / 2);
  }
}

// ---- bias

// The stated power, through all of the check: 20 independent chances to overlook it, each below
// 0.001 in theory, and far below where Bernstein's inequality has room to spare.
TEST_F(FourLights, ConvictABiasOfOnePercentWhateverIsDrawn) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    for (const double by : {1.01, 0.99})
      EXPECT_THAT(
          violated(draws_of(scaled(by), judged, cut_of(2), {.cases = 10'000, .seed = seed})),
          Contains(Property::stochastic_is_unbiased))
          << by << ' ' << seed;
}

TEST(SamplingProperties, ConvictABiasOfOnePercentInRandomCases) {
  int convicted = 0;
  for (std::uint64_t i = 0; i < 6; ++i)
    for (const double by : {1.01, 0.99}) {
      const Lottery lottery(i);
      const Tally tally = draws_of(MadeDraws(lottery.judged.tree, {.clusters =
                                                                       [by](Clusters& all, auto) {
                                                                         for (CutCluster& c : all)
                                                                           c.estimate *= by;
                                                                       }}),
                                   lottery.judged, lottery.on.cut);
      if (random_cases(tally) == 0) continue;
      EXPECT_THAT(violated(tally), Contains(Property::stochastic_is_unbiased)) << i;
      ++convicted;
    }
  EXPECT_GE(convicted, 8);
}

// The power is stated for the channel that is brightest; the others spread more here.
TEST_F(FourLights, ConvictABiasOfAnyOneChannel) {
  for (const auto& [channel, by] : {std::pair{0, 1.03}, std::pair{1, 1.03}, std::pair{2, 1.01}}) {
    const auto bias = [c = channel, f = by](Clusters& all, std::uint64_t) {
      for (CutCluster& one : all) one.estimate[c] *= f;
    };
    const Tally tally = draws_of(with_clusters(bias), judged, cut_of(2));
    EXPECT_EQ(tally[Property::stochastic_is_unbiased].violations, 1U) << channel;
  }
}

// What is allowed is about half of what is noticed.
TEST_F(FourLights, NeedNotConvictATenthOfAPercent) {
  for (const double by : {1.001, 0.999}) {
    const Tally tally = draws_of(scaled(by), judged, cut_of(2));
    EXPECT_THAT(violated(tally), IsEmpty()) << by;
    EXPECT_GT(tally[Property::stochastic_is_unbiased].worst_ratio, 0.01);
  }
}

TEST_F(FourLights, ConvictWhatIsNoNumber) {
  EXPECT_THAT(violated(draws_of(scaled(not_a_number), judged, cut_of(2))),
              Contains(Property::stochastic_is_unbiased));
}

// ---- false alarms

// At 0.05 for all tests of a case, more than 32 alarms in 200 cases have a probability below 1e-8.
TEST_F(FourLights, RaiseNoMoreFalseAlarmsThanStated) {
  int alarms = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Tally tally =
        draws_of(own(judged), judged, cut_of(2), {.false_alarms = 0.05, .seed = seed});
    ASSERT_GT(random_cases(tally), 0U);
    alarms += tally.violations() > 0 ? 1 : 0;
  }
  EXPECT_LE(alarms, 32);
}

const DrawConfig some_configs[] = {
    {}, {.cases = 10'000}, {.false_alarms = 1e-3}, {.false_alarms = 1e-2, .cases = 7}};

// The rate is shared, and the draws are as many as the power takes.
TEST_F(FourLights, AreDrawnAsOftenAsStated) {
  for (const DrawConfig& config : some_configs)
    for (const std::uint32_t size : {1U, 2U}) {
      MadeDraws tree = with({});
      (void)draws_of(tree, judged, cut_of(size), config);
      EXPECT_NEAR(double(tree.draws() - 1), double(draws(cut_of(size), config)), 1);
    }
}

// Draws that always deviate by as much show what is allowed.
TEST_F(FourLights, AreAllowedTheDeviationOfTheSharedRate) {
  for (const DrawConfig& config : some_configs) {
    const CutConfig cut = cut_of(2);
    const std::uint64_t n = draws(cut, config);
    const auto of = nodes(cut);
    const Spread a = spread(of[0]), b = spread(of[1]);
    const double allowed =
        bernstein_deviation({a.variance + b.variance, a.range + b.range}, n, rate(2, config));
    const double relative = allowed / mean(0).z;
    EXPECT_GT(relative, 0);
    EXPECT_LT(relative, 0.01);
    for (const double of_allowed : {0.99, 1.01}) {
      const auto off = [&](Clusters& all, std::uint64_t) {
        for (CutCluster& c : all)
          c.estimate = mean(c.node) * glm::dvec3(1, 1, 1 + of_allowed * relative);
      };
      const Tally tally = draws_of(with_clusters(off), judged, cut, config);
      const PropertyCount& count = tally[Property::stochastic_is_unbiased];
      EXPECT_NEAR(count.worst_ratio, of_allowed, 1e-3);
      EXPECT_EQ(count.violations > 0, of_allowed > 1);
    }
    const double covariance =
        bernstein_deviation({a.variance * b.variance, a.range * b.range}, n, rate(2, config));
    for (const double of_allowed : {0.99, 1.01}) {
      const double each = std::sqrt(of_allowed * covariance);
      const auto off = [&](Clusters& all, std::uint64_t) {
        all[0].estimate = mean(all[0].node) + glm::dvec3(0, 0, each);
        all[1].estimate = mean(all[1].node) - glm::dvec3(0, 0, each);
      };
      const Tally tally = draws_of(with_clusters(off), judged, cut, config);
      EXPECT_NEAR(tally[Property::draws_are_independent].worst_ratio, of_allowed, 1e-3);
      EXPECT_EQ(tally[Property::draws_are_independent].violations, of_allowed > 1 ? 1U : 0U);
      EXPECT_EQ(tally[Property::stochastic_is_unbiased].violations, 0U);
    }
  }
}

TEST_F(FourLights, AreAllowedTheDeviationOfTheSharedRateInFrequencies) {
  for (const DrawConfig& config : some_configs) {
    const CutConfig cut = cut_of(2);
    double worst = 0;
    std::vector<std::uint32_t> asked = nodes(cut);
    asked.push_back(0);
    for (const std::uint32_t node : asked) {
      const std::span<const std::uint32_t> lights = judged.topology.all_lights(node);
      // sample(0) draws one of them with certainty.
      const DrawnLight first = own(judged).sample(node, judged.point, 0);
      const double p = first.probability;
      const double allowed = bernstein_deviation({p * (1 - p), std::max(p, 1 - p)},
                                                 draws(cut, config), rate(2, config));
      worst = std::max(worst, (1 - p) / allowed);
    }
    const Tally tally = draws_of(with({.number = [](double) { return 0.0; }}), judged, cut, config);
    EXPECT_NEAR(tally[Property::draws_follow_probabilities].worst_ratio, worst, worst * 1e-3);
  }
}

TEST_F(FourLights, AreNotJudgedByFewerDrawsThanItTakes) {
  const std::uint64_t n = draws(cut_of(2), {});
  EXPECT_EQ(random_cases(draws_of(own(judged), judged, cut_of(2), {.max_draws = n - 2})), 0U);
  EXPECT_GT(random_cases(draws_of(own(judged), judged, cut_of(2), {.max_draws = n + 2})), 0U);
  MadeDraws biased = scaled(2);
  EXPECT_EQ(random_cases(draws_of(biased, judged, cut_of(2), {.max_draws = 100})), 0U);
  EXPECT_EQ(biased.draws(), 1U);
}

TEST(SamplingProperties, SayNothingOfDarkness) {
  const JudgedPoint judged(four_lights(), diffuse_point(), {0, 0, 0, 0});
  EXPECT_EQ(random_cases(draws_of(own(judged), judged, cut_of(2))), 0U);
}

// ---- frequencies

TEST_F(FourLights, ConvictFrequenciesThatAreAFewPercentOff) {
  const std::vector<std::function<double(double)>> numbers{
      [](double u) { return 0.95 * u; }, [](double u) { return 0.05 + 0.95 * u; },
      [](double u) { return std::pow(u, 1.2); }};
  for (const auto& number : numbers) {
    const Tally tally = draws_of(with({.number = number}), judged, cut_of(2));
    EXPECT_THAT(violated(tally), ElementsAre(Property::draws_follow_probabilities));
    EXPECT_GT(tally[Property::draws_follow_probabilities].worst_ratio, 1);
  }
}

// What the deviations at the two rates sum to is overlooked with a probability below 0.001.
TEST_F(FourLights, ConvictFrequenciesThatAreOffByWhatIsStatedWhateverIsDrawn) {
  const std::uint64_t n = draws(cut_of(2), {});
  const Spread widest{0.25, 1};
  const double noticed =
      bernstein_deviation(widest, n, rate(2, {})) + bernstein_deviation(widest, n, 0.001);
  ASSERT_LT(noticed, 0.05);
  for (const std::uint32_t node : nodes(cut_of(2))) {
    const double p = own(judged).sample(node, judged.point, 0).probability;
    ASSERT_LT(p + noticed, 1);
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      // Maps [0, p + noticed) onto the first light's [0, p).
      const auto number = [&](double u) { return u < p + noticed ? u * p / (p + noticed) : u; };
      EXPECT_THAT(violated(draws_of(with({.number = number}), judged, cut_of(2), {.seed = seed})),
                  Contains(Property::draws_follow_probabilities));
    }
  }
}

TEST_F(FourLights, ConvictASamplerThatDrawsNothingNowAndThen) {
  int count = 0;
  const Changes changes{.drawn = [&](auto, DrawnLight& d) {
    if (++count % 20 == 0) d.probability = 0;
  }};
  EXPECT_THAT(violated(draws_of(with(changes), judged, cut_of(2))),
              ElementsAre(Property::draws_follow_probabilities));
}

// ---- independence

double uniform(std::uint64_t query, std::uint32_t index) {
  return double(hashed(query, index) >> 11) * 0x1p-53;
}

TEST_F(FourLights, ConvictDrawsThatDependOnEachOther) {
  using Other = std::function<double(std::uint64_t query)>;
  const auto same = [](std::uint64_t query) { return uniform(query, 0); };
  const std::vector<std::pair<Other, bool>> others{
      {[](std::uint64_t query) { return uniform(query, 1); }, true},
      {same, false},
      {[&](std::uint64_t query) { return 1 - 0x1p-53 - same(query); }, false},
      {[](std::uint64_t query) { return uniform(query, query % 5 == 0 ? 0 : 1); }, false}};
  for (const auto& [other, independent] : others) {
    const auto lights = [&](Clusters& all, std::uint64_t query) {
      all[0].estimate = lit(all[0].node, same(query));
      all[1].estimate = lit(all[1].node, other(query));
    };
    const Tally tally = draws_of(with_clusters(lights), judged, cut_of(2));
    EXPECT_EQ(tally[Property::draws_are_independent].cases, 3U);
    EXPECT_EQ(tally[Property::draws_are_independent].violations, independent ? 0U : 1U);
  }
}

/// Now and then draws from another cut; each of them is unbiased.
class FickleCuts : public OwnTree {
public:
  FickleCuts(const LightTree& tree, std::uint64_t period, std::uint32_t size)
      : OwnTree(tree), other_(tree), period_(period), size_(size) {}
  Cut draw(const ShadingPoint& point, const CutConfig& config, std::uint64_t query,
           const Visible& visible) override {
    if (query % period_ != 1) return OwnTree::draw(point, config, query, visible);
    return other_.draw(point, cut_of(size_), query, visible);
  }

private:
  OwnTree other_;
  std::uint64_t period_;
  std::uint32_t size_;
};

TEST_F(FourLights, ConvictACutThatDependsOnTheQuery) {
  for (const std::uint64_t period : {2U, 1000U})
    for (const std::uint32_t size : {1U, 3U}) {
      const Tally tally = draws_of(FickleCuts(judged.tree, period, size), judged, cut_of(2));
      EXPECT_THAT(violated(tally), ElementsAre(Property::draws_are_independent));
      EXPECT_EQ(tally[Property::stochastic_is_unbiased].cases, 0U);
    }
}

TEST_F(FourLights, ConvictOtherClustersOfTheSameNumber) {
  const auto swap = [](Clusters& all, std::uint64_t query) {
    if (query % 2 == 1) std::swap(all[0], all[1]);
  };
  const Tally tally = draws_of(with_clusters(swap), judged, cut_of(2));
  EXPECT_THAT(violated(tally), ElementsAre(Property::draws_are_independent));
  EXPECT_EQ(tally[Property::stochastic_is_unbiased].cases, 0U);
}

// ---- mutants

TEST(SamplingMutants, AreConvictedOfWhatIsWrong) {
  const std::pair<const char*, Property> wrong[] = {
      {"random-number-lost", Property::threads_agree},
      {"one-number-for-all", Property::draws_are_independent},
      {"resampled-between", Property::stochastic_is_unbiased},
      {"dead-branch", Property::contributing_lights_are_drawn},
      {"inverse-probability", Property::draws_follow_probabilities},
      {"pdf-mismatch", Property::draws_state_their_probability}};
  for (const auto& [name, property] : wrong) {
    const Mutant* mutant = mutant_named(name);
    ASSERT_NE(mutant, nullptr) << name;
    const bool by_draws = std::find(random_properties.begin(), random_properties.end(), property) !=
                          random_properties.end();
    std::uint64_t violations = 0;
    for (std::uint64_t i = 0; i < (by_draws ? 8U : 300U) && violations == 0; ++i) {
      Tally tally;
      check_case(*mutant->subject(), random_case(1, by_draws ? 500 * i + 499 : i), 0, tally,
                 property);
      violations = tally[property].violations;
    }
    EXPECT_GT(violations, 0U) << name;
  }
}

// As plug-ins are: sample() and probability(), and no more.
TEST_F(FourLights, AreDrawnAsOftenAsTheirProbabilitiesSayWithoutRandomCuts) {
  constexpr Parts single = library_parts | only(Part::sampling);
  const auto of = [&](MadeDraws tree) {
    return judged_at(
        tree, judged,
        [&](const Judge& judge, const PointAnswers& answers) {
          judge.draws(answers, cut_of(3), {});
        },
        single);
  };
  const Tally right = of(with({}));
  EXPECT_THAT(violated(right), IsEmpty());
  // Of the root and of its children.
  EXPECT_EQ(right[Property::draws_follow_probabilities].cases, 4U + 2 + 2);
  EXPECT_EQ(right[Property::stochastic_is_unbiased].cases, 0U);
  const Tally bent = of(with({.number = [](double u) { return u * u; }}));
  EXPECT_THAT(violated(bent), ElementsAre(Property::draws_follow_probabilities));
}

} // namespace
} // namespace lightcuts::oracle
