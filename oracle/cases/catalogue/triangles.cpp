// SPDX-License-Identifier: MIT
#include <oracle/cases/catalogue/making.h>

namespace lightcuts::oracle::making {
namespace {

/// A floor and what is above it, seen from above.
Case seen_from_above(std::vector<CaseTriangle> things) {
  Case c = lit(lights(12,
                      [](int, auto& dice) {
                        return omni(about(dice, {0, 2, 0}));
                      }),
               {{.normal = {0, 1, 0}, .to_viewer = {0, 1, 0}}});
  const glm::vec3 a(-4, 0, 4), b(4, 0, 4), d(4, 0, -4), e(-4, 0, -4);
  c.triangles = {{a, b, d, 0}, {a, d, e, 0}};
  for (CaseTriangle& t : things) {
    t.mesh = 1;
    c.triangles.push_back(t);
  }
  c.camera = {{0, 6, 1}, {0, 0, 0}, {0, 1, 0}, 50};
  c.image_size = {8, 6};
  return c;
}

Case without_area() {
  const glm::vec3 p(0, 0.5F, 0), q(1, 0.5F, 1);
  return seen_from_above({{p, p, p}, {p, p, q}, {p, 0.5F * (p + q), q}, {q, p, q}});
}
Case needles() {
  std::vector<CaseTriangle> list;
  for (int i = 0; i < 8; ++i) {
    const auto x = float(i - 4) / 2;
    list.push_back({{x, 0.5F, -4}, {x + std::ldexp(1.0F, -2 * i - 2), 0.5F, -4}, {x, 0.5F, 4}});
  }
  return seen_from_above(list);
}
Case twice_the_same() {
  const CaseTriangle t{{-1, 0.5F, -1}, {1, 0.5F, -1}, {0, 0.5F, 1}};
  const CaseTriangle floor{{-4, 0, 4}, {4, 0, 4}, {4, 0, -4}};
  return seen_from_above({t, t, {t.a, t.c, t.b}, floor});
}
Case lights_on_triangles() {
  Case c = seen_from_above({{{-1, 1, -1}, {1, 1, -1}, {0, 1, 1}}});
  c.lights = {omni({0, 1, 0}), omni({-1, 1, -1}), omni({0, 1, -1}), omni({2, 1, 0}),
              omni({0, 0, 0})};
  return c;
}
Case at_1e_30() {
  Case c = seen_from_above({{{-1, 1, -1}, {1, 1, -1}, {0, 1, 1}}});
  constexpr float scale = 0x1p-60F;
  for (CaseTriangle& t : c.triangles) {
    t.a *= scale;
    t.b *= scale;
    t.c *= scale;
  }
  for (Light& light : c.lights) light.position *= scale;
  c.camera.position *= scale;
  return c;
}
Case one_pixel() {
  Case c = seen_from_above({});
  c.image_size = {1, 1};
  return c;
}
Case one_row() {
  Case c = seen_from_above({});
  c.image_size = {33, 1};
  return c;
}

constexpr NamedCase triangle_cases[] = {
    {"triangles-without-area",
     "Triangles that are points or lines: they have no normal and must not occlude.", without_area},
    {"needles",
     "Triangles from 1/4 to 2^-16 wide and 8 long: rays pass within rounding of their edges.",
     needles},
    {"twice-the-same",
     "Faces lie in faces, turned over, too: a shadow ray must not meet the one it starts from.",
     twice_the_same},
    {"lights-on-triangles", "Lights lie in a triangle, on its edge and corner, and on the floor.",
     lights_on_triangles},
    {"of-2^-60", "Everything is 10^-18 m large: no length in the renderer may be absolute.",
     at_1e_30},
    {"one-pixel", "An image of 1 x 1: tiles and blocks have a single point.", one_pixel},
    {"one-row", "An image of 33 x 1: blocks at the border have less than they want.", one_row},
};

} // namespace

std::span<const NamedCase> triangles() { return triangle_cases; }

} // namespace lightcuts::oracle::making
