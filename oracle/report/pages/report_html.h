// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include <oracle/report/report.h>

namespace lightcuts::oracle {

/// The report as one HTML page that needs nothing else: style, plots and pictures are inside, there
/// are no scripts. The files of report.pictures are read from `folder_of_pictures`. Where one
/// cannot be read, or gnuplot is missing, the page says so in its place.
[[nodiscard]] std::string report_html(const Report& report,
                                      const std::filesystem::path& folder_of_pictures);

} // namespace lightcuts::oracle
