// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <oracle/report/report.h>

namespace lightcuts::oracle {

/// The table of runs, for report_html.
std::string html_runs(const Report& report);

/// What each column of the table of runs means, as a description list.
std::string html_legend(const Report& report);

} // namespace lightcuts::oracle
