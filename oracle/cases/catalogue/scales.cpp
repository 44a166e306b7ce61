// SPDX-License-Identifier: MIT
#include <oracle/cases/catalogue/making.h>

namespace lightcuts::oracle::making {
namespace {

Case intensities_of_all_scales() {
  return lit(lights(77, [](int i, auto& dice) {
    return omni(about(dice, {0, 0, 1.5F}), glm::vec3(std::pow(10.0, i - 38)));
  }));
}

Case distances_of_all_scales() {
  return lit(lights(41, [](int i, auto& dice) {
    return omni(
        glm::vec3(std::pow(10.0, i - 20) * glm::normalize(glm::dvec3(about(dice, {0, 0, 1.5F})))));
  }));
}

Case distances_made_up_for() {
  return lit(lights(37, [](int i, auto& dice) {
    const double d = std::pow(10.0, i - 18);
    return omni(glm::vec3(d * glm::normalize(glm::dvec3(about(dice, {0, 0, 1.5F})))),
                glm::vec3(d * d));
  }));
}

Case largest_intensities() {
  return lit(lights(20, [](int, auto& dice) {
    return omni(about(dice, {0, 0, 1.5F}), glm::vec3(largest, largest, 1));
  }));
}

Case subnormal_positions() {
  return lit(lights(30, [](int, auto& dice) {
    return omni({dice.subnormal(), dice.subnormal(), std::abs(dice.subnormal())}, glm::vec3(least));
  }));
}

Case subnormal_intensities() {
  return lit(lights(30, [](int i, auto& dice) {
    return omni(about(dice, {0, 0, 1.5F}), float(i + 1) * glm::vec3(least, 2 * least, 0x1p-126F));
  }));
}

Case subnormal_reflectance() {
  return lit(lights(20,
                    [](int, auto& dice) {
                      return omni(about(dice, {0, 0, 1.5F}));
                    }),
             {{.material = {glm::vec3(least), Phong{glm::vec3(least, 0, 1), 8}}}});
}

Case millimetres_at_1e8() {
  return lit(lights(40,
                    [](int, auto& dice) {
                      const glm::dvec3 aside = 1e-3 * glm::dvec3(dice.in_cube());
                      return omni({1e8F, float(aside.y), float(aside.z)}, glm::vec3(1e-6F));
                    }),
             {{.position = {1e8F, 0, -2e-3F}}});
}

Case lattice_at_1e8() {
  return lit(lights(60,
                    [](int, auto& dice) {
                      return omni(glm::vec3(1e8F) + 8.0F * dice.lattice(2), glm::vec3(100));
                    }),
             {{.position = glm::vec3(1e8F)}});
}

Case flat_box() {
  return lit(lights(50, [](int, auto& dice) {
    const glm::dvec3 p = dice.in_cube();
    return omni(glm::vec3(1e7 * p.x, p.y, p.z + 1.5), glm::vec3(1e6F));
  }));
}

Case clamped(float min_distance) {
  Case c = lit(lights(30, [](int, auto& dice) { return omni(about(dice, {0, 0, 0.5F})); }));
  c.min_distance = min_distance;
  return c;
}
Case clamp_of_1e30() { return clamped(1e30F); }
Case least_clamp() { return clamped(least); }
Case clamp_of_the_distance() { return clamped(0.5F); }

Case a_light_for_each_colour() {
  return lit(lights(60, [](int i, auto& dice) {
    glm::vec3 colour(0);
    colour[i % 3] = i % 3 == 0 ? 1e30F : i % 3 == 1 ? 1 : 1e-30F;
    return omni(about(dice, {0, 0, 1.5F}), colour);
  }));
}

Case near_one_of_two_clumps() {
  return lit(lights(60,
                    [](int i, auto& dice) {
                      const bool far = i % 2 == 1;
                      return omni(about(dice, {0, 0, far ? 1e6F : 1e-6F}, far ? 1 : 1e-7),
                                  glm::vec3(far ? 1e12F : 1e-12F));
                    }),
             {{}});
}

constexpr NamedCase scale_cases[] = {
    {"intensities-of-all-scales",
     "One cluster has intensities from 10^-38 to 10^38: what is added to the largest is lost.",
     intensities_of_all_scales},
    {"distances-of-all-scales",
     "Lights are 10^-20 to 10^20 away: squares of that leave the range of floats at both ends.",
     distances_of_all_scales},
    {"distances-made-up-for",
     "Lights from 10^-18 to 10^18 away contribute alike: no cluster of a few scales is small "
     "beside the total.",
     distances_made_up_for},
    {"largest-intensities",
     "Intensities are the largest float: sums of them are no float any more.", largest_intensities},
    {"subnormal-positions",
     "All lights are within 100 steps of the least float: 1/d^2 exceeds 10^80.",
     subnormal_positions},
    {"subnormal-intensities",
     "Intensities have few bits: rounding to nearest may lose all of a light.",
     subnormal_intensities},
    {"subnormal-reflectance",
     "The surface reflects the least float: a bound that underflows to 0 is none.",
     subnormal_reflectance},
    {"millimetres-at-1e8",
     "In one coordinate everything is 10^8 from the origin, in the others a millimetre apart.",
     millimetres_at_1e8},
    {"lattice-at-1e8",
     "10^8 from the origin floats are 8 m apart: centres of boxes cannot be told.", lattice_at_1e8},
    {"flat-box", "Boxes are 10^7 times as long as wide: a sphere around them says nothing.",
     flat_box},
    {"clamp-of-1e30", "All distances are clamped to 10^30, whose square is no float.",
     clamp_of_1e30},
    {"least-clamp", "Distances are clamped to the least float, whose square is 0 in floats.",
     least_clamp},
    {"clamp-of-the-distance",
     "Half of the lights are nearer than the clamp, and clusters have both.",
     clamp_of_the_distance},
    {"a-light-for-each-colour",
     "Each channel has lights of its own, 10^30 apart: one representative stands for all three.",
     a_light_for_each_colour},
    {"near-one-of-two-clumps", "Two clumps contribute alike, one 10^6 m away, the other 10^-6.",
     near_one_of_two_clumps},
};

} // namespace

std::span<const NamedCase> scales() { return scale_cases; }

} // namespace lightcuts::oracle::making
