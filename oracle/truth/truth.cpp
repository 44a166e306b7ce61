// SPDX-License-Identifier: MIT
#include <oracle/truth/truth.h>

#include <oracle/truth/radiometry.h>

namespace lightcuts::oracle {

Wide contribution(const Light& light, const ShadingPoint& point, float min_distance) {
  return radiometry::contribution<long double>(light, point, min_distance);
}

Exact exact_contribution(const Light& light, const ShadingPoint& point, float min_distance,
                         int channel) {
  return radiometry::contribution<Exact>(light, point, min_distance)[std::size_t(channel)];
}

void Truth::evaluate(const Topology& topology, const LightSet& lights, const ShadingPoint& point,
                     std::span<const char> visible) {
  topology_ = &topology;
  lights_ = &lights;
  point_ = &point;
  visible_ = visible;
  of_lights_.assign(lights.size(), Wide{});
  open_.assign(topology.size(), Wide{});
  seen_.assign(topology.size(), Wide{});
  const auto add = [](Wide& sum, const Wide& term) {
    for (std::size_t c = 0; c < 3; ++c) sum[c] += term[c];
  };
  const auto nodes = topology.parents_first();
  for (auto i = nodes.rbegin(); i != nodes.rend(); ++i) {
    for (const std::uint32_t light : topology.lights(*i)) {
      const Wide one = contribution(lights[light], point, lights.min_distance());
      of_lights_[light] = one;
      add(open_[*i], one);
      if (visible[light] != 0) add(seen_[*i], one);
    }
    for (const std::uint32_t child : topology.children(*i)) {
      add(open_[*i], open_[child]);
      add(seen_[*i], seen_[child]);
    }
  }
}

Exact Truth::exact(std::uint32_t node, int channel, bool only_visible) const {
  Exact sum = 0;
  for (const std::uint32_t light : topology_->all_lights(node))
    if (!only_visible || visible_[light] != 0)
      sum += exact_contribution((*lights_)[light], *point_, lights_->min_distance(), channel);
  return sum;
}

} // namespace lightcuts::oracle
