// SPDX-License-Identifier: MIT
#include "subjects.h"

#include <fmt/format.h>

#include <lightcuts/input_error.h>
#include <lightcuts/oracle/library_subject.h>
#include <lightcuts/oracle/mutants.h>
#include <lightcuts/oracle/plugin_subject.h>

namespace lightcuts::cli {
namespace {

constexpr std::string_view mutant = "mutant:";
constexpr const char* library = "lightcuts";

} // namespace

std::string full_name(const std::string& name) {
  return oracle::mutant_named(name) != nullptr ? std::string(mutant) + name : name;
}

std::unique_ptr<oracle::Subject> subject_for(const SubjectOptions& options) {
  const std::string& name = options.subject;
  if (name == library) return oracle::library_subject();
  if (name == "paper") return oracle::paper_subject();
  if (name == "stochastic-intensity") return oracle::stochastic_intensity_subject();
  const std::string full = full_name(name);
  if (full.starts_with(mutant))
    if (const oracle::Mutant* found = oracle::mutant_named(full.substr(mutant.size())))
      return found->subject();
  if (name.find('/') != std::string::npos || name.ends_with(".so"))
    return oracle::plugin_subject(name, {.time_limit = options.time_limit});
  throw InputError(fmt::format("subject '{}' is unknown; known: lightcuts, paper, "
                               "stochastic-intensity, those of 'lightcuts-oracle mutants' as "
                               "mutant:NAME, and plug-ins as ./FILE.so",
                               name));
}

void add_subject_options(CLI::App& command, SubjectOptions& options) {
  command
      .add_option(
          "--subject", options.subject,
          "whom to judge: lightcuts, paper, stochastic-intensity, mutant:NAME, or the light "
          "tree in a shared library written after lightcuts/oracle/subject_abi.h, ./FILE.so")
      ->capture_default_str();
  command
      .add_option("--time-limit", options.time_limit,
                  "of each question to a plug-in, seconds; after that it counts as hung")
      ->check(CLI::Range(1e-3, 1e6))
      ->capture_default_str();
}

bool is_library(const oracle::Subject& subject) { return subject.name() == library; }

} // namespace lightcuts::cli
