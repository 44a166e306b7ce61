// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <oracle/report/report.h>

namespace lightcuts::oracle {

/// The report as JSON of schema "lightcuts-oracle/report/1": the scene's facts, then "runs", one
/// object per run. Times in seconds, errors relative (0.01 is 1 %). Numbers that are not finite
/// become null, bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string report_json(const Report& report);

} // namespace lightcuts::oracle
