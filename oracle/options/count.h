// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

namespace lightcuts::options {

/// "1000", or "1e9" for 1000000000: digits, and maybe an exponent of digits. Exact; nothing for any
/// other text, 0, or 2^64 and more.
[[nodiscard]] constexpr std::optional<std::uint64_t> parse_count(std::string_view text) {
  constexpr std::uint64_t largest = std::numeric_limits<std::uint64_t>::max();
  const std::size_t e = text.find_first_of("eE");
  const auto number = [](std::string_view digits) -> std::optional<std::uint64_t> {
    std::uint64_t value = 0;
    for (const char c : digits) {
      const auto digit = std::uint64_t(c - '0');
      if (c < '0' || c > '9' || value > (largest - digit) / 10) return std::nullopt;
      value = 10 * value + digit;
    }
    return digits.empty() ? std::nullopt : std::optional(value);
  };
  const auto mantissa = number(text.substr(0, e));
  const auto exponent = e == text.npos ? std::uint64_t{0} : number(text.substr(e + 1));
  if (!mantissa || !exponent || *mantissa == 0) return std::nullopt;
  std::uint64_t value = *mantissa;
  for (std::uint64_t i = 0; i < *exponent; ++i) {
    if (value > largest / 10) return std::nullopt;
    value *= 10;
  }
  return value;
}

/// "90", "90s", "10m" or "2h" in seconds: a whole number and maybe a unit; nothing for any other
/// text, 0, or more than 10^9 seconds.
[[nodiscard]] constexpr std::optional<double> parse_duration(std::string_view text) {
  double unit = 1;
  if (!text.empty() && (text.back() == 's' || text.back() == 'm' || text.back() == 'h')) {
    unit = text.back() == 's' ? 1 : text.back() == 'm' ? 60 : 3600;
    text.remove_suffix(1);
  }
  const auto number = parse_count(text);
  if (!number || double(*number) * unit > 1e9) return std::nullopt;
  return double(*number) * unit;
}

/// "512MiB" or "4GiB" in bytes: a whole number and KiB, MiB, GiB or TiB; nothing for any other
/// text, 0, or 2^63 bytes and more.
[[nodiscard]] constexpr std::optional<std::uint64_t> parse_memory(std::string_view text) {
  constexpr std::string_view units = "KMGT";
  if (text.size() < 3 || !text.ends_with("iB")) return std::nullopt;
  const std::size_t unit = units.find(text[text.size() - 3]);
  const auto number = parse_count(text.substr(0, text.size() - 3));
  if (unit == units.npos || !number) return std::nullopt;
  const std::size_t shift = 10 * (unit + 1);
  if (*number >> (63 - shift) != 0) return std::nullopt;
  return *number << shift;
}

} // namespace lightcuts::options
