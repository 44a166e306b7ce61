// SPDX-License-Identifier: MIT
#include <oracle/properties/bounds/worst_channel.h>

#include <fmt/format.h>

namespace lightcuts::oracle {
namespace {

/// Long doubles have some below the range of doubles.
std::string digits_of(long double value, int digits) {
  return fmt::format("{:.{}g}", value, digits);
}

int digits_that_tell(long double value, long double other) {
  int digits = 9;
  while (digits < 21 && digits_of(value, digits) == digits_of(other, digits)) ++digits;
  return value == other ? 9 : digits;
}

} // namespace

std::string sides_text(const ShadingPoint& point, const Topology& topology, std::uint32_t node,
                       int channel, const char* left, long double value, const char* right,
                       long double limit) {
  const std::uint32_t lights = topology.light_count(node);
  const int digits = digits_that_tell(value, limit);
  return fmt::format("point {}, node {} of {} light{}, channel {}: {} {}, {} {}",
                     digits_of(point.position()), node, lights, lights == 1 ? "" : "s",
                     "rgb"[channel], left, digits_of(value, digits), right,
                     digits_of(limit, digits));
}

} // namespace lightcuts::oracle
