// SPDX-License-Identifier: MIT
#include <oracle/properties/bounds/worst_channel.h>

#include <fmt/format.h>

namespace lightcuts::oracle {

std::string sides_text(const ShadingPoint& point, const Topology& topology, std::uint32_t node,
                       int channel, const char* left, long double value, const char* right,
                       double limit) {
  const std::uint32_t lights = topology.light_count(node);
  return fmt::format("point {}, node {} of {} light{}, channel {}: {} {:.9g}, {} {:.9g}",
                     digits_of(point.position()), node, lights, lights == 1 ? "" : "s",
                     "rgb"[channel], left, static_cast<double>(value), right, limit);
}

} // namespace lightcuts::oracle
