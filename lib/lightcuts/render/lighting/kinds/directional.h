// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/render/lighting/kinds/kind_in_scenes.h>

namespace lightcuts {

template <>
struct KindInScenes<LightKind::directional> {
  template <class Element>
  static void read(const Element& light, LightSet& lights) {
    light.expect_keys({"type", "direction", "irradiance"});
    lights.add_directional(light["direction"].direction(), light["irradiance"].colour());
  }
  /// From a cloud's open side, as bright as from a distance of two metres.
  static void add(const Light& light, Random& random, LightSet& lights) {
    const glm::vec3 d = detail::random_direction(random);
    lights.add_directional(-glm::abs(d), 0.25F * light.intensity);
  }
  static double power(const Light& /*light*/, const Reach& reach) {
    return std::numbers::pi * reach.radius * reach.radius;
  }
  static LightRay ray(const Light& light, const glm::dvec2& u, Random& /*random*/,
                      const Reach& reach) {
    const glm::dvec3 towards = detail::unit(light.position);
    const glm::dvec3 on_disc = about(towards, reach.radius * std::sqrt(u.x), u.y);
    // A little farther than the sphere, so that nothing of the scene is behind.
    return {glm::vec3(reach.centre + on_disc + 1.01 * reach.radius * towards), -towards};
  }
};

} // namespace lightcuts
