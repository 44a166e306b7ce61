// SPDX-License-Identifier: MIT
#include <oracle/options/scene_options.h>

#include <vector>

#include <CLI/CLI.hpp>

#include <lightcuts/render/io/scene_files.h>

#include <oracle/options/values.h>

namespace lightcuts::options {
namespace {

/// Options that add to the scene's lights.
void add_light_options(CLI::App& command, SceneRequest& request) {
  command
      .add_option("--area-lights", request.area_lights,
                  "add so many lights on the surfaces that emit, or one on each of their "
                  "triangles if those are more; default: none")
      ->check(check_positive);
  CLI::Option* environment = command.add_option(
      "--environment", request.environment,
      "add directional lights after this latitude-longitude image (.exr, .hdr); default: none");
  command
      .add_option("--environment-lights", request.environment_lights,
                  "how many lights --environment adds")
      ->needs(environment)
      ->check(check_positive)
      ->capture_default_str();
  command
      .add_option("--environment-turn", request.environment_turn,
                  "degrees by which it is turned about +y, from +z towards +x")
      ->needs(environment)
      ->check(CLI::Range(-360.0, 360.0))
      ->capture_default_str();
  command
      .add_flag("--environment-visible", request.environment_visible,
                "let the camera see it where it sees no surface; default: it does not")
      ->needs(environment);
  CLI::Option* vpls =
      command
          .add_option("--vpls", request.vpls,
                      "add virtual point lights along so many light paths; default: none")
          ->check(check_positive);
  command
      .add_option("--surfels", request.surfels,
                  "add the light that surfaces reflect once, sampled at so many points; "
                  "default: none")
      ->excludes(vpls) // both have the first reflection
      ->check(check_positive);
  command
      .add_option("--min-distance", request.min_distance,
                  "clamp distances to lights to this, metres, against bright spots around VPLs and "
                  "surfels; default: the scene's")
      ->check(check_distance);
}

} // namespace

void add_scene_options(CLI::App& command, SceneRequest& request, const std::string& size_option) {
  command
      .add_option("SCENE", request.spec,
                  "a built-in scene (see 'lightcuts-oracle scenes'), or a " +
                      scene_extensions_text() + " file")
      ->capture_default_str();
  command
      .add_option_function<std::string>(
          size_option,
          [&request](const std::string& text) { request.image_size = parse_size(text); },
          "WIDTHxHEIGHT of the image; default: the scene's")
      ->check(check_size);
  command
      .add_option("--lights", request.lights,
                  "light the scene with so many random lights in its upper half instead of its "
                  "own; default: the scene's")
      ->check(check_positive);
  command
      .add_option_function<std::string>(
          "--camera", [&request](const std::string& text) { request.camera = parse_camera(text); },
          "X,Y,Z,TX,TY,TZ[,FOV]: look from the first point to the second, with that vertical field "
          "of view in degrees; default: the scene's camera, as 'lightcuts-oracle info' prints it")
      ->check(check_camera);
  command.add_flag("--allow-outside", request.allow_outside,
                   "let the scene's files name files outside its folder; default: they may not");
  add_light_options(command, request);
}

void add_builder_option(CLI::App& command, Builder& builder) {
  std::vector<std::string> names;
  for (const Builder b : all_builders) names.emplace_back(name_of(b));
  command
      .add_option_function<std::string>(
          "--builder",
          [&builder](const std::string& name) { builder = *value_named<Builder>(name); },
          "how lights are clustered in a tree")
      ->check(CLI::IsMember(names))
      ->default_str(name_of(builder));
}

void add_threshold_option(CLI::App& command, std::optional<float>& threshold) {
  command
      .add_option_function<std::string>(
          "--threshold",
          [&threshold](const std::string& text) { threshold = parse_threshold(text); },
          "error bound allowed per cluster, relative to the pixel's total; auto: 0.5% to 50%, "
          "chosen by scene for a mean error of 1 % or less")
      ->check(check_threshold)
      ->default_str("auto");
}

void add_max_cut_option(CLI::App& command, std::uint32_t& max_cut) {
  command.add_option("--max-cut", max_cut, "largest number of clusters in a cut")
      ->check(check_positive)
      ->capture_default_str();
}

} // namespace lightcuts::options
