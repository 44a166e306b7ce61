// SPDX-License-Identifier: MIT
#pragma once

#include <variant>

#include <glm/vec3.hpp>
#include <lightcuts/core/kernels/transfer.h>
#include <oracle/truth/lobes.h>

namespace lightcuts::oracle {

/// f n.l n.v with light from l seen from v, and with light from v seen from l.
struct BothWays {
  glm::dvec3 there{0}, back{0};
  glm::dvec3 allowed{0}; ///< what rounding may make of the difference; see both_ways()
};

/// Evaluates the material both ways; n, l and v are unit vectors, l and v above the surface.
/// allowed: transfer_error of each, what is below its domain, and what the lobe
/// loses to the rounding of its inputs.
[[nodiscard]] inline BothWays both_ways(const Material& material, const glm::vec3& n,
                                        const glm::vec3& l, const glm::vec3& v) {
  const ShadingPoint from_v(glm::vec3(0), n, v, material), from_l(glm::vec3(0), n, l, material);
  const auto sun = [](const glm::vec3& direction) {
    return Light{.kind = LightKind::directional, .position = direction};
  };
  BothWays ways;
  const double light_cosine = from_l.viewer_cosine(), viewer_cosine = from_v.viewer_cosine();
  ways.there = transfer(from_v, sun(l)) * viewer_cosine;
  ways.back = transfer(from_l, sun(v)) * light_cosine;
  ways.allowed = std::visit(
      [&]<class OneLobe>(const OneLobe& lobe) {
        return radiometry::LobeTruth<OneLobe>::input_rounding(lobe, from_v, l) *
               (light_cosine * viewer_cosine);
      },
      material.lobe);
  // The cosine that is multiplied here has an error of dot_error and a few roundings.
  ways.allowed += (ways.there + ways.back) * (transfer_error + 2 * dot_error) + least_transfer;
  return ways;
}

} // namespace lightcuts::oracle
