// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <oracle/report/report.h>

namespace lightcuts::oracle {

/// The runs as CSV: a header, then one row per run; "scene" first, then the columns of
/// report.json's runs. Quoted as RFC 4180 says, but lines end with \n alone. Numbers have the
/// digits that give the same bits back; those that are not finite are nan, inf or -inf.
[[nodiscard]] std::string report_csv(const Report& report);

} // namespace lightcuts::oracle
