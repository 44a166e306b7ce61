// SPDX-License-Identifier: MIT
#include <oracle/report/pages/report_numbers.h>

#include <cmath>

#include <fmt/format.h>

namespace lightcuts::oracle {
std::string three_digits(double value) {
  const double size = std::abs(value);
  if (value == 0) return "0";
  if (!std::isfinite(value)) return fmt::format("{}", value);
  if (size < 0.0005 || size >= 999999.5) return fmt::format("{:.0e}", value);
  if (size < 0.01) return fmt::format("{:.4f}", value);
  if (size < 0.1) return fmt::format("{:.3f}", value);
  return fmt::format("{:.{}f}", value, size < 9.995 ? 2 : size < 99.95 ? 1 : 0);
}

std::string percent(double share) {
  const double value = 100 * share;
  if (value == 0 || !std::isfinite(value)) return fmt::format("{} %", value);
  const double size = std::abs(value);
  if (size < 0.0005 || size >= 9999.5) return fmt::format("{:.0e} %", value);
  if (size < 0.01) return fmt::format("{:.3f} %", value);
  return fmt::format("{:.{}f} %", value, size < 9.995 ? 2 : size < 99.95 ? 1 : 0);
}

std::string share_of(std::uint64_t count, std::uint64_t all) {
  return all == 0 ? "-" : percent(static_cast<double>(count) / static_cast<double>(all));
}

std::string threshold_text(const Run& run) {
  return is_reference(run) ? "-" : fmt::format("{:.3g} %", 100 * run.threshold);
}

std::string number(double value) {
  const double size = std::abs(value);
  if (!(size < 9999999.5)) return fmt::format("{:.1e}", value);
  return fmt::format("{:.{}f}", value, size == std::floor(size) || size >= 999.95 ? 0 : 1);
}

std::string grouped(std::uint64_t value) {
  std::string text = std::to_string(value);
  for (std::size_t i = text.size(); i > 3;) text.insert(i -= 3, 1, ' ');
  return text;
}

bool is_reference(const Run& run) { return run.method == "reference"; }

} // namespace lightcuts::oracle
