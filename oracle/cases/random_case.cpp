// SPDX-License-Identifier: MIT
#include <oracle/cases/random_case.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <oracle/cases/blocks.h>
#include <oracle/cases/random_picture.h>
#include <oracle/cases/random_pixels.h>

namespace lightcuts::oracle {
namespace {

using gen::Dice;

constexpr int most_lights = 24, most_views = 3;

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

/// From the last view on: what was seen before is not any more.
void hide_some(Dice& dice, Case& c) {
  c.cut.unoccluded = false;
  c.views.back().hidden.clear();
  for (std::uint32_t i = 0; i < c.lights.size(); ++i)
    if (dice.one_in(4)) c.views.back().hidden.push_back(i);
}

/// Of moderate scales, so that the mean of not too many draws is near the truth.
Case lottery(Dice& dice) {
  Case c;
  c.draws = true;
  const LightKind kind = dice.pick({LightKind::omni, LightKind::oriented, LightKind::directional});
  int count = dice.between(2, 8), clusters = 3;
  // What goes wrong on the way down to a light takes some levels of the tree, and what goes wrong
  // from cluster to cluster some of these.
  if (Dice aside = dice.aside(); aside.one_in(3)) {
    count = aside.between(16, 40);
    clusters = aside.between(1, 12);
  }
  for (int i = 0; i < count; ++i) {
    Light light;
    light.kind = dice.one_in(8) ? LightKind::omni : kind;
    light.position = glm::vec3(dice.uniform(-2, 2), dice.uniform(-2, 2), dice.uniform(0.5, 2));
    if (count > 8) light.position.z += 2; // else the nearest decide, and it takes many draws
    if (light.kind == LightKind::directional)
      light.position = glm::vec3(glm::normalize(glm::dvec3(light.position)));
    if (light.kind == LightKind::oriented) light.axis = {0, 0, -1};
    light.intensity = glm::vec3(dice.uniform(0.5, 2), dice.uniform(0.5, 2), dice.uniform(0.5, 2));
    c.lights.push_back(light);
  }
  c.views.push_back({{}, {}});
  if (dice.one_in(2)) c.views[0].view.material.lobe = Phong{glm::vec3(0.3F), 2};
  if (dice.one_in(3)) c.views[0].hidden = {std::uint32_t(dice.below(count))};
  c.cut = {0.02F, std::uint32_t(clusters == 3 ? dice.between(1, 3) : clusters), 0};
  c.seed = dice.bits() % 1000;
  if (Dice aside = dice.aside(); count > 8) hide_some(aside, c);
  return c;
}

/// What goes wrong by the number of lights does so at powers of 2 and of 10, and next to them: most
/// often above one, so that these come first. Numbers that take seconds come last.
const std::vector<std::uint32_t>& ladder() {
  static const std::vector<std::uint32_t> list = [] {
    std::vector<std::uint32_t> sizes;
    const auto add = [&sizes](std::uint32_t first, std::uint32_t last,
                              const std::vector<int>& off) {
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

/// From so far that the lights of small clusters are much alike, and facing them: what estimates
/// are worth shows there.
gen::View view_from_afar(Dice& dice, const std::vector<Light>& lights) {
  gen::View view = gen::make_view(dice, lights, {.lobe = 0});
  glm::dvec3 lo(lights.front().position), hi = lo;
  for (const Light& light : lights) {
    lo = glm::min(lo, glm::dvec3(light.position));
    hi = glm::max(hi, glm::dvec3(light.position));
  }
  const glm::vec3 away = dice.unit_vector();
  const glm::dvec3 place =
      0.5 * (lo + hi) + dice.uniform(1, 4) * glm::length(hi - lo) * glm::dvec3(away);
  for (int i = 0; i < 3; ++i) view.position[i] = Dice::finite(place[i]);
  view.normal = -away;
  return view;
}

/// All but one of the lights shine one way, in narrow cones; that one shines the other way, and the
/// first view sees it from there, so near that it outshines all others.
void turn_one_round(Dice& dice, Case& c) {
  const glm::vec3 away = dice.unit_vector();
  for (Light& light : c.lights) {
    light.axis = glm::vec3(glm::normalize(glm::dvec3(away) + 1e-3 * glm::dvec3(dice.in_cube())));
    light.cos_inner = 1;
    light.cos_outer = 0.9F;
  }
  Light& other = c.lights[notable_light(dice, c.lights)];
  other.axis = -away;
  gen::View& view = c.views.front().view;
  for (int i = 0; i < 3; ++i) {
    const double scale = std::max(1e-3, std::abs(double(other.position[i])));
    view.position[i] =
        Dice::finite(double(other.position[i]) - std::ldexp(scale * away[i], -dice.between(1, 12)));
  }
  const glm::dvec3 back = glm::dvec3(other.position) - glm::dvec3(view.position);
  if (glm::length(back) > 0) view.normal = glm::vec3(glm::normalize(back));
}

/// Lights of one kind: of any place, on a lattice with ties, or on a line over 60 scales, on which
/// trees of a few hundred are as deep as they are large.
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
  Dice aside = dice.aside();
  if (has_axis(kind) && aside.one_in(2))
    turn_one_round(aside, c);
  else if (Dice far = aside.aside(); far.one_in(2))
    c.views.front().view = view_from_afar(far, c.lights);
  if (aside.one_in(2)) hide_some(aside, c);
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

} // namespace

CutConfig random_cut(Dice& dice, int lights) {
  CutConfig cut;
  cut.threshold = dice.pick({0.02F, 0.02F, 0.1F, 0.5F, 0.001F, 2.0F});
  cut.max_size = dice.one_in(3) ? std::uint32_t(dice.between(1, lights)) : 1000;
  if (dice.one_in(6)) cut.black_level = std::abs(dice.log_uniform(-6, 0));
  return cut;
}

Case small_case(Dice& dice) {
  Dice aside = dice.aside();
  Case c = lights_and_views(dice);
  if (aside.one_in(4)) make_block(aside, c);
  return c;
}

Case random_case(std::uint64_t seed, std::uint64_t index) {
  Dice dice(hashed(seed, index));
  constexpr std::uint64_t every = 500; // a second each
  if (index % every == every - 1 && index / every < most_cases_with_draws) return lottery(dice);
  if (const std::uint32_t count = many_lights_at(index)) return multitude(dice, count);
  if (dice.one_in(8)) return picture_case(dice);
  Dice aside = dice.aside();
  Case c = lights_and_views(dice);
  constexpr std::uint64_t epoch = 4000, age = 1U << 16; // a second or so
  if (index % epoch == 777)
    add_history(aside, c, age);
  else if (aside.one_in(12))
    add_history(aside, c, aside.one_in(4) ? 256 : std::uint32_t(aside.between(0, 40)));
  else if (Dice near = aside.aside(); near.one_in(8))
    make_block(near, c);
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

} // namespace lightcuts::oracle
