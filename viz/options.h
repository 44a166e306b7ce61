// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <viz/model/state/app_settings.h>
#include <viz/model/state/view_state.h>
#include <viz/panels/app/app.h>

namespace CLI {
class App;
} // namespace CLI

namespace lightcuts::viz {

/// The command line of lightcuts-viz.
struct Options {
  ViewState view;           ///< to be shown at first: --state, and over it what else was asked for
  bool has_colours = false; ///< whether the view's colour map was asked for
  std::optional<glm::uvec2> size; ///< of the window, pixels
  std::optional<Tab> tab;
  std::optional<float> scale;
  std::string screenshot, out = "out/viz";
  double wait = 1e6;

  /// The settings with --size, if given, for the window's.
  [[nodiscard]] AppSettings sized(AppSettings settings) const;
};

/// The options must outlive the command, whose parse() throws InputError where --state cannot be
/// read.
void add_options(CLI::App& command, Options& options);

} // namespace lightcuts::viz
