// SPDX-License-Identifier: MIT
#include "subjects.h"

#include <fmt/format.h>

#include <lightcuts/input_error.h>
#include <lightcuts/oracle/library_subject.h>
#include <lightcuts/oracle/mutants.h>

namespace lightcuts::cli {
namespace {

constexpr std::string_view mutant = "mutant:";
constexpr const char* library = "lightcuts";

} // namespace

std::string full_name(const std::string& name) {
  return oracle::mutant_named(name) != nullptr ? std::string(mutant) + name : name;
}

std::unique_ptr<oracle::Subject> subject_named(const std::string& name) {
  if (name == library) return oracle::library_subject();
  if (name == "paper") return oracle::paper_subject();
  const std::string full = full_name(name);
  if (full.starts_with(mutant))
    if (const oracle::Mutant* found = oracle::mutant_named(full.substr(mutant.size())))
      return found->subject();
  throw InputError(fmt::format("subject '{}' is unknown; known: lightcuts, paper and those of "
                               "'lightcuts-oracle mutants' as mutant:NAME",
                               name));
}

void add_subject_option(CLI::App& command, std::string& name) {
  command.add_option("--subject", name, "whom to judge: lightcuts, paper or mutant:NAME")
      ->capture_default_str();
}

bool is_library(const oracle::Subject& subject) { return subject.name() == library; }

} // namespace lightcuts::cli
