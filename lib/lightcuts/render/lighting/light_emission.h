// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/lights/light.h>
#include <lightcuts/render/scene/scene.h>

#include <lightcuts/render/lighting/kinds/kind_in_scenes.h>
#include <lightcuts/render/lighting/random.h>

namespace lightcuts {

/// How lights emit, as far as a mesh can be reached. See VirtualPointLights for the formulas.
class LightEmission {
public:
  explicit LightEmission(const TriangleMesh& mesh);

  /// Power, W per channel.
  [[nodiscard]] glm::dvec3 power(const Light& light) const;

  /// A ray drawn in proportion to the power emitted along it: from a point of the unit square and,
  /// for what needs more of it, chance.
  [[nodiscard]] LightRay ray(const Light& light, const glm::dvec2& u, Random& random) const;

private:
  Reach reach_;
};

} // namespace lightcuts
