// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <lightcuts/render/files/output_folder.h>
#include <oracle/campaign/hunt.h>
#include <oracle/cli/commands.h>
#include <oracle/cli/common.h>
#include <oracle/cli/progress_line.h>
#include <oracle/cli/subjects.h>
#include <oracle/counterexamples/counterexample_json.h>
#include <oracle/mutants/mutants.h>
#include <oracle/options/count.h>
#include <oracle/options/values.h>
#include <oracle/subjects/library_subject.h>

namespace lightcuts::cli {
namespace {

using oracle::Property;
using oracle::Severity;

/// How one subject fared.
struct Verdict {
  std::string name, what_is_wrong;
  std::optional<oracle::Counterexample> found; ///< shrunk
  std::uint64_t cases = 0;
  double seconds = 0;
};

Verdict judge(const oracle::Subject& subject, const oracle::HuntConfig& config,
              const char* what_is_wrong) {
  const oracle::HuntResult result = hunt(subject, config);
  Verdict verdict{subject.name(), what_is_wrong, result.found, result.cases, result.seconds};
  if (result.found) verdict.found = shrunk(subject, *result.found);
  return verdict;
}

std::string property_of(const Verdict& v) {
  if (!v.found) return "-";
  const auto& property = info(v.found->property);
  return std::string(property.name) + (property.severity == Severity::waste ? " (waste)" : "");
}

std::string table_of(const std::vector<Verdict>& verdicts, const Verdict& library,
                     std::size_t caught) {
  std::string text = fmt::format("{:<32}{:<8}{:<38}{:>8}{:>8}{:>8}\n", "mutant", "caught",
                                 "by property", "seconds", "lights", "points");
  const auto add = [&text](const Verdict& v, const std::string& name) {
    const auto size = [&](std::size_t n) { return v.found ? std::to_string(n) : "-"; };
    text += fmt::format("{:<32}{:<8}{:<38}{:>8.2f}{:>8}{:>8}\n", name, v.found ? "yes" : "no",
                        property_of(v), v.seconds, size(v.found ? v.found->on.lights.size() : 0),
                        size(v.found ? v.found->on.views.size() : 0));
  };
  for (const Verdict& v : verdicts) add(v, v.name);
  add(library, fmt::format("(the library, {} cases)", library.cases));
  return text + fmt::format("\n{} of {} caught{}\n", caught, verdicts.size(),
                            library.found ? "; the library itself fails, too" : "");
}

nlohmann::ordered_json json_of(const Verdict& v) {
  nlohmann::ordered_json entry{{"name", v.name}, {"caught", v.found.has_value()}};
  if (!v.what_is_wrong.empty()) entry["what_is_wrong"] = v.what_is_wrong;
  for (const char* field : {"property", "severity", "lights", "points", "message"})
    entry[field] = nullptr;
  if (v.found) {
    const auto& property = info(v.found->property);
    entry["property"] = property.name;
    entry["severity"] = property.severity == Severity::waste ? "waste" : "violation";
    entry["lights"] = v.found->on.lights.size();
    entry["points"] = v.found->on.views.size();
    entry["message"] = v.found->message;
  }
  entry["cases"] = v.cases;
  entry["seconds"] = v.seconds;
  return entry;
}

std::string json_of(const std::vector<Verdict>& verdicts, const Verdict& library,
                    std::size_t caught) {
  nlohmann::ordered_json json{{"schema", "lightcuts-oracle/mutants/2"}};
  auto& list = json["mutants"] = nlohmann::ordered_json::array();
  for (const Verdict& v : verdicts) list.push_back(json_of(v));
  json["caught"] = caught;
  json["total"] = verdicts.size();
  json["library"] = json_of(library);
  json["library_passes"] = !library.found;
  return text_of(json);
}

/// mutants.json, and a counterexample-NAME.json for each that was caught.
void save(const std::vector<Verdict>& verdicts, const std::string& json, OutputFolder& folder) {
  write_file_atomically(folder.stage("mutants.json"), json);
  for (const Verdict& v : verdicts)
    if (v.found)
      write_file_atomically(
          folder.stage("counterexample-" + v.name + ".json"),
          oracle::counterexample_json({oracle::full_subject_name(v.name), *v.found}));
  folder.commit();
}

struct MutantsOptions : CommonOptions {
  std::vector<std::string> names;
  double seconds = 60;
};

std::vector<oracle::Mutant> chosen(const std::vector<std::string>& names) {
  const auto all = oracle::mutants();
  if (names.empty()) return {all.begin(), all.end()};
  std::vector<oracle::Mutant> list;
  for (const std::string& name : names) list.push_back(*oracle::mutant_named(name));
  return list;
}

int run(const MutantsOptions& options) {
  require_writable_json(options);
  std::optional<OutputFolder> folder; // refused before the long job where it cannot be written
  if (!options.out.empty()) folder.emplace(options.out);
  oracle::HuntConfig config;
  config.seed = options.seed;
  config.cases = *options::parse_count(options.cases);
  config.further = 100;
  config.seconds = options.seconds;

  const std::vector<oracle::Mutant> mutants = chosen(options.names);
  std::vector<Verdict> verdicts;
  std::size_t caught = 0;
  Verdict library;
  {
    ProgressLine line("mutants");
    for (const oracle::Mutant& mutant : mutants) {
      verdicts.push_back(judge(*mutant.subject(), config, mutant.what_is_wrong));
      caught += verdicts.back().found ? 1 : 0;
      line.update(double(verdicts.size()) / double(mutants.size() + 1));
    }
    library = judge(*oracle::library_subject(), config, "");
  }
  const std::string json = json_of(verdicts, library, caught);
  if (folder) save(verdicts, json, *folder);
  print_results(options, table_of(verdicts, library, caught), json);
  return caught == verdicts.size() && !library.found ? all_holds : violated;
}

} // namespace

void add_mutants_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<MutantsOptions>();
  options->cases = "20000";
  CLI::App* command = app.add_subcommand(
      "mutants",
      "Judge deliberately broken variants of the library on random cases: each has to be "
      "caught (exit code 1 if one is not, or if the library itself fails).");
  command->add_option("NAME", options->names, "mutants to judge; default: all")
      ->check([](const std::string& name) {
        return oracle::mutant_named(name) != nullptr ? "" : "no mutant is called '" + name + "'";
      });
  command->add_option("--cases", options->cases, "random cases at most, such as 20000 or 1e6")
      ->check(options::check_count)
      ->capture_default_str();
  add_seed_option(*command, *options);
  command->add_option("--out", options->out,
                      "folder for mutants.json and each counterexample-NAME.json; default: none");
  add_json_option(*command, *options);
  command->add_option("--seconds", options->seconds, "most seconds for each; 0: no limit")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

} // namespace lightcuts::cli
