// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>

#include <oracle/subjects/plugin_connection.h>
#include <oracle/subjects/subject.h>

namespace lightcuts::oracle {

/// The tree that a plug-in builds. What cannot be read of its answers makes a SubjectFailure.
[[nodiscard]] std::unique_ptr<SubjectTree> plugin_tree(std::shared_ptr<PluginConnections> plugin,
                                                       const LightSet& lights, std::uint64_t seed);

} // namespace lightcuts::oracle
