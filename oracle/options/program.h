// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace lightcuts::options {

/// Exit codes of the programs.
enum Exit { all_holds = 0, violated = 1, usage = 2, bad_input = 3, internal_error = 4 };

/// What main() returns: the exit code of `work`. Of an InputError, or where memory did not suffice
/// for what was asked, bad_input, and internal_error of any other exception; that is then said on
/// stderr in one line that begins with the program's name, or not at all where stderr cannot be
/// written. A standard stream that is closed stays so, but no file that is opened takes its place.
[[nodiscard]] int run_program(const char* name, const std::function<int()>& work);

} // namespace lightcuts::options
