// SPDX-License-Identifier: MIT
#include <oracle/options/count.h>

#include <gtest/gtest.h>

namespace lightcuts::options {
namespace {

TEST(ParseCount, ReadsDigitsAndExponents) {
  EXPECT_EQ(parse_count("1"), 1U);
  EXPECT_EQ(parse_count("0010"), 10U);
  EXPECT_EQ(parse_count("1e9"), 1'000'000'000U);
  EXPECT_EQ(parse_count("25E3"), 25'000U);
  EXPECT_EQ(parse_count("7e00"), 7U);
}

// A double would round all of these.
TEST(ParseCount, IsExactUpToTheEnd) {
  EXPECT_EQ(parse_count("18446744073709551615"), 18446744073709551615U);
  EXPECT_EQ(parse_count("1844674407370955161e1"), 18446744073709551610U);
  EXPECT_EQ(parse_count("9007199254740993"), 9007199254740993U);
  EXPECT_EQ(parse_count("1e19"), 10000000000000000000U);
}

TEST(ParseCount, RefusesAnythingElse) {
  for (const char* text : {"",
                           "0",
                           "0e5",
                           "e9",
                           "1e",
                           "-1",
                           "+1",
                           "1e-3",
                           "1e+3",
                           "1.5e6",
                           "1 000",
                           " 1",
                           "1 ",
                           "1e9x",
                           "0x10",
                           "nan",
                           "inf",
                           "1e1e1",
                           "18446744073709551616",
                           "18446744073709551620",
                           "28446744073709551616",
                           "2e19",
                           "1e20",
                           "1e99999999999999999999",
                           "1e18446744073709551615"})
    EXPECT_EQ(parse_count(text), std::nullopt) << text;
}

TEST(ParseDuration, TakesSecondsMinutesAndHours) {
  EXPECT_EQ(parse_duration("90"), 90);
  EXPECT_EQ(parse_duration("90s"), 90);
  EXPECT_EQ(parse_duration("10m"), 600);
  EXPECT_EQ(parse_duration("2h"), 7200);
  for (const char* text : {"", "s", "0", "0m", "1d", "-1s", "1.5h", "1e9h", "m10", "10 m"})
    EXPECT_EQ(parse_duration(text), std::nullopt) << text;
}

TEST(ParseMemory, ReadsBinaryUnits) {
  EXPECT_EQ(parse_memory("64KiB"), 65'536U);
  EXPECT_EQ(parse_memory("512MiB"), 536'870'912U);
  EXPECT_EQ(parse_memory("4GiB"), 4'294'967'296U);
  EXPECT_EQ(parse_memory("1TiB"), 1'099'511'627'776U);
  EXPECT_EQ(parse_memory("8388607TiB"), 9'223'370'937'343'148'032U);
}

TEST(ParseMemory, RefusesAnythingElse) {
  for (const char* text : {"", "0GiB", "512", "4GB", "4G", "GiB", "iB", "4 GiB", "1.5GiB", "-1GiB",
                           "4GiBs", "8388608TiB", "18446744073709551615KiB"})
    EXPECT_FALSE(parse_memory(text)) << text;
}

} // namespace
} // namespace lightcuts::options
