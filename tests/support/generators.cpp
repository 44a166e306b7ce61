// SPDX-License-Identifier: MIT
#include "generators.h"

#include <iomanip>
#include <ostream>

#include "dice.h"
#include "shrinking.h"

namespace lightcuts::gen {
namespace {

/// Where the lights of one scene are, relative to the shading point.
enum class Place {
  lattice,
  cube,
  clump,
  line,
  plane,
  coincident,
  tangent,
  at_point,
  next_to_point,
  shares_coordinate,
  far,
  stiff,
  count
};

glm::vec3 finite(const glm::dvec3& v) {
  return {Dice::finite(v.x), Dice::finite(v.y), Dice::finite(v.z)};
}

glm::vec3 in_tangent_plane(Dice& dice, const View& view) {
  const glm::dvec3 n(view.normal);
  const glm::dvec3 along = glm::cross(n, glm::dvec3(dice.axis()));
  const double size = dice.log_uniform(-3, 3);
  return finite(glm::dvec3(view.position) + size * along +
                double(dice.between(-2, 2)) * size * glm::cross(n, along));
}

glm::vec3 next_to(Dice& dice, const glm::vec3& p) {
  glm::vec3 v = p;
  for (int i = 0; i < 3; ++i)
    v[i] = Dice::finite(std::nextafter(v[i], dice.one_in(2) ? 1e38F : -1e38F));
  return v;
}

glm::vec3 position(Dice& dice, Place place, const View& view, const glm::vec3& anchor) {
  const glm::dvec3 a(anchor);
  switch (place) {
  case Place::lattice:
    return dice.lattice();
  case Place::cube:
    return dice.in_cube();
  case Place::clump:
    return finite(a + 1e-3 * glm::dvec3(dice.in_cube()));
  case Place::line:
    return finite(a + dice.uniform(-1, 1) * glm::dvec3(1, 0.5, 0));
  case Place::plane:
    return {dice.uniform(-1, 1), dice.uniform(-1, 1), anchor.z};
  case Place::coincident:
    return anchor;
  case Place::tangent:
    return in_tangent_plane(dice, view);
  case Place::at_point:
    return view.position;
  case Place::next_to_point:
    return next_to(dice, view.position);
  case Place::far:
    return glm::vec3(1e8F) + 8.0F * dice.lattice();
  case Place::shares_coordinate: {
    glm::vec3 v = dice.in_cube();
    for (int i = dice.between(1, 2); i > 0; --i) {
      const int axis = dice.below(3);
      v[axis] = view.position[axis];
    }
    return v;
  }
  default:
    return dice.finite_vector();
  }
}

glm::vec3 not_negative(const glm::vec3& v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }

glm::vec3 intensity(Dice& dice, int kind) {
  glm::vec3 v(0);
  switch (kind) {
  case 0:
    return glm::vec3(1);
  case 1:
    return not_negative(dice.in_cube());
  case 2:
    return not_negative(dice.finite_vector());
  case 3:
    v[dice.below(3)] = 1;
    return v;
  case 4:
    return glm::vec3(dice.pick({0.0F, 1.0F, 1e30F, 0x1p-149F, 0x1.fffffep127F}));
  default:
    return glm::vec3(std::abs(dice.log_uniform(-12, 12)));
  }
}

glm::vec3 reflectance(Dice& dice) {
  if (dice.one_in(10)) return not_negative(dice.finite_vector());
  return dice.one_in(3) ? glm::vec3(0.5F) : not_negative(dice.in_cube());
}

Material material(Dice& dice) {
  const float exponent = dice.one_in(2)
                             ? dice.pick({0.0F, 1.0F, 10.0F, 1000.0F, 0x1p20F, 0.5F, 2.75F})
                             : std::min(std::abs(dice.log_uniform(-3, 6.03)), 0x1p20F);
  switch (dice.below(8)) {
  case 0:
    return {};
  case 1:
  case 2:
  case 3:
    return {reflectance(dice)};
  case 4:
    return {glm::vec3(0), reflectance(dice), exponent};
  default:
    return {reflectance(dice), reflectance(dice), exponent};
  }
}

/// A light's position, or one that takes each coordinate from some light: on faces of the boxes.
glm::vec3 amid_lights(Dice& dice, const std::vector<OmniLight>& lights) {
  const auto any = [&] { return lights[dice.below(static_cast<int>(lights.size()))].position; };
  glm::vec3 p = any();
  if (dice.one_in(2))
    for (int i = 0; i < 3; ++i) p[i] = any()[i];
  return p;
}

View make_view(Dice& dice) {
  View view;
  switch (dice.below(5)) {
  case 0:
    break;
  case 1:
    view.position = dice.lattice();
    break;
  case 2:
    view.position = dice.finite_vector();
    break;
  case 3:
    view.position = glm::vec3(1e8F) + dice.lattice();
    break;
  default:
    view.position = dice.in_cube();
  }
  view.normal = dice.unit_vector();
  view.to_viewer = dice.one_in(4) ? view.normal : dice.unit_vector();
  view.material = material(dice);
  return view;
}

Scene make_scene(Dice& dice, int count) {
  Scene scene;
  scene.view = make_view(dice);
  const auto any_place = [&] { return static_cast<Place>(dice.below(int(Place::count))); };
  const Place usual = any_place();
  const glm::vec3 anchor = dice.one_in(4) ? dice.finite_vector() : dice.in_cube();
  const int usual_intensity = dice.below(6);
  for (int i = 0; i < count; ++i) {
    const Place place = dice.one_in(8) ? any_place() : usual;
    const int kind = dice.one_in(8) ? dice.below(6) : usual_intensity;
    scene.lights.push_back({position(dice, place, scene.view, anchor), intensity(dice, kind)});
  }
  if (dice.one_in(4)) scene.view.position = amid_lights(dice, scene.lights);
  return scene;
}

BoxView make_box_view(Dice& dice) {
  const Scene scene = make_scene(dice, dice.between(1, 4));
  BoxView view{Box::empty(), scene.view.position,
               dice.one_in(6) ? dice.finite_vector() : scene.view.normal};
  for (const OmniLight& light : scene.lights) view.box.extend(light.position);
  if (dice.one_in(6))
    for (int i = 0; i < 3; ++i) view.x[i] = dice.one_in(2) ? view.box.lo[i] : view.box.hi[i];
  return view;
}

struct Number {
  float value;
};

std::ostream& operator<<(std::ostream& out, const Number& n) {
  out << n.value;
  if (n.value != std::trunc(n.value) || std::abs(n.value) > 1e6F)
    out << " (" << std::hexfloat << n.value << std::defaultfloat << ")";
  return out;
}

std::ostream& show(std::ostream& out, const char* name, const glm::vec3& v) {
  return out << name << " {" << Number{v.x} << ", " << Number{v.y} << ", " << Number{v.z} << "} ";
}

} // namespace

LightSet Scene::light_set() const {
  LightSet set;
  for (const OmniLight& light : lights) set.add_omni(light.position, light.intensity);
  return set;
}

std::ostream& operator<<(std::ostream& out, const View& view) {
  show(out, "point: position", view.position);
  show(out, "normal", view.normal);
  show(out, "to_viewer", view.to_viewer);
  show(out, "\n  diffuse", view.material.diffuse);
  show(out, "specular", view.material.specular);
  return out << "exponent " << Number{view.material.exponent};
}

std::ostream& operator<<(std::ostream& out, const Scene& scene) {
  out << std::setprecision(9) << scene.view;
  for (const OmniLight& light : scene.lights) {
    show(out, "\nlight: position", light.position);
    show(out, "intensity", light.intensity);
  }
  return out;
}

std::ostream& operator<<(std::ostream& out, const BoxView& view) {
  show(out << std::setprecision(9), "box: lo", view.box.lo);
  show(out, "hi", view.box.hi);
  show(out, "x", view.x);
  return show(out, "n", view.n);
}

rc::Gen<float> finite_float() {
  return shrinking<float>([](Dice& dice, int) { return dice.finite_float(); });
}

rc::Gen<glm::vec3> unit_vector() {
  return shrinking<glm::vec3>([](Dice& dice, int) { return dice.unit_vector(); },
                              simpler_directions);
}

rc::Gen<Scene> scene(int max_lights) {
  return shrinking<Scene>([max_lights](Dice& dice, int size) {
    return make_scene(dice, dice.between(1, 1 + (max_lights - 1) * std::min(size, 100) / 100));
  });
}

rc::Gen<BoxView> box_view() {
  return shrinking<BoxView>([](Dice& dice, int) { return make_box_view(dice); });
}

} // namespace lightcuts::gen
