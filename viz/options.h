// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include <viz/model/state/app_settings.h>
#include <viz/model/state/view_state.h>
#include <viz/panels/app/app.h>

namespace lightcuts::viz {

/// The command line of lightcuts-viz.
struct Options {
  std::string scene, method, compared, layer, pixel, builder, threshold = "auto", size, image_size,
                                                              state;
  std::optional<std::uint32_t> node, step, max_cut;
  std::uint32_t lights = 0;
  bool always_tree = false, logarithmic = false;
  std::string screenshot, tab, colour_map;
  std::optional<float> scale;
  double wait = 1e6;
  std::string out = "out/viz";

  /// 1280 x 800 by default.
  [[nodiscard]] glm::uvec2 window_size() const;
  /// The settings with --size, if given, for the window's.
  [[nodiscard]] AppSettings sized(AppSettings settings) const;
  [[nodiscard]] std::optional<Tab> chosen_tab() const;
};

void add_options(CLI::App& command, Options& options);

/// What is to be shown at first: --state, and over it what else was asked for. Throws InputError.
[[nodiscard]] ViewState state_for(const Options& options, const AppSettings& settings);

} // namespace lightcuts::viz
