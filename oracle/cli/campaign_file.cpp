// SPDX-License-Identifier: MIT
#include <oracle/cli/campaign_file.h>

#include <cstdint>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <lightcuts/core/input_error.h>
#include <lightcuts/render/files/output_folder.h>
#include <lightcuts/render/files/text.h>
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

PropertyCount count_of(const nlohmann::json& json) {
  PropertyCount count;
  json.at("cases").get_to(count.cases);
  json.at("violations").get_to(count.violations);
  if (json.at("waste").get<bool>()) count.severity = oracle::Severity::waste;
  json.at("worst_ratio").get_to(count.worst_ratio);
  json.at("first_place").get_to(count.first_place);
  json.at("first_violation").get_to(count.first_violation);
  return count;
}

oracle::CheckResult result_of(const nlohmann::json& json) {
  oracle::CheckResult result;
  json.at("points").get_to(result.points);
  json.at("pairs").get_to(result.pairs);
  json.at("rays").get_to(result.rays);
  json.at("undecided_rays").get_to(result.undecided_rays);
  json.at("seconds").get_to(result.seconds);
  json.at("swept_pairs").get_to(result.swept_pairs);
  json.at("sweep_seconds").get_to(result.sweep_seconds);
  for (const Property p : oracle::all_properties)
    result.tally[p] = count_of(json.at("properties").at(info(p).name));
  return result;
}

} // namespace

CampaignFile::CampaignFile(std::filesystem::path file, nlohmann::ordered_json what)
    : file_(std::move(file)), what_(std::move(what)) {}

oracle::CheckResult CampaignFile::load() const {
  if (!std::filesystem::exists(file_)) return {};
  const std::string text = read_file(file_);
  try {
    const nlohmann::json json = nlohmann::json::parse(text);
    if (json.at("schema") != schema)
      throw InputError(InputFault::unsupported,
                       file_.string() + ": is of another version of lightcuts-oracle");
    for (const auto& [name, value] : what_.items())
      if (json.at("of").at(name) != value)
        throw InputError(InputFault::inconsistent,
                         fmt::format("{}: was begun with {} {}, not {}", file_.string(), name,
                                     json.at("of").at(name).dump(), value.dump()));
    return result_of(json.at("result"));
  } catch (const nlohmann::json::exception& e) {
    throw InputError(
        InputFault::malformed_file,
        fmt::format("{}: is not what --resume has written: {}", file_.string(), plain_message(e)));
  }
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
