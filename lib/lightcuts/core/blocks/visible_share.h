// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <lightcuts/core/blocks/block_evidence.h>

namespace lightcuts {

/// Which share of a cluster is seen from the points of a block: the plane over the picture that
/// fits best, by least squares, whether each of those that have looked saw the light it asked for.
class VisibleShare {
public:
  /// places: where the points of the block lie in the picture, pixels.
  void start(std::span<const glm::vec2> places);

  /// A share for each point of the block, in [0, 1]: 0 or 1 where all agree, the mean where few
  /// have looked.
  struct Plane {
    double height = 0;
    glm::dvec2 slope{0};
  };
  [[nodiscard]] Plane fit(const BlockEvidence& evidence, std::size_t place, std::uint32_t node);
  [[nodiscard]] double at(const Plane& plane, std::uint32_t point) const;

private:
  struct Fitted {
    std::uint32_t node = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t lookers = 0;
    Plane plane;
  };

  std::vector<glm::dvec2> places_; ///< from the first
  std::vector<Fitted> fitted_;     ///< by place in the cut
};

} // namespace lightcuts
