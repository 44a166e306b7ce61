// SPDX-License-Identifier: MIT
#include <oracle/cases/catalogue/making.h>

namespace lightcuts::oracle::making {
namespace {

std::vector<Light> above() {
  return lights(40, [](int, auto& dice) { return omni(about(dice, {0, 0, 1.5F})); });
}
/// In a box one metre along x, and on the edge of it that faces the point, or a step beside.
std::vector<Light> beside() {
  return lights(40, [](int i, auto& dice) {
    const glm::vec3 p = about(dice, {1.5F, 0, 0.5F}, 0.5);
    if (i % 2 == 0) return omni(p);
    const int step = i / 2 % 3;
    return omni({1, p.y, step == 0 ? 1 : std::nextafter(1.0F, step == 1 ? 2.0F : 0.0F)});
  });
}

gen::View facing(const glm::vec3& normal, const glm::vec3& viewer) {
  return {.normal = normal,
          .to_viewer = viewer,
          .material = {glm::vec3(0.5F), CookTorrance{glm::vec3(0.04F), 0.2F}}};
}

/// The highest corners are at the horizon, one step above and one below.
Case normal_grazes_the_box() {
  return lit(beside(),
             {facing(unit({-1, 0, 1}), {0, 0, 1}), facing(unit({-1, 0, 1.0000001}), {0, 0, 1}),
              facing(unit({-1.0000001, 0, 1}), {0, 0, 1})});
}
Case normal_opposes() { return lit(above(), {facing({0, 0, -1}, {0, 0, -1})}); }
Case normal_on_an_axis() { return lit(above(), {facing({0, 1, 0}, {0, 1, 0})}); }
Case normal_beside_an_axis() {
  return lit(above(), {facing({0, 1, least}, {0, 1, least}), facing({least, 1, -least}, {0, 1, 0}),
                       facing({0, std::nextafter(1.0F, 0.0F), 0x1p-24F}, {0, 1, 0})});
}
Case viewed_from_behind() { return lit(above(), {facing({0, 0, 1}, {0, 0, -1})}); }
Case viewed_along_the_surface() {
  return lit(above(), {facing({0, 0, 1}, {1, 0, least}), facing({0, 0, 1}, {1, 0, 0}),
                       facing({0, 0, 1}, {1, 0, -least})});
}
Case lengths_of_almost_one() {
  std::vector<Light> all = lights(30, [](int i, auto& dice) {
    const glm::vec3 p = about(dice, {0, 0, 1.5F});
    return oriented(p, unit(-glm::dvec3(p)) * (i % 2 == 0 ? 1.000009F : 0.999991F));
  });
  return lit(std::move(all), {facing({0, 0, 1.000009F}, {0, 0, 0.999991F}),
                              facing({0, 0, 0.999991F}, {0, 0, 1.000009F})});
}

/// Axes that are so far apart, half a turn at most, and one float's step around it.
Case axes_apart(double degrees) {
  const double angle = degrees * (std::numbers::pi / 180);
  return lit(lights(24, [angle](int i, auto& dice) {
    glm::vec3 axis(0, 0, -1);
    if (i % 2 == 1) axis = glm::vec3(std::sin(angle), 0, -std::cos(angle));
    const int step = i % 3;
    if (step != 0) axis.x = std::nextafter(axis.x, step == 1 ? 2.0F : -2.0F);
    return oriented(about(dice, {0, 0, 1.5F}), axis);
  }));
}
Case axes_alike() { return axes_apart(0); }
Case axes_at_right_angles() { return axes_apart(90); }
Case axes_opposite() { return axes_apart(180); }
Case axes_everywhere() {
  return lit(lights(60, [](int, auto& dice) {
    return oriented(about(dice, {0, 0, 1.5F}), unit(dice.in_cube()));
  }));
}

/// Spots around an axis to the point, off it by the outer angle, but for rounding.
Case spots_at_the_rim(double degrees, bool hard) {
  const double angle = degrees * (std::numbers::pi / 180);
  return lit(lights(30, [&](int i, auto& dice) {
    const glm::vec3 p = about(dice, {0, 0, 2});
    const glm::dvec3 way = glm::normalize(-glm::dvec3(p));
    const glm::dvec3 side = glm::normalize(glm::cross(way, glm::dvec3(0.3, 1, 0.2)));
    const glm::vec3 axis = unit(std::cos(angle) * way + std::sin(angle) * side);
    float outer = float(std::cos(angle));
    if (i % 3 != 0) outer = std::nextafter(outer, i % 3 == 1 ? 2.0F : -2.0F);
    outer = std::min(outer, std::nextafter(1.0F, 0.0F));
    return spot(p, axis, hard ? std::nextafter(outer, 2.0F) : 1, outer);
  }));
}
Case rims_of_one_step() { return spots_at_the_rim(30, true); }
Case spots_of_90_degrees() { return spots_at_the_rim(90, true); }
Case spots_of_a_hair() { return spots_at_the_rim(0.02, true); }
Case spots_with_soft_rims() { return spots_at_the_rim(20, false); }
Case spots_of_180_degrees() {
  return lit(lights(24, [](int i, auto& dice) {
    return spot(about(dice, {0, 0, 1.5F}), unit(dice.in_cube()), i % 2 == 0 ? 1 : -1,
                i % 2 == 0 ? -1 : std::nextafter(-1.0F, -2.0F));
  }));
}

Case suns_all_around() {
  return lit(lights(60, [](int, auto& dice) { return sun(unit(dice.in_cube())); }));
}
Case suns_at_the_horizon() {
  return lit(lights(24, [](int i, auto&) {
    return sun(i % 3 == 0   ? glm::vec3(1, 0, least)
               : i % 3 == 1 ? glm::vec3(0, 1, 0)
                            : glm::vec3(0, -1, -least));
  }));
}

constexpr NamedCase direction_cases[] = {
    {"normal-grazes-the-box", "The highest corner of a box is at the horizon but for rounding.",
     normal_grazes_the_box},
    {"normal-opposes",
     "All lights are behind the surface: the total is 0, and no threshold stops there.",
     normal_opposes},
    {"normal-on-an-axis",
     "Two of three products with the normal are 0: edges of boxes have no root.",
     normal_on_an_axis},
    {"normal-beside-an-axis",
     "The normal is one float's step beside an axis: quotients of its parts overflow.",
     normal_beside_an_axis},
    {"viewed-from-behind", "n.v < 0: lobes that divide by it have to be 0.", viewed_from_behind},
    {"viewed-along-the-surface",
     "n.v is the least float, 0, or below: lobes that divide by it explode or vanish.",
     viewed_along_the_surface},
    {"lengths-of-almost-one",
     "Directions are as long and as short as they may be: what is not divided out is too much.",
     lengths_of_almost_one},
    {"axes-alike", "A cone of 0 degrees, and one float's step around it.", axes_alike},
    {"axes-at-right-angles",
     "A cone of 90 degrees between two axes, and one float's step around it.",
     axes_at_right_angles},
    {"axes-opposite", "Opposite axes: their cone has no axis of its own.", axes_opposite},
    {"axes-everywhere", "A cone of 180 degrees: nothing is known of where its lights shine.",
     axes_everywhere},
    {"rims-of-one-step", "Spots with a hard edge of one float's step, on which the point lies.",
     rims_of_one_step},
    {"spots-of-90-degrees", "The rim is at a right angle: its cosine is 0 or next to it.",
     spots_of_90_degrees},
    {"spots-of-a-hair", "Cones of 0.02 degrees, the narrowest that a cosine in float can tell.",
     spots_of_a_hair},
    {"spots-with-soft-rims", "The point is where emission begins: it is 0 or all but 0.",
     spots_with_soft_rims},
    {"spots-of-180-degrees",
     "Spots that shine everywhere, some with their rim exactly behind them.", spots_of_180_degrees},
    {"suns-all-around", "Directional lights from everywhere: their box has the origin in it.",
     suns_all_around},
    {"suns-at-the-horizon",
     "Directional lights along the surface, the least float above it or below.",
     suns_at_the_horizon},
};

} // namespace

std::span<const NamedCase> directions() { return direction_cases; }

} // namespace lightcuts::oracle::making
