// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/render/lighting/kinds/kind_in_scenes.h>

namespace lightcuts {

template <>
struct KindInScenes<LightKind::omni> {
  template <class Element>
  static void read(const Element& light, LightSet& lights) {
    light.expect_keys({"type", "position", "intensity"});
    lights.add_omni(light["position"].vector(), light["intensity"].colour());
  }
  static void add(const Light& light, Random& /*random*/, LightSet& lights) { lights.add(light); }
  static double power(const Light& /*light*/, const Reach& /*reach*/) {
    return 4 * std::numbers::pi;
  }
  static LightRay ray(const Light& light, const glm::dvec2& u, Random& /*random*/,
                      const Reach& /*reach*/) {
    return {light.position, at_cosine({0, 1, 0}, 1 - 2 * u.x, u.y)};
  }
};

} // namespace lightcuts
