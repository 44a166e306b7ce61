// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include <glm/vec3.hpp>
#include <lightcuts/core/geometry/box.h>
#include <oracle/subjects/topology.h>

#include <viz/model/picture/sight.h>

namespace lightcuts::viz {

/// One cluster of a tree as seen from a shading point: a row of the table of a cut.
struct ClusterRow {
  std::uint32_t node = 0;
  std::uint32_t depth = 0; ///< of the root: 0
  std::uint32_t lights = 0;
  glm::dvec3 intensity{0}; ///< total of its lights, W/sr
  /// Index of a light, or unsaid.
  std::uint32_t representative = oracle::TreeClaim::unsaid;
  bool visible = true; ///< whether the representative is seen
  /// How that is known; nothing where nobody has asked, and of clusters beside a cut.
  std::optional<Sight> sight;
  double distance = 0;    ///< from the shading point to the nearest point of the box, metres; 0 for
                          ///< directional lights
  glm::vec3 bound{0};     ///< of the error of the estimate, radiance
  glm::dvec3 estimate{0}; ///< radiance it is taken to contribute
  std::optional<glm::dvec3> truth;     ///< radiance it contributes; nothing until it is known
  double share = 0;                    ///< largest over the channels of
                                       ///< bound / max(threshold * total, black level)
  Box box{glm::vec3(0), glm::vec3(0)}; ///< of the positions of its lights, metres; see has_box
  bool has_box = false;                ///< not of mixed and directional clusters
  /// Metres; of a directional light, a point towards it from the shading point.
  glm::vec3 representative_position{0};
};

/// Sum over the channels of |estimate - truth|, radiance; nothing without a truth, NaN where both
/// are infinite.
[[nodiscard]] inline std::optional<double> error(const ClusterRow& row) {
  if (!row.truth) return std::nullopt;
  const glm::dvec3 difference = row.estimate - *row.truth;
  return std::abs(difference.x) + std::abs(difference.y) + std::abs(difference.z);
}

} // namespace lightcuts::viz
