// SPDX-License-Identifier: MIT
#include <oracle/report/plots/log_axis.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace lightcuts::oracle {
namespace {

// gnuplot formats tick labels once more: "%%" is a percent sign.
std::string ticks(double low, double high, const std::string& unit) {
  const double decades = std::log10(high / low);
  const std::vector<int> digits = decades < 3 ? std::vector{1, 2, 5} : std::vector{1};
  const int step = std::max(1, static_cast<int>(decades / 8));
  std::string list;
  for (int e = static_cast<int>(std::floor(std::log10(low))); std::pow(10, e) <= high; e += step)
    for (const int digit : digits) {
      const double at = digit * std::pow(10, e);
      if (at < low || at > high) continue;
      list += fmt::format("{}'{:.6g}{}' {:.17g}", list.empty() ? "" : ", ", at, unit, at);
    }
  return list;
}

} // namespace

bool LogAxis::include(double value) {
  if (!(value > 0) || !std::isfinite(value)) return false;
  low_ = low_ == 0 ? value : std::min(low_, value);
  high_ = std::max(high_, value);
  return true;
}

std::string LogAxis::commands(const std::string& axis, const std::string& unit) const {
  // Half a decade on each side of a single value, so that there are ticks beside it.
  const double room = low_ == 0 ? 1 : std::max(1.6, std::sqrt(10 * low_ / high_));
  const double low = low_ == 0 ? 0.1 : low_ / room;
  const double high = low_ == 0 ? 1 : high_ * room;
  return fmt::format("set logscale {0}\nset {0}range [{1:.17g}:{2:.17g}]\nset {0}tics ({3})\n",
                     axis, low, high, ticks(low, high, unit));
}

} // namespace lightcuts::oracle
