// SPDX-License-Identifier: MIT
#include <lightcuts/oracle/case.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include <lightcuts/oracle/random_pixels.h>
#include <lightcuts/oracle/simpler.h>

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
  return c;
}

void add_quad(Case& c, const glm::vec3& corner, const glm::vec3& a, const glm::vec3& b) {
  const std::uint32_t mesh = c.triangles.empty() ? 0 : c.triangles.back().mesh + 1;
  c.triangles.push_back({{corner, corner + a, corner + a + b}, mesh});
  c.triangles.push_back({{corner, corner + a + b, corner + b}, mesh});
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

template <class T>
void append_without_chunks(std::vector<Case>& list, const Case& of, std::vector<T> Case::*part,
                           std::size_t least) {
  const std::size_t count = (of.*part).size();
  for (std::size_t chunk = count / 2; chunk > 0; chunk /= 2)
    for (std::size_t first = 0; first + chunk <= count && count - chunk >= least; first += chunk) {
      list.push_back(of);
      auto& values = list.back().*part;
      const auto begin = values.begin() + std::ptrdiff_t(first);
      values.erase(begin, begin + std::ptrdiff_t(chunk));
    }
}

/// Indices of lights move up where lights before them are gone.
std::vector<std::uint32_t> without(const std::vector<std::uint32_t>& indices, std::uint32_t first,
                                   std::uint32_t count) {
  std::vector<std::uint32_t> left;
  for (const std::uint32_t i : indices)
    if (i < first || i >= first + count) left.push_back(i < first ? i : i - count);
  return left;
}

void append_with_fewer_lights(std::vector<Case>& list, const Case& of) {
  const auto count = std::uint32_t(of.lights.size());
  for (std::uint32_t chunk = std::max(count / 2, 1U); chunk > 0 && count > 1; chunk /= 2)
    for (std::uint32_t first = 0; first + chunk <= count; first += chunk) {
      list.push_back(of);
      Case& c = list.back();
      const auto begin = c.lights.begin() + std::ptrdiff_t(first);
      c.lights.erase(begin, begin + std::ptrdiff_t(chunk));
      for (CaseView& v : c.views) v.hidden = without(v.hidden, first, chunk);
    }
}

/// Copies in which one part is another of the given values.
template <class T, class Part>
void append_each(std::vector<Case>& list, const Case& of, const std::vector<T>& values,
                 Part&& part) {
  for (const T& value : values) {
    list.push_back(of);
    part(list.back()) = value;
  }
}

void append_simpler_cuts(std::vector<Case>& list, const Case& of) {
  const CutConfig usual{0.02F, 1000, 0};
  const auto append = [&](auto CutConfig::*field) {
    if (of.cut.*field == usual.*field) return;
    list.push_back(of);
    list.back().cut.*field = usual.*field;
  };
  append(&CutConfig::threshold);
  append(&CutConfig::max_size);
  append(&CutConfig::black_level);
  if (of.draws) {
    list.push_back(of);
    list.back().draws = false;
  }
  if (of.seed != 1) {
    list.push_back(of);
    list.back().seed = 1;
  }
}

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
    scene.mesh.positions.insert(scene.mesh.positions.end(), t.corners.begin(), t.corners.end());
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
  if (index % every == every - 1) return lottery(dice);
  return dice.one_in(8) ? picture(dice) : lights_and_views(dice);
}

std::vector<Case> simpler(const Case& of) {
  std::vector<Case> list;
  append_with_fewer_lights(list, of);
  append_without_chunks(list, of, &Case::views, 1);
  append_without_chunks(list, of, &Case::triangles, of.triangles.empty() ? 0 : 1);
  for (std::size_t i = 0; i < of.views.size(); ++i) {
    if (!of.views[i].hidden.empty()) {
      list.push_back(of);
      list.back().views[i].hidden.clear();
    }
    for (std::size_t k = 0; of.views[i].hidden.size() > 1 && k < of.views[i].hidden.size(); ++k) {
      list.push_back(of);
      auto& hidden = list.back().views[i].hidden;
      hidden.erase(hidden.begin() + std::ptrdiff_t(k));
    }
    append_each(list, of, gen::simpler(of.views[i].view),
                [i](Case& c) -> gen::View& { return c.views[i].view; });
  }
  append_simpler_cuts(list, of);
  append_each(list, of, gen::simpler(of.min_distance),
              [](Case& c) -> float& { return c.min_distance; });
  std::erase_if(list, [](const Case& c) { return c.min_distance < 0; });
  for (std::size_t i = 0; i < of.lights.size(); ++i)
    append_each(list, of, gen::simpler(of.lights[i]),
                [i](Case& c) -> Light& { return c.lights[i]; });
  if (!of.triangles.empty()) {
    for (glm::uvec2 size :
         {glm::uvec2(1), glm::uvec2(1, of.image_size.y), glm::uvec2(of.image_size.x, 1)})
      if (size != of.image_size) {
        list.push_back(of);
        list.back().image_size = size;
      }
    for (std::size_t i = 0; i < of.triangles.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        append_each(list, of, gen::simpler(of.triangles[i].corners[k]),
                    [i, k](Case& c) -> glm::vec3& { return c.triangles[i].corners[k]; });
  }
  return list;
}

} // namespace lightcuts::oracle
