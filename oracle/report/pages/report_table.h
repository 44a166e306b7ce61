// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <oracle/report/report.h>

namespace lightcuts::oracle {

/// The report as a summary for a terminal, at most 100 columns wide: the scene, a row per run, and
/// what was left out. A method's name is shortened where it does not fit. (Wider only where numbers
/// beyond 1e99 leave no room.)
[[nodiscard]] std::string report_table(const Report& report);

} // namespace lightcuts::oracle
