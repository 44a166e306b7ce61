// SPDX-License-Identifier: MIT
#include <oracle/properties/sampling/statistics.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace lightcuts::oracle {
namespace {

// As check_draws() has them.
constexpr double overlooked = 0.001;
constexpr std::uint64_t most_draws = 4'000'000;
/// A test's share of 1e-6: of 10 000 cases with 12 tests each.
double share_of_run() { return sidak(sidak(1e-6, 10'000), 12); }

// ---- exact probabilities

/// P(X >= from), X binomial: to within 1e-11 of itself for n up to 10^7.
long double upper_tail(std::uint64_t n, long double p, std::uint64_t from) {
  if (from == 0) return 1;
  if (from > n) return 0;
  const auto trials = static_cast<long double>(n);
  // Where terms still grow, those below are fewer or fall off faster.
  if (static_cast<long double>(from) < trials * p) {
    long double below = 0;
    for (std::uint64_t k = from; k-- > 0;) {
      const auto j = static_cast<long double>(k);
      const long double term =
          std::exp(std::lgamma(trials + 1) - std::lgamma(j + 1) - std::lgamma(trials - j + 1) +
                   j * std::log(p) + (trials - j) * std::log1p(-p));
      below += term;
      if (term < below * 1e-20L || term == 0) break;
    }
    return 1 - below;
  }
  const auto first = static_cast<long double>(from);
  long double term =
      std::exp(std::lgamma(trials + 1) - std::lgamma(first + 1) - std::lgamma(trials - first + 1) +
               first * std::log(p) + (trials - first) * std::log1p(-p));
  long double sum = 0;
  for (std::uint64_t k = from; k <= n && term > sum * 1e-20L; ++k) {
    sum += term;
    const auto j = static_cast<long double>(k);
    term *= (trials - j) / (j + 1) * (p / (1 - p));
  }
  return sum;
}

/// P(X <= to).
long double lower_tail(std::uint64_t n, long double p, std::uint64_t to) {
  return to >= n ? 1 : upper_tail(n, 1 - p, n - to);
}

/// P(|X/n - centre| > deviation), X binomial with this p.
long double outside(std::uint64_t n, long double p, long double centre, long double deviation) {
  const auto trials = static_cast<long double>(n);
  const long double above = std::floor(trials * (centre + deviation)) + 1;
  const long double below = std::ceil(trials * (centre - deviation)) - 1;
  long double sum = above > trials ? 0 : upper_tail(n, p, std::uint64_t(above));
  if (below >= 0) sum += lower_tail(n, p, std::uint64_t(below));
  return sum;
}

/// What a count of experiments, each with a probability of at most p, exceeds with a probability
/// of at most 1e-9.
std::uint64_t most_of(std::uint64_t experiments, double p) {
  std::uint64_t k = 0;
  while (upper_tail(experiments, p, k + 1) > 1e-9L) ++k;
  return k;
}

TEST(BinomialTail, HasKnownValues) {
  EXPECT_NEAR(double(upper_tail(10, 0.5L, 8)), 56.0 / 1024, 1e-15);
  EXPECT_NEAR(double(upper_tail(10, 0.5L, 3)), 968.0 / 1024, 1e-15);
  EXPECT_NEAR(double(lower_tail(10, 0.5L, 2)), 56.0 / 1024, 1e-15);
  EXPECT_NEAR(double(lower_tail(3, 0.1L, 0)), 0.729, 1e-15);
  EXPECT_NEAR(double(outside(10, 0.5L, 0.5L, 0.25L)), 112.0 / 1024, 1e-15);
  EXPECT_EQ(most_of(2000, 0), 0U);
}

// ---- sidak

TEST(Sidak, IsTheWholeRateForOneTest) {
  for (const double rate : {0.5, 0.05, 1e-6, 1e-300})
    EXPECT_NEAR(sidak(rate, 1), rate, rate * 1e-15);
}

TEST(Sidak, HasKnownValues) {
  EXPECT_NEAR(sidak(0.19, 2), 0.1, 1e-15);
  EXPECT_NEAR(sidak(0.875, 3), 0.5, 1e-15);
  EXPECT_NEAR(sidak(0.05, 10), 0.005116196891823743, 1e-15);
}

TEST(Sidak, GivesTheRateBackToAllTestsTogether) {
  for (const double rate : {0.3, 0.01, 1e-6, 1e-12})
    for (const std::uint64_t tests : {2ULL, 12ULL, 120'000ULL, 1ULL << 40}) {
      const long double one = sidak(rate, tests);
      const long double all = -std::expm1(static_cast<long double>(tests) * std::log1p(-one));
      EXPECT_NEAR(double(all), rate, rate * 1e-14) << rate << ' ' << tests;
    }
}

// 1 - (1 - rate)^(1/tests), computed so, would be 0.
TEST(Sidak, DoesNotCancel) {
  EXPECT_NEAR(sidak(1e-6, 1ULL << 60) * 0x1p60, 1.0000005000003333e-6, 1e-20);
  EXPECT_NEAR(sidak(1e-30, 1000), 1e-33, 1e-47);
  EXPECT_NEAR(sidak(1e-300, 8), 1.25e-301, 1e-315);
}

TEST(Sidak, HasNoShareOfNothingAndAllOfOne) {
  EXPECT_EQ(sidak(0, 5), 0);
  EXPECT_EQ(sidak(1, 5), 1);
}

// Tests that share draws are not independent. The sum of their shares is more than the rate by no
// more than half its square.
TEST(Sidak, OfDependentTestsHardlyExceedsTheRate) {
  for (const double rate : {0.01, 1e-6})
    for (const std::uint64_t tests : {1ULL, 12ULL, 120'000ULL, 1ULL << 40})
      EXPECT_LE(sidak(rate, tests) * double(tests), rate * (1 + rate / 2 * 1.01) * (1 + 1e-14));
}

// ---- bernstein_deviation

const Spread some_spreads[] = {{0.25, 0.5}, {1e-3, 1}, {4, 2}, {0, 1}, {1e-20, 1e-3}, {1e9, 1e7}};

TEST(BernsteinDeviation, SolvesItsInequality) {
  for (const Spread& s : some_spreads)
    for (const std::uint64_t n : {1ULL, 100ULL, 4'000'000ULL})
      for (const double rate : {0.5, 1e-3, 1e-12}) {
        const double t = bernstein_deviation(s, n, rate);
        const double exponent = double(n) * t * t / (2 * s.variance + 2 * s.range * t / 3);
        EXPECT_NEAR(exponent, std::log(2 / rate), std::log(2 / rate) * 1e-12)
            << s.variance << ' ' << s.range << ' ' << n << ' ' << rate;
      }
}

TEST(BernsteinDeviation, OfWhatDoesNotSpreadIsNothing) {
  EXPECT_EQ(bernstein_deviation({0, 0}, 1, 1e-6), 0);
}

TEST(BernsteinDeviation, IsMonotone) {
  const Spread s{0.2, 0.7};
  for (const std::uint64_t n : {1ULL, 10ULL, 1'000'000ULL})
    for (const double rate : {0.1, 1e-6, 1e-12}) {
      const double t = bernstein_deviation(s, n, rate);
      EXPECT_LT(bernstein_deviation(s, n + 1, rate), t);
      EXPECT_GT(bernstein_deviation(s, n, rate / 2), t);
      EXPECT_GT(bernstein_deviation({s.variance * 1.1, s.range}, n, rate), t);
      EXPECT_GT(bernstein_deviation({s.variance, s.range * 1.1}, n, rate), t);
    }
}

TEST(BernsteinDeviation, ScalesWithTheNumber) {
  EXPECT_NEAR(bernstein_deviation({9 * 0.2, 3 * 0.7}, 50, 1e-6),
              3 * bernstein_deviation({0.2, 0.7}, 50, 1e-6), 1e-14);
}

Spread of_bernoulli(double p) { return {p * (1 - p), std::max(p, 1 - p)}; }

// No sampling: the false-alarm rate itself, at that of a run and of one test in it, too.
TEST(BernsteinDeviation, IsExceededByABinomialAtNoMoreThanTheRate) {
  for (const double p : {0.5, 0.3, 0.1, 0.01, 1e-3, 1e-5, 0.999})
    for (const std::uint64_t n : {1ULL, 10ULL, 1000ULL, 100'000ULL, 4'000'000ULL})
      for (const double rate : {0.1, 1e-2, 1e-3, 1e-6, share_of_run()}) {
        const double t = bernstein_deviation(of_bernoulli(p), n, rate);
        EXPECT_LE(outside(n, p, p, t), rate) << p << ' ' << n << ' ' << rate;
      }
}

// Not by a wide margin, or the test would notice little.
TEST(BernsteinDeviation, IsNotMuchMoreThanItTakes) {
  for (const double p : {0.5, 0.1, 0.01})
    for (const double rate : {1e-2, 1e-3, 1e-6, share_of_run()}) {
      const double t = bernstein_deviation(of_bernoulli(p), 1'000'000, rate);
      EXPECT_GT(outside(1'000'000, p, p, t / 1.4), rate) << p << ' ' << rate;
    }
}

// ---- draws_to_notice

TEST(DrawsToNotice, AreTheFewestThatSuffice) {
  for (const double bias : {0.1, 0.01, 0.003})
    for (const Spread& s : {Spread{0.25, 0.5}, Spread{1e-3, 1}, Spread{0, 1}, Spread{0.04, 0.2}}) {
      const auto n = draws_to_notice(bias, s, share_of_run(), overlooked, 1ULL << 40);
      ASSERT_TRUE(n.has_value());
      ASSERT_GT(*n, 1U);
      const auto both = [&](std::uint64_t draws) {
        return bernstein_deviation(s, draws, share_of_run()) +
               bernstein_deviation(s, draws, overlooked);
      };
      EXPECT_LE(both(*n), bias);
      EXPECT_GT(both(*n - 1), bias);
    }
}

TEST(DrawsToNotice, AreNoMoreThanTheMost) {
  const Spread s{0.04, 0.5};
  const auto n = draws_to_notice(0.01, s, share_of_run(), overlooked, most_draws);
  ASSERT_TRUE(n.has_value());
  EXPECT_EQ(draws_to_notice(0.01, s, share_of_run(), overlooked, *n), n);
  EXPECT_EQ(draws_to_notice(0.01, s, share_of_run(), overlooked, *n - 1), std::nullopt);
  EXPECT_EQ(draws_to_notice(0.01, s, share_of_run(), overlooked, 0), std::nullopt);
  EXPECT_EQ(draws_to_notice(0, s, share_of_run(), overlooked, most_draws), std::nullopt);
}

TEST(DrawsToNotice, AreOneIfNothingSpreads) {
  EXPECT_EQ(draws_to_notice(0.01, {0, 0}, share_of_run(), overlooked, most_draws), 1U);
}

// ---- false alarms and power, demonstrated

/// A random estimate with finitely many outcomes.
struct Estimate {
  const char* name;
  std::vector<double> p, value;

  [[nodiscard]] double mean() const {
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) sum += p[i] * value[i];
    return sum;
  }
  [[nodiscard]] Spread spread() const {
    Spread s;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double off = value[i] - mean();
      s.variance += p[i] * off * off;
      s.range = std::max(s.range, std::abs(off));
    }
    return s;
  }
  /// Mean of n draws: how often each outcome comes is multinomial.
  template <class Random>
  [[nodiscard]] double mean_of(std::uint64_t n, Random& random) const {
    std::uint64_t left = n;
    double rest = 1, sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      std::uint64_t count = left;
      if (i + 1 < p.size() && left > 0)
        count = std::binomial_distribution<std::uint64_t>(left, std::min(p[i] / rest, 1.0))(random);
      sum += double(count) * value[i];
      left -= count;
      rest -= p[i];
    }
    return sum / double(n);
  }
  /// With all estimates as many times as large.
  [[nodiscard]] Estimate scaled(double by) const {
    Estimate other = *this;
    for (double& v : other.value) v *= by;
    return other;
  }
  /// With so much more of the mean in each estimate.
  [[nodiscard]] Estimate shifted(double by) const {
    Estimate other = *this;
    for (double& v : other.value) v += by * mean();
    return other;
  }
  /// With the last two outcomes' probabilities so that the mean is as many times as large.
  [[nodiscard]] Estimate redrawn(double by) const {
    Estimate other = *this;
    const std::size_t last = p.size() - 1;
    const double moved = (by - 1) * mean() / (value[last] - value[last - 1]);
    other.p[last] += moved;
    other.p[last - 1] -= moved;
    return other;
  }
};

void PrintTo(const Estimate& e, std::ostream* out) { *out << e.name; }

class Estimates : public testing::TestWithParam<Estimate> {};

// Bernoulli numbers of less and less chance, then lotteries as of clusters: symmetric, with rare
// large estimates, with rare small ones, with many outcomes.
INSTANTIATE_TEST_SUITE_P(
    Statistics, Estimates,
    testing::Values(Estimate{"half", {0.5, 0.5}, {0, 1}}, Estimate{"tenth", {0.9, 0.1}, {0, 1}},
                    Estimate{"hundredth", {0.99, 0.01}, {0, 1}},
                    Estimate{"thousandth", {0.999, 0.001}, {0, 1}},
                    Estimate{"two_lights", {0.3, 0.7}, {1.2, 0.9}},
                    Estimate{"rarely_bright", {0.001, 0.499, 0.5}, {20, 1, 1.1}},
                    Estimate{"rarely_dark", {0.001, 0.499, 0.5}, {0, 1, 1.2}},
                    Estimate{"many", {0.05, 0.15, 0.2, 0.1, 0.3, 0.2}, {2, 1, 0, 3, 1.5, 1.1}}),
    [](const auto& one) { return one.param.name; });

/// How many of so many experiments deviate by more than is allowed at this rate.
template <class Random>
std::uint64_t alarms(const Estimate& drawn, double expected, const Spread& spread, std::uint64_t n,
                     double rate, int experiments, Random& random) {
  const double allowed = bernstein_deviation(spread, n, rate);
  std::uint64_t count = 0;
  for (int i = 0; i < experiments; ++i)
    count += std::abs(drawn.mean_of(n, random) - expected) > allowed ? 1 : 0;
  return count;
}

// 1e-6 is too rare to be watched, but Bernstein's inequality holds for every rate alike, so that
// what shows at 1e-2 and 1e-3 is what there is to see; the exact tails above reach 1e-6 and beyond.
TEST_P(Estimates, RaiseFalseAlarmsAtNoMoreThanTheRate) {
  std::mt19937_64 random(20260101);
  const Estimate& e = GetParam();
  for (const auto& [rate, experiments] : {std::pair{1e-2, 10'000}, std::pair{1e-3, 20'000}})
    for (const std::uint64_t n : {100ULL, 100'000ULL})
      EXPECT_LE(alarms(e, e.mean(), e.spread(), n, rate, experiments, random),
                most_of(std::uint64_t(experiments), rate))
          << rate << ' ' << n;
}

/// Whether one percent of the mean shows in no more than the most draws, and in how many.
std::optional<std::uint64_t> draws_for_a_percent(const Estimate& e,
                                                 std::uint64_t most = most_draws) {
  return draws_to_notice(0.01 * e.mean(), e.spread(), share_of_run(), overlooked, most);
}

TEST_P(Estimates, ShowABiasOfOnePercent) {
  constexpr int experiments = 2000;
  std::mt19937_64 random(20260102);
  const Estimate& e = GetParam();
  const auto n = draws_for_a_percent(e, 1ULL << 40);
  ASSERT_TRUE(n.has_value());
  const auto count = [&](const Estimate& drawn) {
    return alarms(drawn, e.mean(), e.spread(), *n, share_of_run(), experiments, random);
  };
  EXPECT_EQ(count(e), 0U);
  const std::uint64_t enough = experiments - most_of(experiments, overlooked);
  for (const double by : {1.01, 0.99}) {
    EXPECT_NEAR(e.redrawn(by).mean(), by * e.mean(), 1e-12);
    EXPECT_GE(count(e.scaled(by)), enough) << by;
    EXPECT_GE(count(e.shifted(by - 1)), enough) << by;
    EXPECT_GE(count(e.redrawn(by)), enough) << by;
  }
}

// Without sampling, for a mean that is a probability.
TEST(Power, OverABiasOfOnePercentIsAtLeastStated) {
  for (const double p : {0.9, 0.5, 0.2, 0.1, 0.01, 0.001}) {
    const Estimate e{"", {1 - p, p}, {0, 1}};
    const auto n = draws_for_a_percent(e, 1ULL << 40);
    ASSERT_TRUE(n.has_value());
    const double allowed = bernstein_deviation(e.spread(), *n, share_of_run());
    EXPECT_LE(outside(*n, p, p, allowed), share_of_run()) << p;
    for (const double by : {1.01, 0.99})
      EXPECT_GE(outside(*n, by * p, p, allowed), 1 - overlooked) << p << ' ' << by;
  }
}

// Nor does it take many more draws than it has to.
TEST(Power, IsNotThatOfHalfTheDraws) {
  for (const double p : {0.9, 0.5, 0.1, 0.01}) {
    const Estimate e{"", {1 - p, p}, {0, 1}};
    const std::uint64_t n = draws_for_a_percent(e, 1ULL << 40).value() / 2;
    const double allowed = bernstein_deviation(e.spread(), n, share_of_run());
    EXPECT_LT(outside(n, 1.01 * p, p, allowed), 1 - overlooked) << p;
  }
}

// What spreads so much that the stated power is out of reach is not judged at all.
TEST(Power, IsNotClaimedOfWhatIsTooRare) {
  EXPECT_TRUE(draws_for_a_percent({"", {0.5, 0.5}, {0, 1}}).has_value());
  EXPECT_FALSE(draws_for_a_percent({"", {0.999, 0.001}, {0, 1}}).has_value());
}

} // namespace
} // namespace lightcuts::oracle
