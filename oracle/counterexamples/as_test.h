// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <oracle/counterexamples/counterexample_json.h>

namespace lightcuts::oracle {

/// C++ statements that make the case, to the bit, as a variable `on`.
[[nodiscard]] std::string statements_for(const Case& on);

/// A C++ file with one GoogleTest case, to be linked with lightcuts::oracle: the case with exact
/// floats, and that the property holds on it for the subject of that name, which may be a plug-in.
/// Of a mutant, that it is convicted, and the library is not.
[[nodiscard]] std::string as_test(const SavedCounterexample& saved);

} // namespace lightcuts::oracle
