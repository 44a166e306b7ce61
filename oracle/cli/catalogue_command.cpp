// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <oracle/campaign/catalogue_run.h>
#include <oracle/cases/case_text.h>
#include <oracle/cli/commands.h>
#include <oracle/cli/common.h>
#include <oracle/cli/counterexample_file.h>
#include <oracle/cli/progress_line.h>
#include <oracle/cli/property_table.h>
#include <oracle/cli/subjects.h>
#include <oracle/subjects/block_cuts_subject.h>

namespace lightcuts::cli {
namespace {

using oracle::NamedResult;

/// All that came of the catalogue.
struct CatalogueRun {
  std::vector<NamedResult> results;
  std::vector<const oracle::NamedCase*> left_out;
  oracle::Tally tally;
  std::optional<CounterexampleFile> file; ///< of the first violation
  double seconds = 0;
};

/// Whom a case is put to: the subject, and the library's shared cuts beside the library.
struct Judged {
  std::unique_ptr<oracle::Subject> subject;
  std::string name;
};

std::vector<Judged> judged_by(const SubjectOptions& options) {
  std::vector<Judged> list;
  list.push_back({subject_for(options), oracle::full_subject_name(options.subject)});
  if (oracle::is_library(*list.front().subject)) {
    std::unique_ptr<oracle::Subject> blocks = oracle::block_cuts_subject();
    std::string name = blocks->name();
    list.push_back({std::move(blocks), std::move(name)});
  }
  return list;
}

/// The results of one case, by one subject and another.
void join(NamedResult& all, const NamedResult& other) {
  all.tally.merge(other.tally);
  all.checks += other.checks;
  all.worst_ratio = std::max(all.worst_ratio, other.worst_ratio);
  if (other.max_relative_error)
    all.max_relative_error =
        std::max(all.max_relative_error.value_or(0), *other.max_relative_error);
  all.saturated += other.saturated;
  all.most_clusters = std::max(all.most_clusters, other.most_clusters);
  all.seconds += other.seconds;
}

void keep_first_violation(CatalogueRun& run, const Judged& by, const NamedResult& result,
                          const std::string& folder, std::uint64_t place) {
  if (run.file || result.tally.violations() == 0) return;
  const oracle::Property property = oracle::broken(result.tally).front();
  const std::string& message = result.tally[property].first_violation;
  run.file.emplace(*by.subject, by.name,
                   oracle::Counterexample{property, complete(*result.of), message, place}, folder);
}

CatalogueRun judged_catalogue(const SubjectOptions& options, const std::string& folder) {
  const std::vector<Judged> list = judged_by(options);
  const auto cases = oracle::catalogue();
  ProgressLine line("stress --catalogue " + options.subject);
  const Progress progress = line.progress();
  CatalogueRun run;
  for (std::size_t i = 0; i < cases.size() && !progress.cancelled(); ++i) {
    // A right tree that is slow is not to be taken for one that hangs.
    if (cases[i].is_large && list.front().subject->works_elsewhere()) {
      run.left_out.push_back(&cases[i]);
      continue;
    }
    std::optional<NamedResult> all;
    for (const Judged& by : list) {
      const NamedResult one = judge_named(*by.subject, cases[i], i);
      keep_first_violation(run, by, one, folder, i);
      if (all)
        join(*all, one);
      else
        all = one;
    }
    run.tally.merge(all->tally);
    run.seconds += all->seconds;
    run.results.push_back(std::move(*all));
    progress.report(double(i + 1) / double(cases.size()));
  }
  return run;
}

std::string ratio_cell(double ratio) {
  return ratio > 1e6 ? "> 10^6" : fmt::format("{:.6f}", ratio);
}

std::string error_cell(const NamedResult& r) {
  return r.max_relative_error ? fmt::format("{:.1e}", *r.max_relative_error) : "-";
}

std::string table_of(const CatalogueRun& run, const std::string& subject) {
  std::string text =
      fmt::format("{}: {} named cases, {:.1f} s\n\n{:<32}{:>9}{:>11}{:>13}{:>11}"
                  "{:>11}{:>16}\n",
                  subject, run.results.size(), run.seconds, "case", "checks", "violations",
                  "worst ratio", "rel. error", "saturated", "cut of lights");
  for (const NamedResult& r : run.results) {
    text += fmt::format("{:<32}{:>9}{:>11}{:>13}{:>11}{:>11}{:>16}\n", r.of->name, r.checks,
                        r.tally.violations(), ratio_cell(r.worst_ratio), error_cell(r), r.saturated,
                        fmt::format("{} of {}", r.most_clusters, r.lights));
    for (const oracle::Property p : oracle::broken(r.tally))
      text += fmt::format("  {}: {}\n", info(p).name, r.tally[p].first_violation);
  }
  text += "\nwhy they are hard:\n";
  for (const NamedResult& r : run.results)
    text += oracle::wrapped(fmt::format("  {:<30} {}", r.of->name, r.of->why), 33);
  for (const oracle::NamedCase* c : run.left_out)
    text += fmt::format("left out, since it may take long: {}\n", c->name);
  const std::uint64_t violations = run.tally.violations();
  text +=
      violations == 0 ? "\nNothing is violated.\n" : fmt::format("\n{} violations.\n", violations);
  return run.file ? text + run.file->text() : text;
}

nlohmann::ordered_json case_json(const NamedResult& r) {
  nlohmann::ordered_json json{{"name", r.of->name},
                              {"why", r.of->why},
                              {"checks", r.checks},
                              {"violations", r.tally.violations()},
                              {"worst_ratio", r.worst_ratio}};
  json["max_relative_error"] = nullptr;
  if (r.max_relative_error) json["max_relative_error"] = *r.max_relative_error;
  json["saturated"] = r.saturated;
  json["wasteful"] = r.tally.wasteful();
  json["cut_size"] = r.most_clusters;
  json["lights"] = r.lights;
  json["seconds"] = r.seconds;
  return json;
}

nlohmann::ordered_json json_of(const CatalogueRun& run, const std::string& subject) {
  nlohmann::ordered_json json{{"schema", "lightcuts-oracle/stress/2"}, {"subject", subject}};
  json["cases"] = nlohmann::ordered_json::array();
  for (const NamedResult& r : run.results) json["cases"].push_back(case_json(r));
  json["left_out"] = nlohmann::ordered_json::array();
  for (const oracle::NamedCase* c : run.left_out) json["left_out"].push_back(c->name);
  json["properties"] = properties_json(run.tally);
  json["violations"] = run.tally.violations();
  json["wasteful"] = run.tally.wasteful();
  json["counterexample"] = nullptr;
  if (run.file) json["counterexample"] = run.file->json();
  json["seconds"] = run.seconds;
  return json;
}

} // namespace

int run_catalogue(const CommonOptions& options, const SubjectOptions& judged) {
  require_writable_json(options);
  const std::string subject = oracle::full_subject_name(judged.subject);
  const CatalogueRun run = judged_catalogue(judged, options.out);
  print_results(options, table_of(run, subject), text_of(json_of(run, subject)));
  return run.tally.violations() > 0 ? violated : all_holds;
}

} // namespace lightcuts::cli
