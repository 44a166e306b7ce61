// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <oracle/properties/point_case.h>

namespace lightcuts::oracle {

/// With which probabilities a subject draws the lights of a cluster at a point.
struct ClusterOdds {
  const PointAnswers& point;
  std::uint32_t node;
  std::vector<std::uint32_t> lights;
  std::vector<double> p;   ///< per light
  std::vector<Wide> light; ///< contribution per light, if all were seen
  std::vector<int> levels; ///< per light: choices that lead from the cluster to it

  ClusterOdds(const PointAnswers& answers, std::uint32_t node);

  [[nodiscard]] bool shines(std::size_t i) const {
    return light[i][0] != 0 || light[i][1] != 0 || light[i][2] != 0;
  }
  /// Where the light with that index stands in the lists; their size where it is of another
  /// cluster.
  [[nodiscard]] std::size_t place_of(std::uint32_t index) const;
  /// The probability that no light is drawn.
  [[nodiscard]] double none() const;
};

} // namespace lightcuts::oracle
