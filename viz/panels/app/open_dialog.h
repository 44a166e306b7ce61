// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <viz/model/state/app_settings.h>

namespace lightcuts::viz {

/// Lets people choose a scene: a built-in one, a recent one, or a file.
class OpenDialog {
public:
  /// Shows it from now on.
  void open();
  /// Draws it if shown; returns what was chosen when it was.
  std::optional<std::string> draw(const AppSettings& settings);

private:
  void list_folder();
  std::optional<std::string> draw_builtin();
  std::optional<std::string> draw_recent(const AppSettings& settings);
  std::optional<std::string> draw_files();

  bool opening_ = false;
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> folders_, files_;
  std::string problem_;
  std::string typed_;
};

} // namespace lightcuts::viz
