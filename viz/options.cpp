// SPDX-License-Identifier: MIT
#include <viz/options.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include <fmt/format.h>

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

/// "A<separator>B" as two whole numbers of at most five digits.
std::optional<glm::uvec2> parse_pair(const std::string& text, char separator) {
  const std::string allowed = std::string("0123456789") + separator;
  if (text.find_first_not_of(allowed) != std::string::npos) return std::nullopt;
  const std::size_t at = text.find(separator);
  if (at == std::string::npos || at == 0 || at > 5) return std::nullopt;
  const std::string second = text.substr(at + 1);
  if (second.empty() || second.size() > 5 || second.find(separator) != std::string::npos)
    return std::nullopt;
  return glm::uvec2(std::stoul(text.substr(0, at)), std::stoul(second));
}

/// A CLI11 check of whole numbers: what CLI::PositiveNumber says has 300 digits.
std::string at_least_one(const std::string& text) {
  return text.find_first_not_of('0') == std::string::npos || text.starts_with('-')
             ? "'" + text + "' is not a whole number above 0"
             : "";
}

std::string check_size(const std::string& text) {
  const auto size = parse_pair(text, 'x');
  const bool good = size && size->x > 0 && size->y > 0 && std::max(size->x, size->y) <= 16384;
  return good ? "" : "'" + text + "' is not WIDTHxHEIGHT, at most 16384 pixels each";
}

std::string check_pixel(const std::string& text) {
  return parse_pair(text, ',') ? "" : "'" + text + "' is not X,Y";
}

/// "2%" or "0.02"; nothing for anything else.
std::optional<float> parse_threshold(const std::string& text) {
  std::size_t used = 0;
  double value = -1;
  try {
    value = std::stod(text, &used);
  } catch (const std::exception&) {
    return std::nullopt;
  }
  const std::string unit = text.substr(used);
  if (!(value >= 0 && value <= 1e6) || !(unit.empty() || unit == "%")) return std::nullopt;
  return float(unit == "%" ? value / 100 : value);
}

std::string check_threshold(const std::string& text) {
  return text == "auto" || parse_threshold(text)
             ? ""
             : "'" + text + "' is not a threshold such as 2%, 0.02 or auto";
}

template <class Names>
std::vector<std::string> listed(const Names& all, const char* (*name)(std::size_t)) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::size(all); ++i) names.emplace_back(name(i));
  return names;
}

std::vector<std::string> display_names() {
  return listed(all_displays, [](std::size_t i) { return name_of(all_displays[i]); });
}
std::vector<std::string> layer_names() {
  return listed(all_layers, [](std::size_t i) { return all_layers[i]->name; });
}
std::vector<std::string> tab_names() {
  return listed(tabs, [](std::size_t i) { return tabs[i].first; });
}
std::vector<std::string> builder_names() {
  return listed(all_builders, [](std::size_t i) { return name_of(all_builders[i]); });
}
std::vector<std::string> map_names() {
  return listed(all_colour_maps, [](std::size_t i) { return name_of(all_colour_maps[i]); });
}

void add_scene_options(CLI::App& command, Options& options) {
  command.add_option("SCENE", options.scene,
                     "a built-in scene, a .json, .obj, .gltf or .glb file, or a counterexample of "
                     "lightcuts-oracle; default: bedroom");
  command
      .add_option("--lights", options.lights,
                  "so many random lights in its upper half instead of its own; default: its own")
      ->check(at_least_one);
  command
      .add_option("--image-size", options.image_size,
                  "WIDTHxHEIGHT of the rendered image; default: the scene's")
      ->check(check_size);
  command.add_option("--state", options.state,
                     "a view saved by Ctrl+S (.json); other options go before it");
}

