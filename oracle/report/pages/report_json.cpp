// SPDX-License-Identifier: MIT
#include <oracle/report/pages/report_json.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <oracle/numbers/same_digits.h>
#include <oracle/report/pages/run_columns.h>

namespace lightcuts::oracle {
namespace {

using Json = nlohmann::ordered_json;

Json run_json(const Run& run) {
  Json json;
  for_each_column(run, [&](const char* name, const auto& value) { json[name] = value; });
  return json;
}

} // namespace

std::string report_json(const Report& report) {
  Json json;
  json["schema"] = "lightcuts-oracle/report/1";
  json["scene"] = report.scene;
  json["seed"] = report.seed;
  json["builder"] = report.builder;
  json["lights"] = report.lights;
  json["triangles"] = report.triangles;
  json["width"] = report.size.x;
  json["height"] = report.size.y;
  json["surface_pixels"] = report.surface_pixels;
  json["threads"] = report.threads;
  json["repeats"] = report.repeats;
  json["black_level"] = same_digits(report.black_level);
  json["needs"] = report.needs;
  json["left_out"] = report.left_out;
  json["runs"] = Json::array();
  for (const Run& run : report.runs) json["runs"].push_back(run_json(run));
  // dump() writes what is not finite as null.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace lightcuts::oracle
