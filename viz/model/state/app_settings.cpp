// SPDX-License-Identifier: MIT
#include <viz/model/state/app_settings.h>

#include <algorithm>
#include <cstdlib>
#include <type_traits>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <lightcuts/core/input_error.h>
#include <lightcuts/render/files/output_folder.h>
#include <lightcuts/render/files/text.h>

#include <oracle/records/record_file.h>

namespace lightcuts::viz {
namespace {

constexpr const char* settings_schema = "lightcuts-viz/settings/1";

std::filesystem::path file_in(const std::filesystem::path& folder) {
  return folder / "settings.json";
}

/// The settings, or the nearest ones to them with which a window can be used.
AppSettings usable(AppSettings settings) {
  for_each_field(settings, []<class T>(const char*, T& value, const Domain& domain) {
    if constexpr (std::is_same_v<T, float>)
      value = std::clamp(value, float(domain.least), float(domain.most));
    else if constexpr (std::is_same_v<T, glm::uvec2>)
      value = glm::clamp(value, unsigned(domain.least), unsigned(domain.most));
  });
  if (settings.recent.size() > AppSettings::most_recent)
    settings.recent.resize(AppSettings::most_recent);
  return settings;
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
  const std::filesystem::path file = file_in(folder);
  if (!std::filesystem::exists(file)) return {};
  try {
    AppSettings settings;
    oracle::read_record_file(file.string(), read_file(file), settings_schema, settings,
                             [](const JsonElement& /*root*/) {});
    return settings;
  } catch (const std::exception& error) {
    problem = fmt::format("{}; the settings are as by default", error.what());
    return {};
  }
}

void save_settings(const AppSettings& s, const std::filesystem::path& folder) {
  if (folder.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw InputError(InputFault::unwritable_file, folder.string() + ": " + error.message());
  write_file_atomically(file_in(folder),
                        oracle::record_file(settings_schema, usable(s), oracle::Floats::decimal));
}

} // namespace lightcuts::viz
