// SPDX-License-Identifier: MIT
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <lightcuts/render/builtin/builtin_scenes.h>
#include <oracle/cli/commands.h>
#include <oracle/cli/common.h>

namespace lightcuts::cli {
namespace {

int list_scenes(const CommonOptions& options) {
  std::string table;
  nlohmann::ordered_json json{{"schema", "lightcuts-oracle/scenes/1"}};
  auto& list = json["scenes"] = nlohmann::ordered_json::array();
  for (const BuiltinScene& scene : builtin_scenes()) {
    table += fmt::format("{:<10}{}\n", scene.name, scene.description);
    list.push_back({{"name", scene.name}, {"description", scene.description}});
  }
  print_results(options, table, json.dump(2) + "\n");
  return all_holds;
}

} // namespace

void add_scenes_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<CommonOptions>();
  CLI::App* command = app.add_subcommand("scenes", "List the built-in scenes.");
  command->add_option("--json", options->json,
                      "write the list to this file as JSON; '-': to stdout, and no table");
  command->callback([options, &chosen] { chosen = [options] { return list_scenes(*options); }; });
}

} // namespace lightcuts::cli
