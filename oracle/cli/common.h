// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <lightcuts/core/tree/tree_builder.h>
#include <lightcuts/render/files/output_folder.h>
#include <lightcuts/render/io/scene_request.h>
#include <lightcuts/render/view/scene_features.h>
#include <lightcuts/render/view/scene_view.h>
#include <nlohmann/json.hpp>
#include <oracle/campaign/check.h>
#include <oracle/options/program.h>

namespace CLI {
class App;
} // namespace CLI

namespace lightcuts::cli {

using options::all_holds;
using options::usage;
using options::violated;

/// Options that several commands have.
struct CommonOptions {
  SceneRequest open; ///< its seeds are `seed`
  std::uint64_t seed = 1;
  unsigned threads = 0;
  std::optional<float> threshold; ///< nothing: what suits the scene
  std::string cases = "1e7";
  std::uint32_t max_cut = default_max_cut;
  std::string out;
  std::string json;
};

/// Adds what add_scene_options() does, --seed, --threads, --max-cut and --json.
void add_common_options(CLI::App& command, CommonOptions& options);
void add_seed_option(CLI::App& command, CommonOptions& options);
void add_threads_option(CLI::App& command, CommonOptions& options);
void add_json_option(CLI::App& command, CommonOptions& options);
void add_out_option(CLI::App& command, CommonOptions& options);

/// The tree that --seed and --builder ask for.
[[nodiscard]] BuildConfig build_config_for(const CommonOptions& options);

/// --threshold, or what suits the scene: default_threshold().
[[nodiscard]] float threshold_for(const CommonOptions& options, const SceneView& view);

/// The names of all_methods.
[[nodiscard]] std::vector<std::string> method_names();

/// Throws InputError where --json cannot be written: before the long job, not after.
void require_writable_json(const CommonOptions& options);

/// Opens the scene. Throws InputError, also where --json cannot be written; says on stderr what the
/// reader of the scene noted.
[[nodiscard]] Scene open_scene_for(const CommonOptions& options);

/// open_scene_for(), for commands that need light: throws InputError where there is none, too.
[[nodiscard]] Scene open_lit_scene_for(const CommonOptions& options);

/// Adds --cases to the commands that check; its default is what options.cases is.
void add_cases_option(CLI::App& command, CommonOptions& options);

/// The configuration of check() that the options ask for; no black level, no progress.
[[nodiscard]] oracle::CheckConfig check_config_for(const CommonOptions& options,
                                                   const SceneView& view);

/// --out, or out/NAME after the scene.
[[nodiscard]] std::filesystem::path output_folder_for(const CommonOptions& options);

/// The JSON indented, as UTF-8: bytes of file names that are not become U+FFFD.
[[nodiscard]] std::string text_of(const nlohmann::ordered_json& json);

/// --out of the commands that draw nothing: a folder for their results as JSON.
void add_json_folder_option(CLI::App& command, CommonOptions& options);

/// The folder of --out, refused before the long job where it cannot be written; nothing without it.
class JsonFolder {
public:
  explicit JsonFolder(const CommonOptions& options);
  /// Writes the file that --out promises.
  void write(const std::string& name, const std::string& json);

private:
  std::optional<OutputFolder> folder_;
};

/// Prints the table on stdout and writes the JSON to --json, or only the JSON if that is stdout.
void print_results(const CommonOptions& options, const std::string& table, const std::string& json);

} // namespace lightcuts::cli
