// SPDX-License-Identifier: MIT
#include <oracle/cli/campaign_file.h>

#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <lightcuts/core/input_error.h>
#include <lightcuts/render/files/output_folder.h>
#include <lightcuts/render/files/text.h>
#include <lightcuts/render/io/json/json_element.h>
#include <lightcuts/render/io/json/json_text.h>
#include <oracle/cli/common.h>

namespace lightcuts::cli {
namespace {

using oracle::Property;
using oracle::PropertyCount;

constexpr const char* schema = "lightcuts-oracle/campaign/2";

nlohmann::ordered_json json_of(const PropertyCount& count) {
  return {{"cases", count.cases},
          {"violations", count.violations},
          {"waste", count.severity == oracle::Severity::waste},
          {"worst_ratio", count.worst_ratio},
          {"first_place", count.first_place},
          {"first_violation", count.first_violation}};
}

std::uint64_t whole(const JsonElement& element) {
  return element.whole_number(0, std::numeric_limits<std::uint64_t>::max());
}

PropertyCount count_of(const JsonElement& element) {
  PropertyCount count;
  count.cases = whole(element["cases"]);
  count.violations = whole(element["violations"]);
  if (element["waste"].boolean()) count.severity = oracle::Severity::waste;
  count.worst_ratio = element["worst_ratio"].wide_number();
  count.first_place = whole(element["first_place"]);
  count.first_violation = element["first_violation"].string();
  return count;
}

oracle::CheckResult result_of(const JsonElement& element) {
  oracle::CheckResult result;
  result.points = whole(element["points"]);
  result.pairs = whole(element["pairs"]);
  result.rays = whole(element["rays"]);
  result.undecided_rays = whole(element["undecided_rays"]);
  result.seconds = element["seconds"].wide_number();
  result.swept_pairs = whole(element["swept_pairs"]);
  result.sweep_seconds = element["sweep_seconds"].wide_number();
  const JsonElement properties = element["properties"];
  for (const Property p : oracle::all_properties)
    result.tally[p] = count_of(properties[info(p).name]);
  return result;
}

} // namespace

CampaignFile::CampaignFile(std::filesystem::path file, nlohmann::ordered_json what)
    : file_(std::move(file)), what_(std::move(what)) {}

oracle::CheckResult CampaignFile::load() const {
  if (!std::filesystem::exists(file_)) return {};
  const nlohmann::json json = parse_json(file_.string(), read_file(file_));
  const JsonElement root(file_.string(), json);
  if (root["schema"].string() != schema)
    throw InputError(InputFault::unsupported,
                     file_.string() + ": is of another version of lightcuts-oracle");
  const JsonElement of = root["of"];
  for (const auto& [name, value] : what_.items()) {
    (void)of[name.c_str()]; // is there
    if (const nlohmann::json& own = json["of"][name]; own != value)
      throw InputError(
          InputFault::inconsistent,
          fmt::format("{}: was begun with {} {}, not {}", file_.string(), name,
                      own.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace),
                      value.dump()));
  }
  return result_of(root["result"]);
}

void CampaignFile::save(const oracle::CheckResult& result) const {
  nlohmann::ordered_json json{{"schema", schema}, {"of", what_}};
  auto& saved = json["result"];
  saved = {{"points", result.points},
           {"pairs", result.pairs},
           {"rays", result.rays},
           {"undecided_rays", result.undecided_rays},
           {"seconds", result.seconds},
           {"swept_pairs", result.swept_pairs},
           {"sweep_seconds", result.sweep_seconds}};
  auto& properties = saved["properties"] = nlohmann::ordered_json::object();
  for (const Property p : oracle::all_properties)
    properties[info(p).name] = json_of(result.tally[p]);
  write_file_atomically(file_, text_of(json));
}

} // namespace lightcuts::cli
