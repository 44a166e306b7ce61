// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/core/input_error.h>

#include <lightcuts/render/lighting/kinds/kind_in_scenes.h>
#include <lightcuts/render/lighting/profiles/profile_light.h>

namespace lightcuts {

template <>
struct KindInScenes<LightKind::profile> {
  /// files.luminaire(element) is the IesLuminaire of the file that the element names.
  template <class Element, class Files>
  static void read(const Element& light, LightSet& lights, Files& files) {
    light.expect_keys({"type", "file", "position", "axis", "plane", "multiplier", "efficacy"});
    const float efficacy = light.has("efficacy") ? light["efficacy"].number(0) : 683;
    if (!(efficacy > 0)) light["efficacy"].refuse(InputFault::out_of_domain, "is 0, expected more");
    const glm::vec3 colour = light.has("multiplier") ? light["multiplier"].colour() : glm::vec3(1);
    const glm::vec3 axis = light.has("axis") ? light["axis"].direction() : glm::vec3(0, -1, 0);
    const auto plane =
        plane_beside(axis, light.has("plane") ? light["plane"].direction() : usual_plane(axis));
    if (!plane) light["plane"].refuse(InputFault::inconsistent, "is parallel to the axis");
    const auto luminaire = files.luminaire(light["file"]);
    lights.add_profile(light["position"].vector(), axis, *plane,
                       scaled_intensity(colour, luminaire.peak / efficacy), luminaire.profile);
  }
  static void add(const Light& light, Random& random, LightSet& lights) {
    const glm::vec3 axis = detail::random_axis(random);
    const auto plane = plane_beside(axis, detail::random_direction(random));
    lights.add_profile(light.position, axis, plane ? *plane : usual_plane(axis), light.intensity,
                       street_luminaire());
  }
  static double power(const Light& light, const Reach& /*reach*/) {
    return solid_share(light.profile.table());
  }
  static LightRay ray(const Light& light, const glm::dvec2& u, Random& random,
                      const Reach& /*reach*/) {
    return {light.position, profile_direction(light, u, random)};
  }
};

} // namespace lightcuts