void add_shading_options(CLI::App& command, Options& options) {
  command.add_option("--method", options.method, "how the image is made; default: lightcuts")
      ->check(CLI::IsMember(display_names()));
  command
      .add_option("--compare", options.compared,
                  "a second method, at the right of a split; default: no split")
      ->check(CLI::IsMember(display_names()));
  command
      .add_option("--threshold", options.threshold,
                  "error bound allowed per cluster, relative to the pixel's total; auto: by scene")
      ->check(check_threshold)
      ->capture_default_str();
  command
      .add_option("--builder", options.builder,
                  "how lights are clustered in a tree; default: greedy")
      ->check(CLI::IsMember(builder_names()));
  command.add_option("--max-cut", options.max_cut, "largest number of clusters; default: 5000")
      ->check(at_least_one);
  command.add_flag("--always-tree", options.always_tree,
                   "use the light tree even where it does not pay");
}

void add_view_options(CLI::App& command, Options& options) {
  command.add_option("--layer", options.layer, "what is shown of each pixel; default: image")
      ->check(CLI::IsMember(layer_names()));
  command.add_option("--pixel", options.pixel, "X,Y of the selected pixel; default: none")
      ->check(check_pixel);
  command.add_option("--node", options.node, "the selected cluster; default: none");
  command
      .add_option("--step", options.step, "the cut when it had so many clusters; default: its end")
      ->check(at_least_one);
  command.add_option("--tab", options.tab, "the panel at the right; default: cut")
      ->check(CLI::IsMember(tab_names()));
  command.add_option("--colour-map", options.colour_map, "default: inferno")
      ->check(CLI::IsMember(map_names()));
  command.add_flag("--log", options.logarithmic, "a logarithmic colour scale");
}

void add_window_options(CLI::App& command, Options& options) {
  command
      .add_option(
          "--size", options.size,
          "WIDTHxHEIGHT of the window; default: the last one's, at first and with --screenshot "
          "1280x800")
      ->check(check_size);
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

glm::uvec2 Options::window_size() const {
  return size.empty() ? glm::uvec2(1280, 800) : *parse_pair(size, 'x');
}

AppSettings Options::sized(AppSettings settings) const {
  if (!size.empty()) settings.window_size = glm::ivec2(window_size());
  return settings;
}

std::optional<Tab> Options::chosen_tab() const {
  for (const auto& [name, which] : tabs)
    if (tab == name) return which;
  return std::nullopt;
}

void add_options(CLI::App& command, Options& options) {
  add_scene_options(command, options);
  add_shading_options(command, options);
  add_view_options(command, options);
  add_window_options(command, options);
}

ViewState state_for(const Options& options, const AppSettings& settings) {
  ViewState state;
  state.colours.map = settings.colour_map;
  if (!options.state.empty()) state = load_view_state(options.state);
  if (!options.scene.empty()) state.open.spec = options.scene;
  if (state.open.spec.empty()) state.open.spec = default_scene;
  if (options.lights > 0) state.open.lights = options.lights;
  if (!options.image_size.empty()) state.open.image_size = parse_pair(options.image_size, 'x');
  if (!options.method.empty()) state.display = *display_named(options.method);
  if (!options.compared.empty()) {
    state.split = true;
    state.compared = *display_named(options.compared);
  }
  if (options.threshold != "auto") state.shading.threshold = parse_threshold(options.threshold);
  if (!options.builder.empty()) state.open.builder = *builder_named(options.builder);
  if (options.max_cut) state.shading.max_cut = *options.max_cut;
  if (options.always_tree) state.shading.tree_use = TreeUse::always;
  if (!options.layer.empty()) state.layer = *layer_named(options.layer);
  if (!options.pixel.empty()) state.pixel = parse_pair(options.pixel, ',');
  if (options.node) state.node = options.node;
  if (options.step) state.step = options.step;
  if (options.logarithmic && !state.colours.logarithmic) {
    state.colours.logarithmic = true;
    state.colours.automatic_range = true;
  }
  for (const ColourMap map : all_colour_maps)
    if (options.colour_map == name_of(map)) state.colours.map = map;
  return state;
}

} // namespace lightcuts::viz
