// SPDX-License-Identifier: MIT
#include <oracle/cases/stress_scene.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <oracle/numbers/dice.h>
#include <oracle/records/record_literal.h>
#include <oracle/records/record_text.h>
#include <oracle/truth/kinds.h>
#include <oracle/truth/lobes.h>

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

glm::vec3 intensity(Dice& dice, int kind) {
  glm::vec3 v(0);
  switch (kind) {
  case 0:
    return glm::vec3(1);
  case 1:
    return Dice::not_negative(dice.in_cube());
  case 2:
    return Dice::not_negative(dice.finite_vector());
  case 3:
    v[dice.below(3)] = 1;
    return v;
  case 4:
    return glm::vec3(dice.pick({0.0F, 1.0F, 1e30F, 0x1p-149F, 0x1.fffffep127F}));
  default:
    return glm::vec3(std::abs(dice.log_uniform(-12, 12)));
  }
}

Material material(Dice& dice, const Choice& choice) {
  const std::size_t index =
      choice.lobe ? *choice.lobe : std::size_t(dice.below(int(std::variant_size_v<Lobe>)));
  const int which = dice.below(8);
  if (which == 0 && !choice.lobe) return {};
  return {which == 1 ? glm::vec3(0) : dice.reflectance(),
          oracle::radiometry::random_lobe(dice, index)};
}

/// Profiles by dice aside: the cases without are the same as if there were none.
LightKind any_kind(Dice& dice) {
  constexpr int kinds_of_numbers = 4;
  static_assert(int(LightKind::profile) == kinds_of_numbers && light_kind_count == 5);
  Dice aside = dice.aside();
  const auto usual = LightKind(dice.below(kinds_of_numbers));
  return aside.one_in(light_kind_count) ? LightKind::profile : usual;
}

/// Luminaires are often of one make, and turned alike.
void share_profiles(Dice dice, std::vector<Light>& lights) {
  const int common = dice.below(4);
  const Light* first = nullptr;
  for (Light& light : lights) {
    if (light.kind != LightKind::profile || common > 1) continue;
    if (first == nullptr) first = &light;
    light.profile = first->profile;
    if (common == 1) {
      light.axis = first->axis;
      light.plane = first->plane;
    }
  }
}

/// A light's position, or one that takes each coordinate from some light: on faces of the boxes.
glm::vec3 amid_lights(Dice& dice, const std::vector<Light>& lights) {
  const auto any = [&] { return lights[dice.below(static_cast<int>(lights.size()))].position; };
  glm::vec3 p = any();
  if (dice.one_in(2))
    for (int i = 0; i < 3; ++i) p[i] = any()[i];
  return p;
}

View random_view(Dice& dice, const Choice& choice) {
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
  view.material = material(dice, choice);
  return view;
}

float random_clamp(Dice& dice) {
  return dice.one_in(2) ? dice.pick({1.0F, 0.5F, 2.0F})
                        : std::max(std::abs(dice.log_uniform(-6, 6)), 0x1p-149F);
}

/// A surface whose normal is an axis, or lies midway between two, but for tiny parts: directions as
/// close to its horizon as floats can say.
class Horizon {
public:
  explicit Horizon(Dice& dice) {
    const int first = dice.below(3), second = (first + dice.between(1, 2)) % 3;
    up_[first] = dice.sign();
    along_[second] = 1;
    aside_ = glm::cross(up_, along_);
    if (dice.one_in(4)) {
      const glm::dvec3 half = std::sqrt(0.5) * up_;
      up_ = half + std::sqrt(0.5) * along_;
      along_ = half - std::sqrt(0.5) * along_;
    }
    const double a = tiny(dice), b = tiny(dice);
    normal_ = glm::vec3(up_ + a * along_ + b * aside_);
  }

  [[nodiscard]] const glm::vec3& normal() const { return normal_; }
  /// sine is that of the angle above the horizon.
  [[nodiscard]] glm::dvec3 direction(const glm::dvec2& azimuth, double sine) const {
    return std::sqrt(1 - sine * sine) * (azimuth.x * along_ + azimuth.y * aside_) + sine * up_;
  }

private:
  static double tiny(Dice& dice) {
    if (dice.one_in(2)) return 0;
    return dice.one_in(2) ? dice.subnormal() : dice.log_uniform(-45, -7);
  }

  glm::dvec3 up_{0}, along_{0}, aside_{0};
  glm::vec3 normal_;
};

/// In [1, 2) 2^exponent.
double of_scale(Dice& dice, int exponent) { return std::ldexp(dice.uniform(1, 2), exponent); }

