// SPDX-License-Identifier: MIT
#include <oracle/report/pages/report_csv.h>

#include <fmt/format.h>

#include <oracle/report/pages/run_columns.h>

namespace lightcuts::oracle {
namespace {

std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + "\"";
}

template <class Number>
std::string field(Number value) {
  return fmt::format("{}", value);
}

} // namespace

std::string report_csv(const Report& report) {
  std::string csv = "scene,builder";
  for_each_column(Run{}, [&](const char* name, const auto&) { csv.append(",").append(name); });
  csv += "\n";
  for (const Run& run : report.runs) {
    csv += field(report.scene) + "," + field(report.builder);
    for_each_column(run,
                    [&](const char*, const auto& value) { csv.append(",").append(field(value)); });
    csv += "\n";
  }
  return csv;
}

} // namespace lightcuts::oracle
