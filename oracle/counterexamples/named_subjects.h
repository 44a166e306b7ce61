// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include <oracle/subjects/plugin_subject.h>
#include <oracle/subjects/subject.h>

namespace lightcuts::oracle {

/// "lightcuts", "locally-ordered", "paper", "stochastic-intensity", "mutant:NAME", a mutant's mere
/// name, or the file of a plug-in, which the configuration is for: what has a slash or ends in
/// ".so". Throws InputError, naming it, where there is no such subject.
[[nodiscard]] std::unique_ptr<Subject> subject_named(const std::string& name,
                                                     const PluginConfig& config = {});

/// The name in full by which files remember a subject: a mutant's gets its "mutant:", a plug-in's
/// file the folder that it is in, from the root.
[[nodiscard]] std::string full_subject_name(const std::string& name);

/// Whether it is the library, of which waste is a failure, too.
[[nodiscard]] bool is_library(const Subject& subject);

} // namespace lightcuts::oracle
