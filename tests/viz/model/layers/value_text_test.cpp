// SPDX-License-Identifier: MIT
#include <viz/model/layers/value_text.h>

#include <cmath>

#include <gtest/gtest.h>

#include <tests/support/float_limits.h>

namespace lightcuts::viz {
namespace {

TEST(ShortText, HasFourDigits) {
  EXPECT_EQ(short_text(0.123456), "0.1235");
  EXPECT_EQ(short_text(-12.3456), "-12.35");
  EXPECT_EQ(short_text(1234.56), "1235");
  EXPECT_EQ(short_text(0.001), "0.001");
  EXPECT_EQ(short_text(0.0012345), "0.001234");
}

TEST(ShortText, LeavesOutZerosAtTheEnd) {
  EXPECT_EQ(short_text(12.5), "12.5");
  EXPECT_EQ(short_text(3), "3");
  EXPECT_EQ(short_text(100), "100");
  EXPECT_EQ(short_text(0), "0");
  EXPECT_EQ(short_text(-0.0), "0");
}

TEST(ShortText, GivesWholeNumbersBelowAMillionInFull) {
  EXPECT_EQ(short_text(9999), "9999");
  EXPECT_EQ(short_text(9999.6), "10000");
  EXPECT_EQ(short_text(123457), "123457");
  EXPECT_EQ(short_text(999999), "999999");
  EXPECT_EQ(short_text(999999.6), "1e6");
}

TEST(ShortText, HasAShortExponentWhereItIsShorter) {
  EXPECT_EQ(short_text(1.2e-5), "1.2e-5");
  EXPECT_EQ(short_text(-0.00012345), "-1.234e-4");
  EXPECT_EQ(short_text(1e-4), "1e-4");
  EXPECT_EQ(short_text(2e-300), "2e-300");
  EXPECT_EQ(short_text(5e-324), "4.941e-324");
  EXPECT_EQ(short_text(1.23456e30), "1.235e30");
  EXPECT_EQ(short_text(1e100), "1e100");
}

TEST(ShortText, NamesWhatIsNoNumber) {
  EXPECT_EQ(short_text(inf), "inf");
  EXPECT_EQ(short_text(-inf), "-inf");
  EXPECT_EQ(short_text(std::nan("")), "nan");
  EXPECT_EQ(short_text(-std::nan("")), "nan");
}

TEST(RgbText, SaysOnceWhatIsAlike) {
  EXPECT_EQ(rgb_text({0.1, 0.2, 3e-5}), "0.1 0.2 3e-5");
  EXPECT_EQ(rgb_text({0.5, 0.5, 0.5}), "0.5");
  EXPECT_EQ(rgb_text({inf, 0, 0}), "inf 0 0");
}

TEST(DurationText, HasTheUnitThatFits) {
  EXPECT_EQ(duration_text(0.00042), "0.42 ms");
  EXPECT_EQ(duration_text(0.035), "35 ms");
  EXPECT_EQ(duration_text(0.0996), "0.1 s");
  EXPECT_EQ(duration_text(0.3), "0.3 s");
  EXPECT_EQ(duration_text(12.4), "12 s");
  EXPECT_EQ(duration_text(80), "1 min 20 s");
  EXPECT_EQ(duration_text(59.6), "1 min");
  EXPECT_EQ(duration_text(3600), "1 h");
  EXPECT_EQ(duration_text(7500), "2 h 5 min");
  EXPECT_EQ(duration_text(0), "0 ms");
  EXPECT_EQ(duration_text(inf), "inf s");
}

} // namespace
} // namespace lightcuts::viz
