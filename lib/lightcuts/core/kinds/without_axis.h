// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <lightcuts/core/geometry/difference_box.h>
#include <lightcuts/core/lights/light.h>
#include <lightcuts/core/tree/cluster_emission.h>

namespace lightcuts {

/// What kinds of light have in common that send all their intensity everywhere.
struct WithoutAxis {
  static double emission(const Light& /*light*/, const glm::vec3& /*x*/) { return 1; }
  static double max_emission(const ClusterEmission& /*e*/, const DifferenceBox& /*q*/) { return 1; }
  static double min_emission(const ClusterEmission& /*e*/, const DifferenceBox& /*q*/) { return 1; }
  static double mean_emission(const ClusterEmission& /*e*/, const Light& /*representative*/,
                              const glm::vec3& /*centroid*/, const glm::vec3& /*x*/) {
    return 1;
  }
};

} // namespace lightcuts
