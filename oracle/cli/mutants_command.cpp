// SPDX-License-Identifier: MIT
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "common.h"
#include "progress.h"
#include <lightcuts/oracle/check.h>
#include <lightcuts/oracle/library_subject.h>
#include <lightcuts/oracle/mutants.h>

namespace lightcuts::cli {
namespace {

using oracle::Property;

/// How one subject fared.
struct Verdict {
  std::string name;
  std::optional<Property> violated; ///< the first of the list that is
  double seconds = 0;
};

Verdict judge(const SceneView& view, const oracle::Subject& subject,
              const oracle::CheckConfig& config) {
  const oracle::CheckResult result = check(view, subject, config);
  Verdict verdict{subject.name(), std::nullopt, result.seconds};
  for (std::size_t i = oracle::property_count; i-- > 0;)
    if (result.tally[Property(i)].violations > 0) verdict.violated = Property(i);
  return verdict;
}

std::string table_of(const std::vector<Verdict>& verdicts, const Verdict& library,
                     std::size_t caught) {
  std::string text =
      fmt::format("{:<30}{:<8}{:<32}{:>8}\n", "mutant", "caught", "by property", "seconds");
  const auto add = [&text](const Verdict& v, const char* name) {
    text += fmt::format("{:<30}{:<8}{:<32}{:>8.2f}\n", name, v.violated ? "yes" : "no",
                        v.violated ? info(*v.violated).name : "-", v.seconds);
  };
  for (const Verdict& v : verdicts) add(v, v.name.c_str());
  add(library, "(the library itself)");
  return text + fmt::format("\n{} of {} caught{}\n", caught, verdicts.size(),
                            library.violated ? "; the library itself fails, too" : "");
}

std::string json_of(const std::vector<Verdict>& verdicts, const Verdict& library,
                    std::size_t caught) {
  nlohmann::ordered_json json{{"schema", "lightcuts-oracle/mutants/1"}};
  auto& list = json["mutants"] = nlohmann::ordered_json::array();
  for (const Verdict& v : verdicts) {
    nlohmann::ordered_json entry{{"name", v.name}, {"caught", v.violated.has_value()}};
    entry["property"] = nullptr;
    if (v.violated) entry["property"] = info(*v.violated).name;
    entry["seconds"] = v.seconds;
    list.push_back(entry);
  }
  json["caught"] = caught;
  json["total"] = verdicts.size();
  json["library_passes"] = !library.violated;
  return text_of(json);
}

int run(const CommonOptions& options) {
  JsonFolder folder(options);
  const Scene scene = open_lit_scene_for(options);
  const SceneView view(scene);
  oracle::CheckConfig config = check_config_for(options, view);

  std::vector<Verdict> verdicts;
  std::size_t caught = 0;
  {
    Progress progress("mutants");
    for (const oracle::Mutant& mutant : oracle::mutants()) {
      verdicts.push_back(judge(view, *mutant.subject(), config));
      caught += verdicts.back().violated ? 1 : 0;
      progress.update(double(verdicts.size()) / double(oracle::mutants().size() + 1));
    }
  }
  const Verdict library = judge(view, *oracle::library_subject(), config);
  const std::string json = json_of(verdicts, library, caught);
  folder.write("mutants.json", json);
  print_results(options, table_of(verdicts, library, caught), json);
  return caught == verdicts.size() && !library.violated ? all_holds : violated;
}

} // namespace

void add_mutants_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<CommonOptions>();
  options->scene = "desk";
  options->cases = "2e5";
  CLI::App* command = app.add_subcommand(
      "mutants", "Judge deliberately broken variants of the library: each has to be caught (exit "
                 "code 1 if one is not, or if the library itself fails).");
  add_common_options(*command, *options);
  add_threshold_option(*command, *options);
  add_json_folder_option(*command, *options);
  add_cases_option(*command, *options);
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

} // namespace lightcuts::cli
