// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>

#include <tests/oracle/support/judged_point.h>

namespace lightcuts::oracle {

/// Draws each light of a cluster alike; `bend` changes the probability that is stated of a light,
/// `redraw` what sample() makes of it.
class UniformSampling : public LibraryTree {
public:
  using LibraryTree::LibraryTree;
  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    return std::make_unique<UniformSampling>(*this);
  }
  std::function<double(std::uint32_t light, double p)> bend = [](std::uint32_t, double p) {
    return p;
  };
  std::function<DrawnLight(DrawnLight)> redraw = [](DrawnLight drawn) { return drawn; };

  double probability(std::uint32_t node, const ShadingPoint&, std::uint32_t light) override {
    return bend(light, 1.0 / tree().node(node).light_count);
  }
  DrawnLight sample(std::uint32_t node, const ShadingPoint& point, double u) override {
    const auto topology = read_topology(claim(), tree().lights().size()).topology.value();
    const auto lights = topology.all_lights(node);
    const std::uint32_t light = lights[std::size_t(u * double(lights.size()))];
    return redraw({light, probability(node, point, light)});
  }
};

} // namespace lightcuts::oracle
