// SPDX-License-Identifier: MIT
#include <viz/model/state/app_settings.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>
#include <lightcuts/render/io/output_folder.h>
#include <nlohmann/json.hpp>

namespace lightcuts::viz {
namespace {

using Json = nlohmann::ordered_json;
constexpr const char* schema = "lightcuts-viz/settings/1";

std::filesystem::path file_in(const std::filesystem::path& folder) {
  return folder / "settings.json";
}

ColourMap map_named(const std::string& name) {
  for (const ColourMap map : all_colour_maps)
    if (name == name_of(map)) return map;
  throw InputError(InputFault::unknown_name, fmt::format("colour map '{}' is unknown", name));
}

AppSettings read(const std::string& text) {
  const Json json = Json::parse(text);
  if (json.at("schema") != schema)
    throw InputError(InputFault::unsupported, "it is of another version");
  AppSettings s;
  s.window_size = {std::clamp(json.at("window_size").at(0).get<int>(), 320, 16384),
                   std::clamp(json.at("window_size").at(1).get<int>(), 240, 16384)};
  s.details_share = std::clamp(json.at("details_share").get<float>(), 0.1F, 0.9F);
  s.tree_share = std::clamp(json.at("tree_share").get<float>(), 0.05F, 0.9F);
  s.colour_map = map_named(json.at("colour_map").get<std::string>());
  for (const Json& scene : json.at("recent"))
    if (s.recent.size() < AppSettings::most_recent) s.recent.push_back(scene.get<std::string>());
  return s;
}

} // namespace

void AppSettings::remember(std::string scene) {
  recent.erase(std::remove(recent.begin(), recent.end(), scene), recent.end());
  recent.insert(recent.begin(), std::move(scene));
  if (recent.size() > most_recent) recent.resize(most_recent);
}

std::filesystem::path config_folder() {
  if (const char* folder = std::getenv("XDG_CONFIG_HOME"); folder != nullptr && *folder == '/')
    return std::filesystem::path(folder) / "lightcuts-viz";
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != 0)
    return std::filesystem::path(home) / ".config" / "lightcuts-viz";
  return {};
}

AppSettings load_settings(const std::filesystem::path& folder, std::string& problem) {
  if (folder.empty()) return {};
  std::ifstream stream(file_in(folder));
  if (!stream) return {};
  std::ostringstream text;
  text << stream.rdbuf();
  try {
    return read(text.str());
  } catch (const std::exception& error) {
    problem = fmt::format("{}: {}; the settings are as by default", file_in(folder).string(),
                          error.what());
    return {};
  }
}

void save_settings(const AppSettings& s, const std::filesystem::path& folder) {
  if (folder.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw InputError(InputFault::unwritable_file, folder.string() + ": " + error.message());
  const Json json{{"schema", schema},
                  {"window_size", {s.window_size.x, s.window_size.y}},
                  {"details_share", s.details_share},
                  {"tree_share", s.tree_share},
                  {"colour_map", name_of(s.colour_map)},
                  {"recent", s.recent}};
  write_file_atomically(file_in(folder),
                        json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

} // namespace lightcuts::viz
