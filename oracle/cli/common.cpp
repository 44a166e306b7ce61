// SPDX-License-Identifier: MIT
#include <oracle/cli/common.h>

#include <charconv>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

#include <lightcuts/core/input_error.h>
#include <lightcuts/render/io/open_scene.h>
#include <lightcuts/render/io/output_folder.h>
#include <lightcuts/render/lighting/area_lights.h>
#include <lightcuts/render/lighting/environment_lights.h>
#include <lightcuts/render/lighting/light_generator.h>
#include <lightcuts/render/lighting/surfels.h>
#include <lightcuts/render/lighting/virtual_point_lights.h>
#include <lightcuts/render/view/renderer.h>
#include <oracle/cli/count.h>

namespace lightcuts::cli {
namespace {

std::optional<glm::uvec2> parse_size(const std::string& text) {
  glm::uvec2 size(0);
  char rest = 0;
  if (text.find_first_not_of("0123456789x") != std::string::npos) return std::nullopt; // no signs
  if (std::sscanf(text.c_str(), "%5ux%5u%c", &size.x, &size.y, &rest) != 2) return std::nullopt;
  return size;
}

std::string check_size(const std::string& text) {
  return parse_size(text) ? "" : "'" + text + "' is not WIDTHxHEIGHT";
}

// CLI11 takes -1 for the largest number.
std::string check_not_negative(const std::string& text) {
  return text.starts_with('-') ? "'" + text + "' is negative" : "";
}

std::string check_distance(const std::string& text) {
  float distance = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, distance);
  const bool whole = error == std::errc() && rest == end;
  return whole && distance > 0 && std::isfinite(distance)
             ? ""
             : "'" + text + "' is not a finite number above 0";
}

constexpr unsigned max_threads = 1024;

/// Known before the long job, not after.
void require_writable(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (std::filesystem::is_directory(file))
    throw InputError(InputFault::unwritable_file,
                     file.string() + ": is a folder, not a file to write");
  if (!std::filesystem::is_directory(folder))
    throw InputError(InputFault::unwritable_file,
                     file.string() + ": cannot be written: there is no folder " + folder.string());
  const bool exists = std::filesystem::exists(file);
  if (::access((exists ? file : folder).c_str(), W_OK) != 0)
    throw InputError(InputFault::unwritable_file, file.string() + ": cannot be written");
}

/// The scene's own lights give way to a cloud; where they are clamped stays.
void replace_lights(const CommonOptions& options, Scene& scene) {
  const float min_distance = scene.lights.min_distance();
  scene.lights = LightSet();
  if (min_distance > 0) scene.lights.set_min_distance(min_distance);
  generate(default_cloud(scene.mesh, options.lights, options.seed), scene.lights);
}

void make_lights(const CommonOptions& options, Scene& scene) {
  if (options.lights > 0) replace_lights(options, scene);
  if (options.min_distance) scene.lights.set_min_distance(*options.min_distance);
  if (options.area_lights > 0)
    add_area_lights(scene, {.count = options.area_lights, .seed = options.seed});
  if (!options.environment.empty())
    add_environment_lights(scene, read_environment(options.environment),
                           {.count = options.environment_lights});
  if (options.vpls > 0)
    add_virtual_point_lights(scene, {.paths = options.vpls, .seed = options.seed});
  if (options.surfels > 0)
    add_surfels(scene,
                {.count = options.surfels, .seed = options.seed, .threads = options.threads});
}

Scene opened(const CommonOptions& options) {
  require_writable_json(options);
  Scene scene = open_scene(options.scene);
  if (!options.size.empty()) scene.image_size = *parse_size(options.size);
  try {
    make_lights(options, scene);
  } catch (const InputError& error) {
    throw InputError(error.fault(), fmt::format("{}: {}", options.scene, error.what()));
  }
  validate(scene);
  return scene;
}

/// What adds to the scene's lights.
void add_light_options(CLI::App& command, CommonOptions& options) {
  command
      .add_option("--area-lights", options.area_lights,
                  "add so many lights on the surfaces that emit, or one on each of their "
                  "triangles if those are more; default: none")
      ->check(check_positive);
  CLI::Option* environment = command.add_option(
      "--environment", options.environment,
      "add directional lights after this latitude-longitude image (.exr, .hdr); default: none");
  command
      .add_option("--environment-lights", options.environment_lights,
                  "how many lights --environment adds")
      ->needs(environment)
      ->check(check_positive)
      ->capture_default_str();
  CLI::Option* vpls =
      command
          .add_option("--vpls", options.vpls,
                      "add virtual point lights along so many light paths; default: none")
          ->check(check_positive);
  command
      .add_option("--surfels", options.surfels,
                  "add the light that surfaces reflect once, sampled at so many points; "
                  "default: none")
      ->excludes(vpls) // both have the first reflection
      ->check(check_positive);
  command
      .add_option("--min-distance", options.min_distance,
                  "clamp distances to lights to this, metres, against bright spots around VPLs and "
                  "surfels; default: the scene's")
      ->check(check_distance);
}

void print_notes(const Scene& scene) {
  for (const std::string& note : scene.notes) fmt::print(stderr, "{}: {}\n", scene.name, note);
}

} // namespace

std::string check_count(const std::string& text) {
  return parse_count(text) ? ""
                           : "'" + text +
                                 "' is not a whole number above 0 and below 2^64, such as 1000000 "
                                 "or 1e9";
}

std::string check_positive(const std::string& text) {
  const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  const bool zero = text.find_first_not_of('0') == std::string::npos;
  return digits && !zero ? "" : "'" + text + "' is not a whole number above 0";
}

