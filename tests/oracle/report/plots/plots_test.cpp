// SPDX-License-Identifier: MIT
#include <oracle/report/plots/plots.h>

#include <limits>

#include <gtest/gtest.h>

#include <tests/oracle/support/contains.h>
#include <tests/oracle/support/made_up_report.h>
#include <tests/support/float_limits.h>

namespace lightcuts::oracle {
namespace {

void expect_all_drawn(const Report& report) {
  for (const auto& draw :
       {error_against_time_plot, error_against_threshold_plot, cut_size_histogram})
    EXPECT_TRUE(contains(draw(report), "</svg>"));
}

TEST(Plots, name_axes_methods_and_thresholds) {
  Report report = made_up_report();
  report.runs.push_back(made_up_run("it's {another} method", 0.05));
  const std::string time = error_against_time_plot(report);
  for (const char* part : {"render time", "reference (no error)", ">lightcuts<", "2 %", "10 %",
                           ">it's {another} method<"})
    EXPECT_TRUE(contains(time, part)) << part;
  const std::string threshold = error_against_threshold_plot(report);
  for (const char* part : {"error = threshold", "certified, lightcuts", "largest, lightcuts"})
    EXPECT_TRUE(contains(threshold, part)) << part;
  EXPECT_TRUE(contains(cut_size_histogram(report), "mean 201.6"));
}

TEST(Plots, are_drawn_with_one_threshold) {
  Report report = made_up_report();
  report.runs.pop_back();
  report.cut_sizes = {7};
  expect_all_drawn(report);
}

TEST(Plots, are_drawn_with_the_reference_alone) {
  Report report = made_up_report();
  report.runs.resize(1);
  report.cut_sizes = {20000, 20000};
  expect_all_drawn(report);
}

TEST(Plots, are_drawn_without_anything) { expect_all_drawn({}); }

TEST(Plots, leave_out_what_cannot_be_drawn) {
  Report report = made_up_report();
  report.runs[1].mean_relative_error = 0;
  report.runs[2].max_relative_error = std::numeric_limits<double>::quiet_NaN();
  report.runs[2].render_seconds = inf;
  report.cut_sizes = {std::numeric_limits<float>::infinity(), 3};
  expect_all_drawn(report);
}

TEST(Plots, are_drawn_over_many_decades) {
  Report report = made_up_report();
  report.runs[1].mean_relative_error = 1e-300;
  report.runs[2].mean_relative_error = 1e300;
  report.cut_sizes = {1, 1e7F};
  expect_all_drawn(report);
}

} // namespace
} // namespace lightcuts::oracle
