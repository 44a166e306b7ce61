// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/render/lighting/kinds/kind_in_scenes.h>

namespace lightcuts {

template <>
struct KindInScenes<LightKind::oriented> {
  template <class Element>
  static void read(const Element& light, LightSet& lights) {
    light.expect_keys({"type", "position", "normal", "intensity"});
    lights.add_oriented(light["position"].vector(), light["normal"].direction(),
                        light["intensity"].colour());
  }
  static void add(const Light& light, Random& random, LightSet& lights) {
    lights.add_oriented(light.position, detail::random_axis(random), light.intensity);
  }
  static double power(const Light& /*light*/, const Reach& /*reach*/) { return std::numbers::pi; }

  /// Off the surface on which the light lies, as far as surface_point() would for a triangle as
  /// large as the scene.
  static LightRay ray(const Light& light, const glm::dvec2& u, Random& /*random*/,
                      const Reach& reach) {
    const glm::dvec3 axis = detail::unit(light.axis);
    const glm::dvec3 off = glm::dvec3(light.position) + 0x1p-17 * reach.radius * axis;
    return {glm::vec3(off), square_to_cosine(axis, u)};
  }
};

} // namespace lightcuts
