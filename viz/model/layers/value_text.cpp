// SPDX-License-Identifier: MIT
#include <viz/model/layers/value_text.h>

#include <cmath>

#include <fmt/format.h>

namespace lightcuts::viz {
namespace {

/// 1.2e-05 and 1.2e+06 become 1.2e-5 and 1.2e6.
std::string with_short_exponent(const std::string& text) {
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  const std::size_t digits = text.find_first_not_of("+-0", e + 1);
  return text.substr(0, e + 1) + (text[e + 1] == '-' ? "-" : "") + text.substr(digits);
}

/// 1.200e-05 becomes 1.2e-05.
std::string without_trailing_zeros(std::string text) {
  const std::size_t e = text.find('e');
  const std::size_t last = text.find_last_not_of('0', e - 1);
  return text.replace(last + (text[last] == '.' ? 0 : 1), e - last - (text[last] == '.' ? 0 : 1),
                      "");
}

/// "1 min 20 s"; nothing is said of a part that is 0.
std::string two_parts(long large, const char* large_unit, long small, const char* small_unit) {
  const std::string text = fmt::format("{} {}", large, large_unit);
  return small == 0 ? text : fmt::format("{} {} {}", text, small, small_unit);
}

} // namespace

std::string short_text(double value) {
  if (std::isnan(value)) return "nan"; // whatever its sign
  const double size = std::abs(value);
  if (size >= 9999.5 && size < 999999.5) return fmt::format("{:.0f}", value);
  if (size > 0 && size < 1e-3)
    return with_short_exponent(without_trailing_zeros(fmt::format("{:.3e}", value)));
  if (value == 0) return "0"; // whatever its sign
  return with_short_exponent(fmt::format("{:.4g}", value));
}

std::string rgb_text(const glm::dvec3& value) {
  std::string r = short_text(value.x);
  const std::string g = short_text(value.y), b = short_text(value.z);
  if (r == g && g == b) return r;
  return fmt::format("{} {} {}", r, g, b);
}

std::string duration_text(double seconds) {
  if (!(seconds < 1e9)) return short_text(seconds) + " s";
  if (seconds < 0.0995) return with_short_exponent(fmt::format("{:.2g} ms", 1e3 * seconds));
  if (seconds < 59.5) return fmt::format("{:.2g} s", seconds);
  const long whole = std::lround(seconds);
  if (whole < 3600) return two_parts(whole / 60, "min", whole % 60, "s");
  const long minutes = std::lround(seconds / 60);
  return two_parts(minutes / 60, "h", minutes % 60, "min");
}

} // namespace lightcuts::viz
