// SPDX-License-Identifier: MIT
#include <oracle/report/pages/report_table.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include <gtest/gtest.h>

#include <tests/oracle/support/contains.h>
#include <tests/oracle/support/made_up_report.h>
#include <tests/support/float_limits.h>

namespace lightcuts::oracle {
namespace {

std::size_t widest_line(const std::string& text) {
  std::size_t widest = 0;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    widest = std::max(widest, static_cast<std::size_t>(
                                  std::count_if(line.begin(), line.end(), [](unsigned char c) {
                                    return (c & 0xC0U) != 0x80U;
                                  })));
  return widest;
}

TEST(ReportTable, shows_the_scene_the_runs_and_what_was_left_out) {
  const std::string table = report_table(made_up_report());
  for (const char* part :
       {"room: 20 000 lights, 1 234 567 triangles", "640 x 360", "2 threads", "reference", "0.74 %",
        "155.2", "20.6x", "19.0 %", "- directional tree: no directional lights"})
    EXPECT_TRUE(contains(table, part)) << part << " in\n" << table;
  EXPECT_LE(widest_line(table), 100U);
}

TEST(ReportTable, stays_within_100_columns_whatever_the_numbers) {
  const double extremes[] = {1e90, 1e-90, inf, std::nan(""), 9999999.4, 0.0123456};
  for (const double x : extremes) {
    Report report = made_up_report();
    report.scene = std::string(250, 'x');
    report.left_out = {std::string(97, 'a') + " " + std::string(98, 'b') + " c"};
    for (auto& run : report.runs)
      run = {"a method with a näme that is löng",
             x,
             x,
             x,
             x,
             x,
             x,
             x,
             x,
             x,
             x,
             1ULL << 63U,
             1,
             1,
             x,
             x,
             x,
             x};
    EXPECT_LE(widest_line(report_table(report)), 100U) << report_table(report);
  }
}

TEST(ReportTable, loses_no_word_when_it_wraps) {
  Report report = made_up_report();
  report.left_out = {std::string(93, 'a') + " second third"};
  const std::string table = report_table(report);
  const std::string wrapped = std::string(93, 'a') + "\n  second third\n";
  EXPECT_TRUE(contains(table, wrapped)) << table;
}

TEST(ReportTable, shows_no_control_characters) {
  Report report = made_up_report();
  report.scene = "\x1b[31mred";
  report.runs[1].method = "a\nb";
  const std::string table = report_table(report);
  EXPECT_FALSE(contains(table, "\x1b"));
  EXPECT_TRUE(contains(table, "a?b"));
}

TEST(ReportTable, works_without_runs) { EXPECT_TRUE(contains(report_table({}), "method")); }

} // namespace
} // namespace lightcuts::oracle
