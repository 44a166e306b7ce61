// SPDX-License-Identifier: MIT
#include <oracle/counterexamples/named_subjects.h>

#include <filesystem>

#include <fmt/format.h>

#include <lightcuts/core/input_error.h>
#include <oracle/mutants/mutants.h>
#include <oracle/subjects/block_cuts_subject.h>
#include <oracle/subjects/library_subject.h>

namespace lightcuts::oracle {
namespace {

constexpr std::string_view mutant = "mutant:";
constexpr const char* library = "lightcuts";

bool is_file(const std::string& name) {
  return name.find('/') != std::string::npos || name.ends_with(".so");
}

} // namespace

std::string full_subject_name(const std::string& name) {
  if (mutant_named(name) != nullptr) return std::string(mutant) + name;
  return is_file(name) ? std::filesystem::absolute(name).lexically_normal().string() : name;
}

std::unique_ptr<Subject> subject_named(const std::string& name, const PluginConfig& config) {
  if (name == library) return library_subject();
  if (name == "block-cuts") return block_cuts_subject();
  if (name == "locally-ordered") return locally_ordered_subject();
  if (name == "paper") return paper_subject();
  if (name == "stochastic-intensity") return stochastic_intensity_subject();
  const std::string full = full_subject_name(name);
  if (full.starts_with(mutant))
    if (const Mutant* found = mutant_named(full.substr(mutant.size()))) return found->subject();
  if (is_file(name)) return plugin_subject(name, config);
  throw InputError(InputFault::unknown_name,
                   fmt::format("subject '{}' is unknown; known: lightcuts, "
                               "locally-ordered, block-cuts, paper, stochastic-intensity, those of "
                               "'lightcuts-oracle mutants' as "
                               "mutant:NAME, and plug-ins as ./FILE.so",
                               name));
}

bool is_library(const Subject& subject) { return subject.name() == library; }

} // namespace lightcuts::oracle
