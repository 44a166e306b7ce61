// SPDX-License-Identifier: MIT
#include <viz/model/layers/histogram.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tests/support/float_limits.h>

namespace lightcuts::viz {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Histogram, CountsTheValuesOfEachBin) {
  const std::vector<float> values{0, 0.5F, 1, 1.5F, 2, 2.5F, 3, 4};
  const Histogram h = histogram_of(values, {.lo = 0, .hi = 4, .bins = 4});
  EXPECT_THAT(h.counts, ElementsAre(2, 2, 2, 2)) << "an edge is the next bin's, but for the last";
}

TEST(Histogram, CountsWhatIsInNoBinApart) {
  const std::vector<float> values{nan, inf, inf, -inf, -1, 5, 6, 7, 2};
  const Histogram h = histogram_of(values, {.lo = 1, .hi = 4, .bins = 1});
  EXPECT_EQ(h.nan, 1U);
  EXPECT_EQ(h.positive_infinite, 2U);
  EXPECT_EQ(h.negative_infinite, 1U);
  EXPECT_EQ(h.below, 1U);
  EXPECT_EQ(h.above, 3U);
  EXPECT_THAT(h.counts, ElementsAre(1));
}

TEST(Histogram, HasBinsOfEqualRatiosOnALogarithmicScale) {
  const std::vector<float> values{0.1F, 0.5F, 1, 5, 10, 99, 100, 0, -3};
  const Histogram h =
      histogram_of(values, {.lo = 0.0999, .hi = 100, .bins = 3, .logarithmic = true});
  EXPECT_THAT(h.counts, ElementsAre(2, 2, 3));
  EXPECT_EQ(h.below, 2U);
}

TEST(Histogram, PutsValuesThatAreAllAlikeInTheFirstBin) {
  const std::vector<float> values{3, 3, 3};
  for (const bool logarithmic : {false, true})
    EXPECT_THAT(histogram_of(values, range_of(values, 2, logarithmic)).counts, ElementsAre(3, 0));
}

void expect_by_edges(std::vector<float> values, const HistogramRange& range) {
  for (std::uint32_t i = 1; i < range.bins; ++i) values.push_back(float(range.edge(i)));
  const Histogram h = histogram_of(values, range);
  for (std::uint32_t i = 0; i < range.bins; ++i) {
    const bool last = i + 1 == range.bins;
    const auto within = std::count_if(values.begin(), values.end(), [&](float v) {
      return v >= range.edge(i) && (last ? v <= range.edge(i + 1) : v < range.edge(i + 1));
    });
    EXPECT_EQ(h.counts[i], within) << "bin " << i;
  }
}

TEST(Histogram, GoesByTheEdgesItStates) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> exponent(-30, 30);
  std::vector<float> values(20000);
  for (float& value : values) value = std::exp(exponent(random));
  for (const bool logarithmic : {false, true})
    expect_by_edges(values, range_of(values, 777, logarithmic));
  // Edges that are floats themselves, where quotients and logarithms are a little off.
  expect_by_edges({}, {.lo = 1, .hi = 0x1p60, .bins = 60, .logarithmic = true});
  expect_by_edges({}, {.lo = 1e-3, .hi = 1e13, .bins = 16, .logarithmic = true});
  expect_by_edges({}, {.lo = 0, .hi = 100, .bins = 100});
  expect_by_edges({}, {.lo = 0x1p-60, .hi = 0x1p60, .bins = 120, .logarithmic = true});
}

TEST(Histogram, RangesFromTheSmallestToTheLargestFiniteValue) {
  const std::vector<float> values{nan, inf, -inf, -2, 0, 3, 0.5F};
  EXPECT_EQ(range_of(values, 9, false).lo, -2);
  EXPECT_EQ(range_of(values, 9, false).hi, 3);
  EXPECT_EQ(range_of(values, 9, true).lo, 0.5);
  EXPECT_EQ(range_of(values, 9, true).hi, 3);
  EXPECT_EQ(range_of({}, 9, false).hi, 1);
  EXPECT_EQ(range_of({}, 9, true).lo, 1);
  EXPECT_EQ(range_of({}, 9, true).hi, 10);
}

