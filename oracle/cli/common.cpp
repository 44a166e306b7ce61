// SPDX-License-Identifier: MIT
#include <oracle/cli/common.h>

#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <lightcuts/core/input_error.h>
#include <lightcuts/render/files/output_folder.h>
#include <lightcuts/render/view/renderer.h>
#include <lightcuts/render/view/scene_features.h>
#include <oracle/options/count.h>
#include <oracle/options/scene_options.h>
#include <oracle/options/values.h>

namespace lightcuts::cli {
namespace {

constexpr unsigned max_threads = 1024;

Scene opened(const CommonOptions& options) {
  require_writable_json(options);
  SceneRequest request = options.open;
  request.seed = options.seed;
  return open_scene(request, options.threads);
}

void print_notes(const Scene& scene) {
  for (const std::string& note : scene.notes) fmt::print(stderr, "{}: {}\n", scene.name, note);
}

} // namespace

float threshold_for(const CommonOptions& options, const SceneView& view) {
  return options.threshold ? *options.threshold : default_threshold(view);
}

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const Method method : all_methods) names.emplace_back(method->name);
  return names;
}

void add_common_options(CLI::App& command, CommonOptions& options) {
  options::add_scene_options(command, options.open, "--size");
  add_seed_option(command, options);
  add_threads_option(command, options);
  options::add_max_cut_option(command, options.max_cut);
  add_json_option(command, options);
}

void add_seed_option(CLI::App& command, CommonOptions& options) {
  command.add_option("--seed", options.seed, "of every random choice")
      ->check(options::check_not_negative)
      ->capture_default_str();
}

void add_threads_option(CLI::App& command, CommonOptions& options) {
  command.add_option("--threads", options.threads, "0: one per core")
      ->check(CLI::Range(0U, max_threads))
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

BuildConfig build_config_for(const CommonOptions& options) {
  return {options.seed, options.open.builder};
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
                     options.open.spec + ": no lights; add some with --lights 1000");
  print_notes(scene);
  return scene;
}

void add_cases_option(CLI::App& command, CommonOptions& options) {
  command
      .add_option("--cases", options.cases,
                  "(node, shading point) pairs to check at least, such as 1000000 or 1e9")
      ->check(options::check_count)
      ->capture_default_str();
}

oracle::CheckConfig check_config_for(const CommonOptions& options, const SceneView& view) {
  oracle::CheckConfig config;
  config.seed = options.seed;
  config.tree_seed = options.seed;
  config.pairs = *options::parse_count(options.cases);
  config.threads = options.threads;
  config.cut = {threshold_for(options, view), options.max_cut, 0};
  return config;
}

std::filesystem::path output_folder_for(const CommonOptions& options) {
  if (!options.out.empty()) return options.out;
  std::string name = std::filesystem::path(options.open.spec).stem().string();
  if (std::filesystem::path(options.open.spec).extension().empty()) name = options.open.spec;
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
