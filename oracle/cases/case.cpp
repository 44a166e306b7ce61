// SPDX-License-Identifier: MIT
#include <oracle/cases/case.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <oracle/cases/random_pixels.h>
#include <oracle/cases/simpler.h>
#include <oracle/cases/simpler_values.h>

namespace lightcuts::oracle {
namespace {

using gen::Dice;

constexpr int most_lights = 24, most_views = 3;

CutConfig random_cut(Dice& dice, int lights) {
  CutConfig cut;
  cut.threshold = dice.pick({0.02F, 0.02F, 0.1F, 0.5F, 0.001F, 2.0F});
  cut.max_size = dice.one_in(3) ? std::uint32_t(dice.between(1, lights)) : 1000;
  if (dice.one_in(6)) cut.black_level = std::abs(dice.log_uniform(-6, 0));
  return cut;
}

std::vector<std::uint32_t> random_hidden(Dice& dice, std::size_t lights) {
  std::vector<std::uint32_t> hidden;
  const int of = dice.pick({0, 0, 2, 4});
  for (std::uint32_t i = 0; of > 0 && i < lights; ++i)
    if (dice.one_in(of)) hidden.push_back(i);
  return hidden;
}

Case lights_and_views(Dice& dice) {
  const int count = dice.one_in(3) ? dice.between(1, 4) : dice.between(2, most_lights);
  const gen::Scene scene = gen::make_scene(dice, count);
  Case c;
  c.lights = scene.lights;
  c.min_distance = scene.min_distance;
  c.cut = random_cut(dice, count);
  c.seed = dice.bits() % 1000;
  const int views = dice.between(1, most_views);
  for (int i = 0; i < views; ++i)
    c.views.push_back({i == 0 ? scene.view : gen::make_view(dice, scene.lights),
                       random_hidden(dice, scene.lights.size())});
  const bool all_seen = std::all_of(c.views.begin(), c.views.end(),
                                    [](const CaseView& view) { return view.hidden.empty(); });
  c.cut.unoccluded = all_seen && dice.one_in(2);
  return c;
}

void add_quad(Case& c, const glm::vec3& corner, const glm::vec3& a, const glm::vec3& b) {
  const std::uint32_t mesh = c.triangles.empty() ? 0 : c.triangles.back().mesh + 1;
  c.triangles.push_back({corner, corner + a, corner + a + b, mesh});
  c.triangles.push_back({corner, corner + a + b, corner + b, mesh});
}

/// A floor with things hanging over it, seen from above, in units of any size.
Case picture(Dice& dice) {
  Case c;
  const float unit = dice.pick({1.0F, 1.0F, 0x1p-60F, 0x1p10F});
  c.views.push_back({{}, {}});
  c.views[0].view.material = {glm::vec3(0.5F), {}};
  const int blockers = dice.between(0, 4);
  for (int i = 0; i < blockers; ++i) {
    const glm::vec3 corner =
        unit * glm::vec3(dice.uniform(-2, 1), dice.uniform(0.5, 2), dice.uniform(-2, 1));
    const bool upright = dice.one_in(3);
    add_quad(c, corner, unit * glm::vec3(1, 0, 0),
             unit * (upright ? glm::vec3(0, 0.5F, 0) : glm::vec3(0, 0, -1)));
  }
  const auto floor = std::ptrdiff_t(2 * dice.below(blockers + 1));
  Case ground;
  add_quad(ground, unit * glm::vec3(-4, 0, 4), unit * glm::vec3(8, 0, 0),
           unit * glm::vec3(0, 0, -8));
  c.triangles.insert(c.triangles.begin() + floor, ground.triangles.begin(), ground.triangles.end());
  for (std::size_t i = 0; i < c.triangles.size(); ++i) c.triangles[i].mesh = std::uint32_t(i / 2);
  const int lights = dice.between(1, 6);
  for (int i = 0; i < lights; ++i) {
    Light light;
    light.position =
        unit * glm::vec3(dice.uniform(-3, 3), dice.uniform(0.25, 3), dice.uniform(-3, 3));
    light.intensity = glm::vec3(unit * unit * float(dice.uniform(0.5, 2)));
    c.lights.push_back(light);
  }
  c.cut = random_cut(dice, lights);
  c.camera = {unit * glm::vec3(0.25F, 6, 1), glm::vec3(0), {0, 1, 0}, 50};
  c.image_size = {dice.between(2, 6), dice.between(2, 6)};
  return c;
}

/// Of moderate scales, so that the mean of not too many draws is near the truth.
Case lottery(Dice& dice) {
  Case c;
  c.draws = true;
  const LightKind kind = dice.pick({LightKind::omni, LightKind::oriented, LightKind::directional});
  const int count = dice.between(2, 8);
  for (int i = 0; i < count; ++i) {
    Light light;
    light.kind = dice.one_in(8) ? LightKind::omni : kind;
    light.position = glm::vec3(dice.uniform(-2, 2), dice.uniform(-2, 2), dice.uniform(0.5, 2));
    if (light.kind == LightKind::directional)
      light.position = glm::vec3(glm::normalize(glm::dvec3(light.position)));
    if (light.kind == LightKind::oriented) light.axis = {0, 0, -1};
    light.intensity = glm::vec3(dice.uniform(0.5, 2), dice.uniform(0.5, 2), dice.uniform(0.5, 2));
    c.lights.push_back(light);
  }
  c.views.push_back({{}, {}});
  if (dice.one_in(2)) c.views[0].view.material.lobe = Phong{glm::vec3(0.3F), 2};
  if (dice.one_in(3)) c.views[0].hidden = {std::uint32_t(dice.below(count))};
  c.cut = {0.02F, std::uint32_t(dice.between(1, 3)), 0};
  c.seed = dice.bits() % 1000;
  return c;
}

/// What goes wrong by the number of lights does so at powers of 2 and of 10, and next to them: most
/// often above one, so that these come first. Numbers that take seconds come last.
const std::vector<std::uint32_t>& ladder() {
  static const std::vector<std::uint32_t> list = [] {
    std::vector<std::uint32_t> sizes;
    const auto add = [&sizes](std::uint32_t first, std::uint32_t last, std::vector<int> off) {
      for (std::uint32_t power = first; power <= last; power *= 2)
        for (const int i : off) sizes.push_back(power + std::uint32_t(i));
    };
    sizes = {100, 1000, 10'000};
    add(1U << 7, 1U << 14, {1});
    std::sort(sizes.begin(), sizes.end());
    add(1U << 7, 1U << 14, {-1, 0});
    add(1U << 15, 1U << 17, {1});
    sizes.push_back(100'000);
    add(1U << 15, 1U << 17, {-1, 0});
    return sizes;
  }();
  return list;
}

/// An extreme light along some axis, the first, the last, or any.
std::size_t notable_light(Dice& dice, const std::vector<Light>& lights) {
  switch (dice.below(4)) {
  case 0:
    return 0;
  case 1:
    return lights.size() - 1;
  case 2: {
    const int axis = dice.below(3);
    const float side = dice.sign();
    const auto further = [&](const Light& a, const Light& b) {
      return side * a.position[axis] < side * b.position[axis];
    };
    return std::size_t(std::max_element(lights.begin(), lights.end(), further) - lights.begin());
  }
  default:
    return std::size_t(dice.bits() % lights.size());
  }
}

/// So near to a light, and facing it, that it outshines all others: what bounds a cluster of it has
/// to know of it.
gen::View view_beside(Dice& dice, const std::vector<Light>& lights) {
  gen::View view = gen::make_view(dice, lights, {.lobe = 0});
  const Light& light = lights[notable_light(dice, lights)];
  if (light.kind == LightKind::directional) return view;
  const glm::vec3 aside = dice.one_in(2) ? dice.axis() : dice.unit_vector();
  const float own_scale = std::max(
      {std::abs(light.position.x), std::abs(light.position.y), std::abs(light.position.z)});
  const float scale = dice.one_in(2) && own_scale > 0 ? own_scale : 1;
  for (int i = 0; i < 3; ++i)
    view.position[i] = Dice::finite(double(light.position[i]) +
                                    std::ldexp(double(scale) * aside[i], -dice.between(1, 20)));
  view.normal = -aside;
  return view;
}

/// Lights of one kind, mostly: of any place, on a lattice with ties, or on a line on which each is
/// farther out than all before it together, so that trees are deep.
Case multitude(Dice& dice, std::uint32_t count) {
  Case c;
  const int layout = dice.below(3);
  const LightKind kind = dice.one_in(2) ? LightKind::omni : LightKind(dice.below(light_kind_count));
  const glm::vec3 direction = dice.one_in(2) ? dice.axis() : dice.unit_vector();
  const double ratio = std::min(2.0, std::pow(2.0, 200.0 / count));
  const int side = int(std::cbrt(count)) + 1;
  c.lights.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    Light& light = c.lights[i];
    light.kind = kind;
    if (layout == 0)
      light.position = dice.in_cube();
    else if (layout == 1)
      light.position = dice.lattice(side);
    else
      light.position = glm::vec3(std::pow(ratio, double(i) - 0.5 * count) * glm::dvec3(direction));
    light.intensity = dice.one_in(4) ? Dice::not_negative(dice.in_cube()) : glm::vec3(1);
    gen::finish(dice, light, glm::vec3(0));
  }
  c.seed = dice.bits() % 1000;
  c.cut = random_cut(dice, int(std::min<std::uint32_t>(count, 1000)));
  for (int i = 0; i < 2; ++i) c.views.push_back({view_beside(dice, c.lights), {}});
  return c;
}

/// Questions that were asked before, and builds; a view that shares its position with another one.
void add_history(Dice& dice, Case& c, std::uint32_t questions) {
  c.builds = dice.one_in(2) ? std::uint32_t(dice.between(1, 3)) : 0;
  c.questions = questions;
  CaseView other{gen::make_view(dice, c.lights), {}};
  if (dice.one_in(2)) other.view.position = c.views.front().view.position;
  c.views.push_back(std::move(other));
  c.cut.unoccluded = false;
}

/// Indices of lights move up where lights before them are gone.
std::vector<std::uint32_t> without(const std::vector<std::uint32_t>& indices, std::uint32_t first,
                                   std::uint32_t count) {
  std::vector<std::uint32_t> left;
  for (const std::uint32_t i : indices)
    if (i < first || i >= first + count) left.push_back(i < first ? i : i - count);
  return left;
}

bool is_somewhere(const Light& light) { return light.kind != LightKind::directional; }

/// Hands out copies of a case in which something is simpler. All functions return whether the
/// visitor wants no more.
class Simpler {
public:
  Simpler(const Case& of, const std::function<bool(Case&)>& visitor) : of_(of), visitor_(visitor) {}

  [[nodiscard]] bool all() const {
    return lights() || without_chunks(&Case::views, 1) ||
           without_chunks(&Case::triangles, std::min<std::size_t>(of_.triangles.size(), 1)) ||
           together() || fields();
  }

private:
  /// A copy that `change` has changed.
  template <class Change>
  bool with(Change&& change) const {
    Case c = of_;
    change(c);
    return visitor_(c);
  }

  /// Copies in which what `part` finds is one of these values.
  template <class T, class Part>
  bool each(const std::vector<T>& values, Part&& part) const {
    return std::any_of(values.begin(), values.end(),
                       [&](const T& value) { return with([&](Case& c) { part(c) = value; }); });
  }

  template <class F>
  bool for_chunks(std::size_t count, std::size_t least, F&& f) const {
    for (std::size_t chunk = std::max<std::size_t>(count / 2, 1); chunk > 0; chunk /= 2)
      for (std::size_t first = 0; first + chunk <= count && count - chunk >= least; first += chunk)
        if (f(first, chunk)) return true;
    return false;
  }

  template <class T>
  bool without_chunks(std::vector<T> Case::*part, std::size_t least) const {
    return for_chunks((of_.*part).size(), least, [&](std::size_t first, std::size_t chunk) {
      return with([&](Case& c) { erase(c.*part, first, chunk); });
    });
  }

  template <class T>
  static void erase(std::vector<T>& values, std::size_t first, std::size_t count) {
    const auto begin = values.begin() + std::ptrdiff_t(first);
    values.erase(begin, begin + std::ptrdiff_t(count));
  }

  [[nodiscard]] bool lights() const {
    return for_chunks(of_.lights.size(), 1, [this](std::size_t first, std::size_t chunk) {
      return with([&](Case& c) {
        erase(c.lights, first, chunk);
        for (CaseView& v : c.views)
          v.hidden = without(v.hidden, std::uint32_t(first), std::uint32_t(chunk));
      });
    });
  }

  /// What has to change everywhere at once, or not at all.
  [[nodiscard]] bool together() const {
    return other([](Case& c) {
             for (CaseView& v : c.views)
               if (v.view.material.is_glossy() || !is_zeros_and_ones(v.view.material.diffuse))
                 v.view.material = {glm::vec3(1), {}};
           }) ||
           other([](Case& c) {
             for (Light& l : c.lights)
               if (is_somewhere(l)) l = {.position = l.position, .intensity = l.intensity};
           }) ||
           other([](Case& c) {
             for (Light& light : c.lights)
               if (!is_zeros_and_ones(light.intensity)) light.intensity = glm::vec3(1);
           }) ||
           other([](Case& c) {
             if (!c.views.empty() && c.triangles.empty()) shift(c, -c.views.front().view.position);
           }) ||
           other([exponent = largest_exponent()](Case& c) { scale(c, -exponent); }) || rounded();
  }

  /// What single floats shrink to; turning that into white again would never end.
  static bool is_zeros_and_ones(const glm::vec3& v) {
    const auto is = [](float value) { return value == 0 || value == 1; };
    return is(v.x) && is(v.y) && is(v.z);
  }

  /// All positions with a few bits only.
  [[nodiscard]] bool rounded() const {
    for (const int bits : {2, 4, 12})
      if (other([bits](Case& c) {
            for_positions(c, [bits](glm::vec3& v) {
              for (int i = 0; i < 3; ++i) v[i] = with_bits(v[i], bits);
            });
          }))
        return true;
    return false;
  }

  static float with_bits(float value, int bits) {
    int exponent = 0;
    const float mantissa = std::frexp(value, &exponent);
    return std::ldexp(std::trunc(std::ldexp(mantissa, bits)), exponent - bits);
  }

  /// with(), where that is another case.
  template <class Change>
  bool other(Change&& change) const {
    Case c = of_;
    change(c);
    return !(c == of_) && is_finite(c) && visitor_(c);
  }

  static bool is_finite(const Case& c) {
    const auto finite = [](const glm::vec3& v) {
      return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    };
    return std::isfinite(c.min_distance) &&
           std::all_of(c.lights.begin(), c.lights.end(), [&](const Light& light) {
             return finite(light.position) && finite(light.intensity);
           });
  }

  /// Of views, and of lights that are somewhere.
  template <class F>
  static void for_positions(Case& c, F&& f) {
    for (CaseView& v : c.views) f(v.view.position);
    for (Light& light : c.lights)
      if (is_somewhere(light)) f(light.position);
  }

  static void shift(Case& c, const glm::vec3 by) {
    for_positions(c, [&by](glm::vec3& v) { v += by; });
  }

  /// Lengths by 2^exponent, and intensities so that what arrives stays the same.
  static void scale(Case& c, int exponent) {
    const auto scaled = [exponent](glm::vec3& v, int times) {
      for (int i = 0; i < 3; ++i) v[i] = std::ldexp(v[i], times * exponent);
    };
    for_positions(c, [&](glm::vec3& v) { scaled(v, 1); });
    for (Light& light : c.lights)
      if (is_somewhere(light)) scaled(light.intensity, 2);
    c.min_distance = std::ldexp(c.min_distance, exponent);
  }

  /// Of the positions; 0 if all are 0, or about 1 already, or there is a picture, whose camera
  /// stays.
  [[nodiscard]] int largest_exponent() const {
    float largest = 0;
    Case copy = of_;
    for_positions(copy, [&largest](const glm::vec3& v) {
      for (int i = 0; i < 3; ++i) largest = std::max(largest, std::abs(v[i]));
    });
    if (largest == 0 || !of_.triangles.empty()) return 0;
    const int exponent = std::ilogb(largest);
    // What shrinks a float in [1, 2) may halve it: scaling that back would never end.
    return std::abs(exponent) <= 1 ? 0 : exponent;
  }

  [[nodiscard]] bool fields() const {
    bool done = false;
    for_each_field<Case>([&](const auto& field) {
      done = done || simpler_field(field.member, field.domain_in(of_));
    });
    return done;
  }

  template <class Value>
  bool simpler_field(Value Case::*member, const Domain& domain) const {
    return each(simpler_values(of_.*member, Case{}.*member, domain),
                [member](Case& c) -> Value& { return c.*member; });
  }

  template <class T>
  bool simpler_field(std::vector<T> Case::*member, const Domain& /*domain*/) const {
    for (std::size_t i = 0; i < (of_.*member).size(); ++i)
      if (each(simpler_element((of_.*member)[i]), [&](Case& c) -> T& { return (c.*member)[i]; }))
        return true;
    return false;
  }

  static std::vector<Light> simpler_element(const Light& light) { return gen::simpler(light); }
  template <class T>
  static std::vector<T> simpler_element(const T& element) {
    return simpler_values(element);
  }

  /// Of a count, so that the least that fails is found by halving.
  bool simpler_field(std::uint32_t Case::*count, const Domain& /*domain*/) const {
    const std::uint32_t now = of_.*count;
    std::vector<std::uint32_t> fewer;
    for (const std::uint32_t less : {now, now / 2, now / 8, now / 64, std::min(now, 1U)})
      if (less > 0) fewer.push_back(now - less);
    return each(fewer, [count](Case& c) -> std::uint32_t& { return c.*count; });
  }

  bool simpler_field(CutConfig Case::*cut, const Domain& /*domain*/) const {
    return each(with_usual_fields(of_.*cut, {0.02F, 1000, 0}),
                [cut](Case& c) -> CutConfig& { return c.*cut; });
  }

  /// Of a picture, if there is one.
  bool simpler_field(glm::uvec2 Case::*size, const Domain& domain) const {
    return !of_.triangles.empty() && simpler_field<glm::uvec2>(size, domain);
  }

  bool simpler_field(Camera Case::* /*stays*/, const Domain& /*domain*/) const { return false; }

  const Case& of_;
  const std::function<bool(Case&)>& visitor_;
};

} // namespace

LightSet Case::light_set() const {
  LightSet set;
  for (const Light& light : lights) set.add(light);
  if (min_distance > 0) set.set_min_distance(min_distance);
  return set;
}

lightcuts::Scene Case::scene() const {
  lightcuts::Scene scene;
  scene.name = "case";
  scene.lights = light_set();
  scene.camera = camera;
  scene.image_size = image_size;
  for (const CaseTriangle& t : triangles) {
    const auto first = std::uint32_t(scene.mesh.positions.size());
    scene.mesh.positions.insert(scene.mesh.positions.end(), {t.a, t.b, t.c});
    scene.mesh.triangles.emplace_back(first, first + 1, first + 2);
    scene.mesh.surface.push_back(t.mesh);
    while (scene.surfaces.size() <= t.mesh)
      scene.surfaces.push_back({"", views.empty() ? Material{} : views.front().view.material});
  }
  scene.mesh.normals.resize(scene.mesh.positions.size(), glm::vec3(0));
  return scene;
}

Case random_case(std::uint64_t seed, std::uint64_t index) {
  Dice dice(hashed(seed, index));
  constexpr std::uint64_t every = 500; // a second each
  if (index % every == every - 1 && index / every < most_cases_with_draws) return lottery(dice);
  if (const std::uint32_t count = many_lights_at(index)) return multitude(dice, count);
  if (dice.one_in(8)) return picture(dice);
  Dice aside = dice.aside();
  Case c = lights_and_views(dice);
  constexpr std::uint64_t epoch = 4000, age = 1U << 16; // a second or so
  if (index % epoch == 777)
    add_history(aside, c, age);
  else if (aside.one_in(12))
    add_history(aside, c, aside.one_in(4) ? 256 : std::uint32_t(aside.between(0, 40)));
  return c;
}

std::uint32_t many_lights_at(std::uint64_t index) {
  constexpr std::uint64_t every = 100;
  if (index % every != every / 2) return 0;
  const std::uint64_t rung = index / every, rungs = ladder().size();
  // Once up; then one in eight, since they take as long as all the others.
  if (rung < rungs) return ladder()[rung];
  return rung % 8 == 0 ? ladder()[rung / 8 % rungs] : 0;
}

bool visit_simpler(const Case& of, const std::function<bool(Case&)>& visitor) {
  return Simpler(of, visitor).all();
}

std::vector<Case> simpler(const Case& of) {
  std::vector<Case> list;
  visit_simpler(of, [&list](Case& c) {
    list.push_back(std::move(c));
    return false;
  });
  return list;
}

} // namespace lightcuts::oracle