TEST(Histogram, GivesEachBinEquallyManyWholeNumbers) {
  for (int lo = 1; lo < 50; lo += 7)
    for (int hi = lo + 1; hi < lo + 300; ++hi) {
      const HistogramRange range = whole_number_range(lo, hi, 40);
      ASSERT_LE(range.bins, 40U);
      std::vector<float> values;
      for (int v = lo; v < range.hi; ++v) values.push_back(float(v));
      ASSERT_GE(values.back(), float(hi));
      const Histogram h = histogram_of(values, range);
      const double each = (range.hi - range.lo) / range.bins;
      ASSERT_LT(range.hi - hi, each) << "no bin is there for nothing";
      for (const std::uint64_t n : h.counts) ASSERT_EQ(double(n), each) << lo << " to " << hi;
    }
}

TEST(Histogram, PutsOneWholeNumberInTheMiddle) {
  const Histogram h = histogram_of(std::vector<float>{7, 7}, whole_number_range(7, 7, 40));
  EXPECT_THAT(h.counts, ElementsAre(0, 2, 0));
}

TEST(Percentiles, AreValuesThatSoManyPercentAreNotAbove) {
  std::vector<float> values(100);
  std::iota(values.begin(), values.end(), 1.0F);
  std::reverse(values.begin(), values.end());
  values.push_back(nan);
  EXPECT_THAT(percentiles(values, std::vector<double>{0, 1, 50, 99, 99.5, 100}),
              ElementsAre(1, 1, 50, 99, 100, 100));
  EXPECT_THAT(percentiles(std::vector<float>{1, inf, 2}, std::vector<double>{100, 50}),
              ElementsAre(inf, 2));
  EXPECT_TRUE(std::isnan(percentiles({}, std::vector<double>{50})[0]));
}

TEST(NiceTicks, AreRoundNumbers) {
  EXPECT_THAT(nice_ticks(0, 1, 6, false), ElementsAre(0, 0.2, 0.4, 0.6, 0.8, 1));
  EXPECT_THAT(nice_ticks(0, 1, 11, false),
              ElementsAre(0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1));
  EXPECT_THAT(nice_ticks(-1.5, 13, 5, false), ElementsAre(0, 5, 10));
  EXPECT_THAT(nice_ticks(1e6, 1.00001e6, 3, false), ElementsAre(1000000, 1000005, 1000010));
  EXPECT_THAT(nice_ticks(3, 3, 5, false), ElementsAre(3));
}

TEST(NiceTicks, ArePowersOfTenOnALogarithmicAxis) {
  EXPECT_THAT(nice_ticks(0.9, 21, 6, true), ElementsAre(1, 2, 5, 10, 20));
  EXPECT_THAT(nice_ticks(0.9, 35, 4, true), ElementsAre(1, 3, 10, 30));
  EXPECT_THAT(nice_ticks(1e-3, 1e3, 8, true), ElementsAre(1e-3, 1e-2, 0.1, 1, 10, 100, 1000));
  EXPECT_THAT(nice_ticks(1e-3, 1e3, 3, true), ElementsAre(0.01, 1, 100));
  EXPECT_THAT(nice_ticks(3, 4, 5, true), ElementsAre(3, 3.5, 4)) << "steps";
}

TEST(NiceTicks, AreNeverTooManyNorOutside) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> exponent(-20, 20);
  for (int i = 0; i < 20000; ++i) {
    const double a = std::exp(exponent(random)), b = std::exp(exponent(random));
    const double lo = std::min(a, b), hi = std::max(a, b) + 0.01 * lo;
    for (const bool logarithmic : {false, true})
      for (const std::uint32_t most : {1U, 3U, 4U, 10U}) {
        const std::vector<double> ticks = nice_ticks(lo, hi, most, logarithmic);
        ASSERT_LE(ticks.size(), most) << lo << " to " << hi;
        if (most >= 3) {
          ASSERT_GE(ticks.size(), 1U) << lo << " to " << hi;
        }
        if (ticks.empty()) continue;
        ASSERT_GE(ticks.front(), lo);
        ASSERT_LE(ticks.back(), hi);
      }
  }
}

TEST(NiceTicks, AreNoneOfWhatIsNoRange) {
  EXPECT_THAT(nice_ticks(1, 0, 5, false), IsEmpty());
  EXPECT_THAT(nice_ticks(0, inf, 5, false), IsEmpty());
  EXPECT_THAT(nice_ticks(-1.7e308, 1.7e308, 5, false), IsEmpty());
  EXPECT_THAT(nice_ticks(nan, 1, 5, true), IsEmpty());
  EXPECT_THAT(nice_ticks(0, 1, 0, false), IsEmpty());
}

} // namespace
} // namespace lightcuts::viz
