// SPDX-License-Identifier: MIT
#include <viz/options.h>

#include <array>
#include <iterator>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <lightcuts/render/io/scene_files.h>
#include <oracle/options/scene_options.h>
#include <oracle/options/values.h>
#include <viz/model/layers/all_layers.h>

namespace lightcuts::viz {
namespace {

constexpr const char* default_scene = "bedroom";

constexpr std::array<std::pair<const char*, Tab>, 6> tabs{
    {{"cut", Tab::cut},
     {"why", Tab::why},
     {"scene", Tab::scene},
     {"plots", Tab::plots},
     {"live", Tab::live},
     {"counterexample", Tab::counterexample}}};

/// An option whose value is the name of one of `all`: take(it).
template <class All, class Name, class Take>
void add_choice(CLI::App& command, const char* option, const All& all, Name name, Take take,
                const char* description) {
  std::vector<std::string> names;
  names.reserve(std::size(all));
  for (const auto& value : all) names.emplace_back(name(value));
  command
      .add_option_function<std::string>(
          option,
          [&all, name, take](const std::string& chosen) {
            for (const auto& value : all)
              if (chosen == name(value)) take(value);
          },
          description)
      ->check(CLI::IsMember(names));
}

void add_state_option(CLI::App& command, Options& options) {
  command.add_option_function<std::string>(
      "--state",
      [&options](const std::string& file) {
        options.view = load_view_state(file);
        options.has_colours = true;
      },
      "a view saved by Ctrl+S (.json); what other options say counts instead of what it says");
}

void add_shading_options(CLI::App& command, ViewState& view) {
  const auto name = [](const DisplayMethod& display) { return name_of(display); };
  add_choice(
      command, "--method", all_displays, name,
      [&view](const DisplayMethod& display) { view.display = display; },
      "how the image is made; default: lightcuts");
  add_choice(
      command, "--compare", all_displays, name,
      [&view](const DisplayMethod& display) {
        view.split = true;
        view.compared = display;
      },
      "a second method, at the right of a split; default: no split");
  options::add_threshold_option(command, view.shading.threshold);
  options::add_builder_option(command, view.open.builder);
  options::add_max_cut_option(command, view.shading.max_cut);
  command.add_flag_function(
      "--always-tree", [&view](std::int64_t) { view.shading.tree_use = TreeUse::always; },
      "use the light tree even where it does not pay");
  command
      .add_option_function<std::uint64_t>(
          "--seed",
          [&view](std::uint64_t seed) {
            view.open.seed = view.open.tree_seed = view.shading.seed = seed;
          },
          "of every random choice; default: 1")
      ->check(options::check_not_negative);
}

void add_view_options(CLI::App& command, Options& options) {
  ViewState& view = options.view;
  add_choice(
      command, "--layer", all_layers, [](Layer layer) { return layer->name; },
      [&view](Layer layer) { view.layer = layer; }, "what is shown of each pixel; default: image");
  command
      .add_option_function<std::string>(
          "--pixel",
          [&view](const std::string& text) { view.pixel = options::parse_pair(text, ','); },
          "X,Y of the selected pixel; default: none")
      ->check([](const std::string& text) {
        return options::parse_pair(text, ',') ? "" : "'" + text + "' is not X,Y";
      });
  command.add_option("--node", view.node, "the selected cluster; default: none");
  command.add_option("--step", view.step, "the cut when it had so many clusters; default: its end")
      ->check(options::check_positive);
  add_choice(
      command, "--tab", tabs, [](const auto& tab) { return tab.first; },
      [&options](const auto& tab) { options.tab = tab.second; },
      "the panel at the right; default: cut");
  add_choice(
      command, "--colour-map", all_colour_maps, [](ColourMap map) { return name_of(map); },
      [&options](ColourMap map) {
        options.view.colours.map = map;
        options.has_colours = true;
      },
      "default: inferno");
  command.add_flag_function(
      "--log",
      [&view](std::int64_t) {
        if (view.colours.logarithmic) return;
        view.colours.logarithmic = view.colours.automatic_range = true;
      },
      "a logarithmic colour scale");
}

void add_window_options(CLI::App& command, Options& options) {
  command
      .add_option_function<std::string>(
          "--size",
          [&options](const std::string& text) { options.size = options::parse_size(text); },
          "WIDTHxHEIGHT of the window; default: the last one's, at first and with --screenshot "
          "1280x800")
      ->check(options::check_size);
  command.add_option("--scale", options.scale, "of fonts and sizes; default: the screen's")
      ->check(CLI::Range(0.5F, 4.0F));
  command.add_option("--out", options.out, "folder for what Ctrl+S saves")->capture_default_str();
  command.add_option("--screenshot", options.screenshot,
                     "draw the window off-screen, write it to this PNG and exit");
  command
      .add_option("--wait", options.wait,
                  "with --screenshot: seconds after which it is taken, complete or not; default: "
                  "until it is complete")
      ->check(CLI::Range(0.0, 1e6));
}

} // namespace

AppSettings Options::sized(AppSettings settings) const {
  if (size) settings.window_size = *size;
  return settings;
}

void add_options(CLI::App& command, Options& options) {
  // First: options act in this order, and the others change what the state says.
  add_state_option(command, options);
  options.view.open.spec = default_scene;
  options::add_scene_options(command, options.view.open, "--image-size");
  command.get_option("SCENE")->description("a built-in scene, a " + scene_extensions_text() +
                                           " file, or a counterexample of lightcuts-oracle");
  add_shading_options(command, options.view);
  add_view_options(command, options);
  add_window_options(command, options);
}

} // namespace lightcuts::viz
