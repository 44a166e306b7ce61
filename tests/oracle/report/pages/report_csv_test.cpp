// SPDX-License-Identifier: MIT
#include <oracle/report/pages/report_csv.h>

#include <algorithm>
#include <limits>
#include <sstream>

#include <gtest/gtest.h>

#include <tests/oracle/support/made_up_report.h>

namespace lightcuts::oracle {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(ReportCsv, has_a_header_and_a_row_per_run) {
  const auto lines = lines_of(report_csv(made_up_report()));
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0], "scene,builder,method,threshold,build_seconds,render_seconds,mean_cut_size,"
                      "shadow_rays_per_pixel,rel_rmse,mrse,mean_relative_error,"
                      "max_relative_error,mean_certified_error,pixels_over_threshold,dark_pixels,"
                      "size_limited_pixels,speedup_over_reference,efficiency,optimal_cut_size,"
                      "cut_efficiency");
  EXPECT_EQ(lines[1].rfind("room,greedy,reference,0,0,41.3,20000,", 0), 0U) << lines[1];
  for (const std::string& line : lines) EXPECT_EQ(std::count(line.begin(), line.end(), ','), 19);
}

TEST(ReportCsv, quotes_where_needed) {
  Report report = made_up_report();
  report.scene = "a,\"b\"";
  report.runs[0].method = "two\nlines";
  const std::string csv = report_csv(report);
  EXPECT_NE(csv.find("\"a,\"\"b\"\"\",greedy,\"two\nlines\",0,"), std::string::npos) << csv;
}

TEST(ReportCsv, keeps_all_digits) {
  Report report = made_up_report();
  report.runs.assign(1, {});
  report.runs[0].threshold = 1.0 / 3;
  report.runs[0].build_seconds = std::numeric_limits<double>::quiet_NaN();
  const std::string csv = report_csv(report);
  EXPECT_NE(csv.find("room,greedy,,0.3333333333333333,nan,0,"), std::string::npos) << csv;
}

} // namespace
} // namespace lightcuts::oracle
