// SPDX-License-Identifier: MIT
#include <oracle/numbers/hex_float.h>

#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace lightcuts::oracle {

// As a double: a subnormal float has a leading 1, too.
std::string hex_text(float value) { return fmt::format("{:a}", double(value)); }

std::optional<float> hex_float(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  if (!text.starts_with("0x")) return std::nullopt;
  text.remove_prefix(2);
  if (text.starts_with('-')) return std::nullopt;
  float value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value, std::chars_format::hex);
  if (error != std::errc() || rest != end || !std::isfinite(value)) return std::nullopt;
  return negative ? -value : value;
}

} // namespace lightcuts::oracle
