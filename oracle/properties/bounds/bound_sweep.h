// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <oracle/properties/point_case.h>
#include <oracle/truth/fast_truth.h>

namespace lightcuts::oracle {

/// Checks bound-dominates-contribution for all clusters of a tree at once: what FastTruth cannot
/// decide is decided as the property itself does it. One per thread.
class BoundSweep {
public:
  /// Both must outlive the sweep.
  BoundSweep(const Topology& topology, const LightSet& lights);

  /// Whether the lights and the material are such that it can be done.
  [[nodiscard]] bool supports(const Material& material) const {
    return truth_ && FastTruth::supports({}, material);
  }
  /// The material at the point is one that it supports.
  void check(SubjectTree& tree, const ShadingPoint& point, std::uint64_t place, Tally& tally);

private:
  const Topology& topology_;
  const LightSet& lights_;
  std::optional<FastTruth> truth_;
  std::vector<glm::vec3> bounds_;
  FastComparison comparison_;
};

} // namespace lightcuts::oracle
