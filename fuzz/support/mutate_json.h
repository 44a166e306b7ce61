// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <fuzz/support/target.h>

namespace lightcuts::fuzz {

/// JSON, changed value by value, so that it stays JSON: numbers become others, among them the least
/// and largest that files may have, values and keys are taken from elsewhere in it, left out, or
/// repeated. What is no JSON is changed bytewise.
[[nodiscard]] std::string mutated_json(const std::string& input, gen::Dice& dice,
                                       const Bytewise& bytewise);

} // namespace lightcuts::fuzz
