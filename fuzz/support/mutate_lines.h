// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <fuzz/support/target.h>

namespace lightcuts::fuzz {

/// Statements, one on a line, changed as such: lines go, come again or change places; words become
/// those of other lines, or numbers that files may have.
[[nodiscard]] std::string mutated_lines(const std::string& input, gen::Dice& dice,
                                        const Bytewise& bytewise);

} // namespace lightcuts::fuzz
