// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lightcuts::oracle {

/// "0x1.8p+1" for 3: every bit, and as C++ takes it.
[[nodiscard]] std::string hex_text(float value);

/// The number that a text such as "0x1.8p+1" stands for, rounded to nearest where the text has more
/// bits; nothing where it is no such text, or beyond the largest float.
[[nodiscard]] std::optional<float> hex_float(std::string_view text);

} // namespace lightcuts::oracle