glm::dvec2 unit(const glm::dvec2& v) { return v / std::sqrt(v.x * v.x + v.y * v.y); }

/// Of length 1, or nearly as far from it as is allowed.
glm::vec3 about_unit(Dice& dice, const glm::dvec3& unit) {
  return glm::vec3(unit * dice.pick({1.0, 1.0, 1 + 9.5e-6, 1 - 9.5e-6}));
}

/// Where on the line c + t e n.q/|q|^3 is largest, e being an axis and c.e = 0:
///   2 (n.e) t^2 + 3 (n.c) t - (n.e) |c|^2 = 0 .
double peak_on_line(const glm::dvec3& n, const glm::dvec3& c, const glm::dvec3& e) {
  const double a = 2 * glm::dot(n, e), b = 3 * glm::dot(n, c), d = -glm::dot(n, e) * glm::dot(c, c);
  if (a == 0) return 0;
  const double root = std::sqrt(b * b - 4 * a * d);
  return 2 * -d / (b + (b < 0 ? -root : root));
}

glm::dvec2 random_azimuth(Dice& dice) {
  if (dice.one_in(2)) return {1, 0}; // what is aside of it may then be as small as floats are
  return unit(
      {dice.uniform(-1, 1), dice.one_in(2) ? dice.uniform(-1, 1) : dice.log_uniform(-9, 0)});
}

} // namespace

Scene make_grazing_scene(Dice& dice, int count, const Choice& choice) {
  // Tiny, and the clamp and the brightness as large as floats are: what is squared on the way may
  // leave the range of doubles.
  const bool at_ends = dice.one_in(4);
  Scene scene;
  View& view = scene.view;
  view = random_view(dice, choice);
  if (at_ends || dice.one_in(2)) view.position = glm::vec3(0);
  const Horizon horizon(dice);
  const glm::dvec2 azimuth = random_azimuth(dice);
  const double sine = of_scale(dice, -dice.between(2, 149));
  view.normal = horizon.normal();
  view.to_viewer = glm::vec3(horizon.direction(azimuth, sine));
  if (at_ends && dice.one_in(2)) view.material.diffuse = glm::vec3(0x1.fffffep127F);
  const int brightness = dice.below(6);
  for (int i = 0; i < count; ++i) {
    Light light;
    light.kind = choice.kind ? *choice.kind : any_kind(dice);
    // Turned by what the tangent of h makes of it, for lobes of all widths.
    const double turn = dice.one_in(3) ? 0 : sine * of_scale(dice, dice.between(-18, 4));
    const double higher = dice.one_in(3) ? of_scale(dice, dice.between(-8, 1)) : 1;
    const glm::dvec2 back{-azimuth.x - turn * azimuth.y, turn * azimuth.x - azimuth.y};
    const glm::dvec3 l = horizon.direction(unit(back), std::min(higher * sine, 0.5));
    const double distance =
        std::ldexp(1.0, at_ends ? dice.between(-149, -110) : dice.between(-20, 20));
    light.position = finite(glm::dvec3(view.position) + distance * l);
    light.intensity =
        at_ends && dice.one_in(2) ? glm::vec3(0x1.fffffep127F) : intensity(dice, brightness);
    finish(dice, light, view.position);
    if (oracle::radiometry::is_far(light.kind)) light.position = glm::vec3(l);
    if (dice.one_in(4)) light.position = next_to(dice, light.position);
    scene.lights.push_back(light);
  }
  if (choice.clamped ? *choice.clamped : dice.one_in(at_ends ? 2 : 4))
    scene.min_distance = at_ends ? std::ldexp(1.0F, dice.between(110, 127)) : random_clamp(dice);
  share_profiles(dice.aside(), scene.lights);
  return scene;
}

