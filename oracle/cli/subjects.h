// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <lightcuts/oracle/subject.h>

namespace lightcuts::cli {

/// The name in full by which files remember a subject: a mutant's gets its "mutant:".
[[nodiscard]] std::string full_name(const std::string& name);

/// "lightcuts", "paper", "mutant:NAME", or a mutant's mere name. Throws InputError, naming it,
/// where there is no such subject.
[[nodiscard]] std::unique_ptr<oracle::Subject> subject_named(const std::string& name);

/// Adds --subject.
void add_subject_option(CLI::App& command, std::string& name);

/// Whether it is the library, of which waste is a failure, too.
[[nodiscard]] bool is_library(const oracle::Subject& subject);

} // namespace lightcuts::cli
