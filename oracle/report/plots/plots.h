// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <oracle/report/report.h>

// The plots of a report, as SVG documents. All throw like gnuplot_svg where gnuplot fails or is
// missing. Numbers that cannot be drawn (on a logarithmic axis: 0) are left out; without any, the
// axes stay empty.
namespace lightcuts::oracle {

/// Mean relative error against render seconds, both logarithmic: a line per method with a point,
/// labelled with it, per threshold. The reference has no error: a vertical line at its time.
[[nodiscard]] std::string error_against_time_plot(const Report& report);

/// Mean, largest and mean certified relative error against the threshold, both logarithmic, and
/// the diagonal on which an error is its threshold.
[[nodiscard]] std::string error_against_threshold_plot(const Report& report);

/// How many of the pixels that see a surface have a cut of which size, from report.cut_sizes, with
/// the mean marked.
[[nodiscard]] std::string cut_size_histogram(const Report& report);

} // namespace lightcuts::oracle
