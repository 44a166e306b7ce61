// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/render/images/environment_map.h>

namespace lightcuts {

/// An environment map as it is seen: each direction has the radiance of the pixel that it passes
/// through. The same bits everywhere: no arc is computed, edges of pixels are compared.
class Backdrop {
public:
  /// A valid map, turned about +y as EnvironmentLights::turn says.
  Backdrop(EnvironmentMap map, double turn);

  /// W/(m^2 sr); a direction of any length but 0. Where it passes within rounding of an edge, that
  /// of either side.
  [[nodiscard]] glm::vec3 radiance(const glm::vec3& direction) const;

private:
  EnvironmentMap map_;
  std::vector<double> row_cosines_;     ///< of the upper edges' polar angles: descending
  std::vector<glm::dvec2> column_ends_; ///< cosine and sine from +z towards +x, of right edges
};

} // namespace lightcuts
