// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include <lightcuts/core/input_error.h>
#include <lightcuts/core/numerics/number_text.h>

#include <lightcuts/render/lighting/kinds/kind_in_scenes.h>

namespace lightcuts {

template <>
struct KindInScenes<LightKind::spot> {
  template <class Element>
  static void read(const Element& light, LightSet& lights) {
    light.expect_keys({"type", "position", "axis", "intensity", "inner", "outer"});
    const float outer = light["outer"].number();
    if (!(outer > 0 && outer <= 180))
      light["outer"].refuse(fault_of(outer), "is " + number_text(outer) +
                                                 ", expected more than 0 and at most 180 degrees");
    const float inner = light.has("inner") ? light["inner"].number(0) : 0;
    if (!(radians(inner) < radians(outer)))
      light["inner"].refuse(InputFault::inconsistent, "is " + number_text(inner) +
                                                          ", expected less than outer, " +
                                                          number_text(outer));
    lights.add_spot(light["position"].vector(), light["axis"].direction(),
                    light["intensity"].colour(), radians(inner), radians(outer));
  }
  static void add(const Light& light, Random& random, LightSet& lights) {
    const float inner = random.between(0.1F, 0.6F);
    const float outer = inner + random.between(0.05F, 0.5F);
    lights.add_spot(light.position, detail::random_axis(random), light.intensity, inner, outer);
  }
  static double power(const Light& light, const Reach& /*reach*/) {
    return full_angle(light) + rim_angle(light);
  }
  static LightRay ray(const Light& light, const glm::dvec2& u, Random& random,
                      const Reach& /*reach*/) {
    return {light.position, at_cosine(detail::unit(light.axis), cosine(light, u.x, random), u.y)};
  }

private:
  // Solid angles, the rim's weighted with t^2: 2 pi times the integral over the cosine.
  static double full_angle(const Light& light) {
    return 2 * std::numbers::pi * (1 - double(light.cos_inner));
  }
  static double rim_angle(const Light& light) {
    return 2 * std::numbers::pi * (double(light.cos_inner) - light.cos_outer) / 3;
  }

  static double cosine(const Light& light, double u, Random& random) {
    const double full = full_angle(light), x = u * (full + rim_angle(light));
    if (x < full) return 1 - x / full * (1 - double(light.cos_inner));
    // The largest of three uniform numbers has the density 3 t^2.
    const double t = std::max({random.unit_double(), random.unit_double(), random.unit_double()});
    return light.cos_outer + t * (double(light.cos_inner) - light.cos_outer);
  }

  static float radians(float degrees) {
    return static_cast<float>(double(degrees) * std::numbers::pi / 180);
  }
};

} // namespace lightcuts
