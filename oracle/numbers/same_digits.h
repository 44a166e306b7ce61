// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <string>

#include <fmt/format.h>

namespace lightcuts::oracle {

/// The double that prints with the float's own few digits: 0.1, not 0.10000000149011612. Rounded to
/// a float it is the float.
[[nodiscard]] inline double same_digits(float value) {
  const std::string text = fmt::format("{}", value);
  double result = value;
  std::from_chars(text.data(), text.data() + text.size(), result);
  return result;
}

} // namespace lightcuts::oracle
