// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>
#include <optional>

#include <oracle/cli/commands.h>

namespace lightcuts::cli {

/// Reads the command line of lightcuts-oracle. `chosen` becomes what it asks for; where that is
/// help or a version, written to `out`, or it is no right one, which is said on `err`, the exit
/// code is returned.
[[nodiscard]] std::optional<int> read_command_line(int argc, const char* const* argv,
                                                   Action& chosen, std::ostream& out,
                                                   std::ostream& err);

} // namespace lightcuts::cli