float parse_threshold(const std::string& text) {
  std::size_t used = 0;
  float value = NAN;
  try {
    value = std::stof(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  const std::string unit = text.substr(used);
  if (used == 0 || !(unit.empty() || unit == "%") || !(value >= 0) || std::isinf(value))
    throw CLI::ValidationError("'" + text + "' is not a threshold such as 2%, 0.02 or auto");
  return unit == "%" ? static_cast<float>(std::stod(text) / 100) : value;
}

float threshold_for(const CommonOptions& options, const SceneView& view) {
  return options.threshold == "auto" ? default_threshold(view) : parse_threshold(options.threshold);
}

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const Method method : all_methods) names.emplace_back(method->name);
  return names;
}

std::string check_threshold(const std::string& text) {
  if (text == "auto") return {};
  try {
    (void)parse_threshold(text);
    return {};
  } catch (const CLI::ValidationError& e) {
    return e.what();
  }
}

void add_common_options(CLI::App& command, CommonOptions& options) {
  command
      .add_option("SCENE", options.scene,
                  "a built-in scene (see 'scenes'), or a .json, .obj, .gltf or .glb file")
      ->capture_default_str();
  add_seed_option(command, options);
  command.add_option("--threads", options.threads, "0: one per core")
      ->check(CLI::Range(0U, max_threads))
      ->capture_default_str();
  command.add_option("--max-cut", options.max_cut, "largest number of clusters in a cut")
      ->check(check_positive)
      ->capture_default_str();
  command.add_option("--size", options.size, "WIDTHxHEIGHT of the image; default: the scene's")
      ->check(check_size);
  command
      .add_option("--lights", options.lights,
                  "light the scene with so many random lights in its upper half instead of its "
                  "own; default: the scene's")
      ->check(check_positive);
  add_light_options(command, options);
  add_json_option(command, options);
}

void add_seed_option(CLI::App& command, CommonOptions& options) {
  command.add_option("--seed", options.seed, "of every random choice")
      ->check(check_not_negative)
      ->capture_default_str();
}

void add_json_option(CLI::App& command, CommonOptions& options) {
  command.add_option("--json", options.json,
                     "write the results to this file as JSON; '-': to stdout, and no table; "
                     "default: no JSON");
}

void require_writable_json(const CommonOptions& options) {
  if (!options.json.empty() && options.json != "-") require_writable(options.json);
}

void add_threshold_option(CLI::App& command, CommonOptions& options) {
  command
      .add_option(
          "--threshold", options.threshold,
          "error bound allowed per cluster, relative to the pixel's total; auto: 0.5% to 50%, "
          "chosen by scene for a mean error of 1 % or less")
      ->check(check_threshold)
      ->capture_default_str();
}

void add_builder_option(CLI::App& command, CommonOptions& options) {
  std::vector<std::string> names;
  for (const Builder b : all_builders) names.emplace_back(name_of(b));
  command.add_option("--builder", options.builder, "how lights are clustered in a tree")
      ->check(CLI::IsMember(names))
      ->capture_default_str();
}

BuildConfig build_config_for(const CommonOptions& options) {
  return {options.seed, *builder_named(options.builder)};
}

void add_json_folder_option(CLI::App& command, CommonOptions& options) {
  command.add_option("--out", options.out,
                     "folder to write the results to as " + command.get_name() +
                         ".json; default: none");
}

JsonFolder::JsonFolder(const CommonOptions& options) {
  if (!options.out.empty()) folder_.emplace(options.out);
}

void JsonFolder::write(const std::string& name, const std::string& json) {
  if (!folder_) return;
  write_file_atomically(folder_->stage(name), json);
  folder_->commit();
}

void add_out_option(CLI::App& command, CommonOptions& options) {
  command.add_option("--out", options.out, "folder for the results; default: out/SCENE");
}

Scene open_scene_for(const CommonOptions& options) {
  Scene scene = opened(options);
  print_notes(scene);
  return scene;
}

Scene open_lit_scene_for(const CommonOptions& options) {
  Scene scene = opened(options);
  if (scene.lights.empty())
    throw InputError(InputFault::missing,
                     options.scene + ": no lights; add some with --lights 1000");
  print_notes(scene);
  return scene;
}

void add_cases_option(CLI::App& command, CommonOptions& options) {
  command
      .add_option("--cases", options.cases,
                  "(node, shading point) pairs to check at least, such as 1000000 or 1e9")
      ->check(check_count)
      ->capture_default_str();
}

oracle::CheckConfig check_config_for(const CommonOptions& options, const SceneView& view) {
  oracle::CheckConfig config;
  config.seed = options.seed;
  config.tree_seed = options.seed;
  config.pairs = *parse_count(options.cases);
  config.threads = options.threads;
  config.cut = {threshold_for(options, view), options.max_cut, 0};
  return config;
}

std::filesystem::path output_folder_for(const CommonOptions& options) {
  if (!options.out.empty()) return options.out;
  std::string name = std::filesystem::path(options.scene).stem().string();
  if (std::filesystem::path(options.scene).extension().empty()) name = options.scene;
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '_' && c != '.')
      c = '-';
  return std::filesystem::path("out") / name;
}

std::string text_of(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void print_results(const CommonOptions& options, const std::string& table,
                   const std::string& json) {
  if (options.json == "-") {
    fmt::print("{}", json);
    return;
  }
  if (!options.json.empty()) write_file_atomically(options.json, json);
  fmt::print("{}", table);
}

} // namespace lightcuts::cli