Scene make_peak_scene(Dice& dice, int count, const Choice& choice) {
  Scene scene;
  View& view = scene.view;
  view = random_view(dice, choice);
  if (dice.one_in(2)) view.position = glm::vec3(0);
  const glm::dvec3 x(view.position);
  const auto random_unit = [&] { return glm::normalize(glm::dvec3(dice.unit_vector())); };
  const glm::dvec3 n = random_unit();
  glm::dvec3 v = random_unit();
  if (glm::dot(n, v) < 0) v = -v;
  view.normal = about_unit(dice, n);
  view.to_viewer = about_unit(dice, v);
  const double distance = std::ldexp(dice.uniform(1, 2), dice.between(-10, 10));
  // Along n, at the mirror direction, back to the viewer, or inside an edge along an axis.
  const int peak = dice.below(4);
  const glm::dvec3 e(dice.axis());
  glm::dvec3 l = peak == 0 ? n : peak == 1 ? 2 * glm::dot(n, v) * n - v : v;
  if (peak == 3) {
    const glm::dvec3 across = random_unit();
    const glm::dvec3 c = across - glm::dot(across, e) * e;
    const double on_line = peak_on_line(n, c, e);
    const glm::dvec3 on_edge = c + on_line * e;
    if (std::isfinite(on_line) && glm::length(on_edge) > 1e-6) l = on_edge;
  }
  const glm::vec3 at = finite(x + distance * l);
  const glm::vec3 towards = about_unit(dice, -glm::normalize(l));
  const LightKind usual = choice.kind ? *choice.kind : any_kind(dice);
  const double apart = std::pow(10.0, -dice.uniform(3, 7));
  const bool dark = dice.one_in(2);
  for (int i = 0; i < count; ++i) {
    Light light;
    light.kind = usual;
    light.position = at;
    light.intensity = glm::vec3(dark && i > 0 ? 1e-30F : 1.0F);
    finish(dice, light, view.position);
    if (light.kind == LightKind::directional) light.position = about_unit(dice, glm::normalize(l));
    if (has_axis(light.kind)) {
      light.axis = towards;
      if (i > 0)
        light.axis = glm::vec3(glm::normalize(glm::dvec3(towards) + apart * random_unit()));
    }
    // The others: at the same place, or on both sides of it along the axis.
    if (i > 0 && (peak == 3 || dice.one_in(3)) && light.kind != LightKind::directional)
      light.position = finite(glm::dvec3(at) + distance * dice.uniform(-2, 2) * e);
    scene.lights.push_back(light);
  }
  if (choice.clamped ? *choice.clamped : dice.one_in(4)) scene.min_distance = random_clamp(dice);
  share_profiles(dice.aside(), scene.lights);
  return scene;
}

Scene make_scene(Dice& dice, int count, const Choice& choice) {
  if (!choice.lobe || *choice.lobe != Lobe(NoLobe()).index())
    if (Dice aside = dice.aside(); aside.one_in(8)) return make_grazing_scene(aside, count, choice);
  if (Dice aside = dice.aside().aside(); aside.one_in(8))
    return make_peak_scene(aside, count, choice);
  Scene scene;
  scene.view = random_view(dice, choice);
  const auto any_place = [&] { return static_cast<Place>(dice.below(int(Place::count))); };
  const Place usual = any_place();
  const LightKind usual_kind = choice.kind ? *choice.kind : any_kind(dice);
  const glm::vec3 anchor = dice.one_in(4) ? dice.finite_vector() : dice.in_cube();
  const int usual_intensity = dice.below(6);
  for (int i = 0; i < count; ++i) {
    const Place place = dice.one_in(8) ? any_place() : usual;
    const int brightness = dice.one_in(8) ? dice.below(6) : usual_intensity;
    Light light;
    light.kind = !choice.kind && dice.one_in(8) ? any_kind(dice) : usual_kind;
    light.position = position(dice, place, scene.view, anchor);
    light.intensity = intensity(dice, brightness);
    finish(dice, light, scene.view.position);
    scene.lights.push_back(light);
  }
  if (dice.one_in(4)) scene.view.position = amid_lights(dice, scene.lights);
  if (choice.clamped ? *choice.clamped : dice.one_in(4)) scene.min_distance = random_clamp(dice);
  share_profiles(dice.aside(), scene.lights);
  return scene;
}

void finish(Dice& dice, Light& light, const glm::vec3& seen_from) {
  oracle::radiometry::with_kind(light.kind,
                                [&](auto truth) { truth.finish(dice, light, seen_from); });
}

View make_view(Dice& dice, const std::vector<Light>& lights, const Choice& choice) {
  View view = random_view(dice, choice);
  if (dice.one_in(2)) view.position = amid_lights(dice, lights);
  return view;
}

LightSet Scene::light_set() const {
  LightSet set;
  for (const Light& light : lights) set.add(light);
  if (min_distance > 0) set.set_min_distance(min_distance);
  return set;
}

std::ostream& operator<<(std::ostream& out, const View& view) {
  return out << oracle::text_of(view) << '\n' << oracle::literal_of(view);
}

std::ostream& operator<<(std::ostream& out, const Scene& scene) {
  return out << oracle::text_of(scene) << '\n' << oracle::literal_of(scene);
}

} // namespace lightcuts::gen
