// SPDX-License-Identifier: MIT
#include <oracle/cases/catalogue/making.h>

namespace lightcuts::oracle::making {
namespace {

const glm::vec3 slanted = unit({0.6, 0, 0.8});

/// About the mirror direction of the viewer: some on it, some beside.
Case seen_in_mirror(const Lobe& lobe, const glm::vec3& diffuse = glm::vec3(0.1F)) {
  return lit(lights(40,
                    [](int i, auto& dice) {
                      const glm::dvec3 mirror(-slanted.x, 0, slanted.z);
                      const double off = i % 4 == 0 ? 0 : std::pow(10.0, -i % 7);
                      return omni(glm::vec3(2.0 * mirror + off * glm::dvec3(dice.in_cube())));
                    }),
             {{.to_viewer = slanted, .material = {diffuse, lobe}}});
}
Case phong_of_1e6() { return seen_in_mirror(Phong{glm::vec3(0.9F), 1e6F}); }
Case phong_of_0() { return seen_in_mirror(Phong{glm::vec3(0.9F), 0}); }
Case ward_of_1e_4() { return seen_in_mirror(Ward{glm::vec3(0.9F), 1e-4F}); }
Case cook_torrance_of_1e_4() { return seen_in_mirror(CookTorrance{glm::vec3(0.9F), 1e-4F}); }
Case rough_cook_torrance() { return seen_in_mirror(CookTorrance{glm::vec3(0), 1}); }
Case no_diffuse() { return seen_in_mirror(Ward{glm::vec3(0.5F), 0.01F}, glm::vec3(0)); }
Case black() { return seen_in_mirror(Phong{glm::vec3(0), 10}, glm::vec3(0)); }

/// Viewer and lights mirror each other so low above the surface.
Case grazing(const Lobe& lobe, double sine) {
  return lit(lights(30,
                    [sine](int i, auto& dice) {
                      const double turn = i % 3 == 0 ? 0 : sine * dice.uniform(-4, 4);
                      const double high = sine * (i % 2 == 0 ? 1 : dice.uniform(0.5, 2));
                      return omni(glm::vec3(-1, turn, high));
                    }),
             {{.to_viewer = glm::vec3(1, 0, sine), .material = {glm::vec3(0), lobe}}});
}
Case ward_at_2_minus_20() { return grazing(Ward{glm::vec3(1), 0.1F}, 0x1p-20); }
Case ward_at_2_minus_140() { return grazing(Ward{glm::vec3(1), 0.1F}, 0x1p-140); }
Case cook_torrance_at_2_minus_20() { return grazing(CookTorrance{glm::vec3(0.5F), 0.1F}, 0x1p-20); }
Case cook_torrance_at_2_minus_140() {
  return grazing(CookTorrance{glm::vec3(0.5F), 0.1F}, 0x1p-140);
}
Case phong_at_2_minus_20() { return grazing(Phong{glm::vec3(1), 1e5F}, 0x1p-20); }

constexpr NamedCase lobe_cases[] = {
    {"phong-of-1e6",
     "A peak of 0.1 degrees: a bound that misses the mirror direction by that is wrong.",
     phong_of_1e6},
    {"phong-of-0", "cos^0 is 1 up to the horizon of the mirror direction, and 0 beyond.",
     phong_of_0},
    {"ward-of-1e-4", "A peak of 10^-4 rad, 10^7 high, next to nothing beside it.", ward_of_1e_4},
    {"cook-torrance-of-1e-4", "A peak of 10^-4 rad with a long tail.", cook_torrance_of_1e_4},
    {"rough-cook-torrance", "Roughness 1 and f0 = 0: all is Fresnel's, towards the horizon.",
     rough_cook_torrance},
    {"no-diffuse", "What is not in the lobe is 0: relative errors have nothing to hide behind.",
     no_diffuse},
    {"black", "The surface reflects nothing: 0 times an infinite bound is 0.", black},
    {"ward-at-2^-20", "Viewer and lights mirror each other 10^-6 above the surface: l + v cancels.",
     ward_at_2_minus_20},
    {"ward-at-2^-140",
     "Viewer and lights are a subnormal above the surface: 1/sqrt(n.l n.v) is 10^42.",
     ward_at_2_minus_140},
    {"cook-torrance-at-2^-20", "Masking and Fresnel's term at 10^-6 above the surface.",
     cook_torrance_at_2_minus_20},
    {"cook-torrance-at-2^-140", "Viewer and lights are a subnormal above the surface.",
     cook_torrance_at_2_minus_140},
    {"phong-at-2^-20", "Half of a sharp peak is below the horizon.", phong_at_2_minus_20},
};

} // namespace

std::span<const NamedCase> lobes() { return lobe_cases; }

} // namespace lightcuts::oracle::making
