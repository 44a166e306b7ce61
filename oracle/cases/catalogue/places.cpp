// SPDX-License-Identifier: MIT
#include <oracle/cases/catalogue/making.h>

namespace lightcuts::oracle::making {
namespace {

Case on_the_surface() {
  return lit(lights(30, [](int i, auto& dice) {
    const glm::vec3 p = about(dice, glm::vec3(0), 2);
    return omni({p.x, p.y, i % 3 == 0 ? 0.5F : 0.0F});
  }));
}

Case a_step_above_the_surface() {
  return lit(lights(30, [](int i, auto& dice) {
    const glm::vec3 p = about(dice, glm::vec3(0), 2);
    return omni({p.x, p.y, i % 2 == 0 ? least : -least}, glm::vec3(1e30F));
  }));
}

Case at_the_point() {
  return lit(lights(12, [](int i, auto& dice) {
    return omni(i % 4 == 0 ? glm::vec3(0) : about(dice, glm::vec3(0)));
  }));
}

/// The corners of a cube and what is within.
std::vector<Light> in_a_cube() {
  return lights(40, [](int i, auto& dice) {
    if (i < 8) return omni({i & 1, i >> 1 & 1, i >> 2 & 1});
    return omni(about(dice, glm::vec3(0.5F), 0.5));
  });
}
Case on_a_face() { return lit(in_a_cube(), {{.position = {0.25F, 0.75F, 0}}}); }
Case on_an_edge() { return lit(in_a_cube(), {{.position = {0.25F, 0, 0}, .normal = {0, 1, 0}}}); }
Case on_a_corner() { return lit(in_a_cube(), {{.position = {1, 1, 0}}}); }
Case in_the_middle() { return lit(in_a_cube(), {{.position = glm::vec3(0.5F)}}); }
Case a_step_outside() {
  return lit(in_a_cube(),
             {{.position = {0.25F, 0.75F, -least}},
              {.position = {std::nextafter(1.0F, 2.0F), 0.5F, 0.5F}, .normal = {-1, 0, 0}}});
}

Case on_a_line_through_the_point() {
  return lit(lights(
      41, [](int i, auto&) { return omni(float(i - 20) / 8 * glm::vec3(0.5F, 0.25F, 0.75F)); }));
}
Case on_a_line_beside() {
  return lit(lights(64, [](int i, auto&) { return omni({float(i - 32) / 4, 0, 0.125F}); }));
}
Case on_a_plane_above() {
  return lit(lights(64, [](int i, auto&) { return omni({i % 8 - 4, i / 8 - 4, 1}); }));
}
Case on_a_plane_through_the_point() {
  return lit(lights(64, [](int i, auto&) { return omni({0, i % 8 - 4, i / 8 - 4}); }));
}
Case on_a_sphere() {
  return lit(lights(80, [](int, auto& dice) { return omni(unit(dice.in_cube())); }));
}
Case on_a_lattice() {
  return lit(lights(125,
                    [](int i, auto&) {
                      return omni({i % 5, i / 5 % 5, i / 25});
                    }),
             {{.position = {2, 2, -1}}});
}
Case mirrored_pairs() {
  return lit(lights(60, [](int i, auto&) {
    gen::Dice of_pair{std::uint64_t(i / 2)};
    return omni((i % 2 == 0 ? 1.0F : -1.0F) * about(of_pair, glm::vec3(0)));
  }));
}
Case on_250_scales() {
  return lit(lights(250, [](int i, auto&) { return omni({0, 0, std::ldexp(1.0F, i - 125)}); }));
}
Case a_hundred_at_one_place() {
  return lit(lights(100, [](int i, auto&) {
    return omni({0.25F, 0, 1}, glm::vec3(float(i % 7)));
  }));
}
Case a_million_at_one_place() {
  return lit(lights(1'000'000, [](int, auto&) { return omni({0.25F, 0, 1}, glm::vec3(1e-6F)); }));
}
Case a_hundred_thousand_anywhere() {
  return lit(lights(100'000, [](int, auto& dice) {
    return omni(about(dice, {0, 0, 1.5F}), glm::vec3(1e-5F));
  }));
}

constexpr NamedCase place_cases[] = {
    {"on-the-surface",
     "Lights lie in the tangent plane: n.l is exactly 0, and rounding must not make it more.",
     on_the_surface},
    {"a-step-above-the-surface",
     "Lights are the least float above or below the horizon, and bright: only exact signs tell "
     "them apart.",
     a_step_above_the_surface},
    {"at-the-point", "Lights are where the shading point is: q is 0, l has no direction.",
     at_the_point},
    {"on-a-face", "The point is on a face of a cluster's box.", on_a_face},
    {"on-an-edge", "The point is on an edge of a cluster's box.", on_an_edge},
    {"on-a-corner", "The point is on a corner of a cluster's box, and at a light.", on_a_corner},
    {"in-the-middle",
     "The point is in a cluster's box: the bound is infinite, and children have to be asked.",
     in_the_middle},
    {"a-step-outside",
     "The point is one float's step outside a box: the bound is finite, and huge.", a_step_outside},
    {"on-a-line-through-the-point", "Boxes' diagonals go through the point, no box is flat.",
     on_a_line_through_the_point},
    {"on-a-line-beside", "Boxes have one extent: the largest n.l/d^2 is inside an edge.",
     on_a_line_beside},
    {"on-a-plane-above", "Boxes have two extents, and all distances occur many times.",
     on_a_plane_above},
    {"on-a-plane-through-the-point",
     "The point is in the plane of flat boxes, half of them below the horizon.",
     on_a_plane_through_the_point},
    {"on-a-sphere", "All lights are as far away: 1/d^2 of a box is far from that of any.",
     on_a_sphere},
    {"on-a-lattice", "All costs occur many times: only the order of ties decides the tree.",
     on_a_lattice},
    {"mirrored-pairs", "Of each light and its mirror image one is below the horizon.",
     mirrored_pairs},
    {"on-250-scales",
     "Each light is as far again as the last: the tree is as deep as there are lights.",
     on_250_scales},
    {"a-hundred-at-one-place",
     "No box has an extent: bounds are as tight as they can be, ties everywhere.",
     a_hundred_at_one_place},
    {"a-million-at-one-place",
     "A million ties: a tree that breaks them by index is a million levels deep.",
     a_million_at_one_place, true},
    {"a-hundred-thousand-anywhere", "Sums of 10^5 lights: roundings add up.",
     a_hundred_thousand_anywhere, true},
};

} // namespace

std::span<const NamedCase> places() { return place_cases; }

} // namespace lightcuts::oracle::making
