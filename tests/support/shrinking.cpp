// SPDX-License-Identifier: MIT
#include "shrinking.h"

#include <variant>

namespace lightcuts::gen {
namespace {

void append_if_other(std::vector<float>& list, float value, float of) {
  if (value != of) list.push_back(value);
}

/// Copies of `whole` in which one float, reached by `part`, is simpler.
template <class T, class Part>
void simplify(std::vector<T>& list, const T& whole, Part&& part) {
  T copy = whole;
  for (const float value : simpler(std::as_const(part(copy)))) {
    part(copy) = value;
    list.push_back(copy);
  }
}

template <class T, class Part>
void simplify_vector(std::vector<T>& list, const T& whole, Part&& part) {
  for (int i = 0; i < 3; ++i) simplify(list, whole, [&](T& t) -> float& { return part(t)[i]; });
}

template <class T, class Part>
void simplify_direction(std::vector<T>& list, const T& whole, Part&& part) {
  T copy = whole;
  for (const glm::vec3& v : simpler_directions(part(copy))) {
    part(copy) = v;
    list.push_back(copy);
  }
}

std::vector<Scene> with_fewer_lights(const Scene& scene) {
  std::vector<Scene> list;
  const std::size_t count = scene.lights.size();
  for (std::size_t chunk = count / 2; chunk > 0; chunk /= 2)
    for (std::size_t first = 0; first + chunk <= count; first += chunk) {
      list.push_back(scene);
      auto& lights = list.back().lights;
      const auto begin = lights.begin() + static_cast<std::ptrdiff_t>(first);
      lights.erase(begin, begin + static_cast<std::ptrdiff_t>(chunk));
    }
  return list;
}

void simplify_lobe(std::vector<Scene>& list, const Scene& scene) {
  const Lobe& lobe = scene.view.material.lobe;
  if (std::holds_alternative<NoLobe>(lobe)) return;
  list.push_back(scene);
  list.back().view.material.lobe = NoLobe{};
  const auto simplify_as = [&]<class OneLobe>(glm::vec3 OneLobe::*colour) {
    if (std::holds_alternative<OneLobe>(lobe))
      simplify_vector(list, scene, [colour](Scene& s) -> glm::vec3& {
        return std::get<OneLobe>(s.view.material.lobe).*colour;
      });
  };
  simplify_as(&Phong::reflectance);
  simplify_as(&Ward::reflectance);
  simplify_as(&CookTorrance::f0);
  if (std::holds_alternative<Phong>(lobe))
    simplify(list, scene,
             [](Scene& s) -> float& { return std::get<Phong>(s.view.material.lobe).exponent; });
}

} // namespace

std::vector<float> simpler(const float& value) {
  if (value == 0) return {};
  std::vector<float> list{0};
  if (value == 1) return list;
  list.push_back(1);
  if (value < 0) list.push_back(-value);
  if (std::abs(value) < 0x1p24F) append_if_other(list, std::trunc(value), value);
  int exponent = 0;
  const float mantissa = std::frexp(value, &exponent);
  append_if_other(list, std::ldexp(mantissa, exponent / 2), value);
  for (const int bits : {1, 4, 12, 23})
    append_if_other(list, std::ldexp(std::trunc(std::ldexp(mantissa, bits)), exponent - bits),
                    value);
  return list;
}

std::vector<glm::vec3> simpler_directions(const glm::vec3& v) {
  std::vector<glm::vec3> list;
  for (const glm::vec3& axis : {glm::vec3(0, 0, 1), glm::vec3(0, 1, 0), glm::vec3(1, 0, 0)}) {
    if (v == axis) break;
    list.push_back(axis);
  }
  return list;
}

std::vector<Scene> simpler(const Scene& scene) {
  std::vector<Scene> list = with_fewer_lights(scene);
  simplify_vector(list, scene, [](Scene& s) -> glm::vec3& { return s.view.position; });
  simplify_direction(list, scene, [](Scene& s) -> glm::vec3& { return s.view.normal; });
  simplify_direction(list, scene, [](Scene& s) -> glm::vec3& { return s.view.to_viewer; });
  simplify_vector(list, scene, [](Scene& s) -> glm::vec3& { return s.view.material.diffuse; });
  simplify_lobe(list, scene);
  simplify(list, scene, [](Scene& s) -> float& { return s.min_distance; });
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const auto position = [i](Scene& s) -> glm::vec3& { return s.lights[i].position; };
    if (scene.lights[i].kind == LightKind::directional)
      simplify_direction(list, scene, position);
    else
      simplify_vector(list, scene, position);
    if ((only(scene.lights[i].kind) & kinds_with_axis) != 0)
      simplify_direction(list, scene, [i](Scene& s) -> glm::vec3& { return s.lights[i].axis; });
    simplify_vector(list, scene, [i](Scene& s) -> glm::vec3& { return s.lights[i].intensity; });
  }
  return list;
}

std::vector<BoxView> simpler(const BoxView& view) {
  std::vector<BoxView> list;
  simplify_vector(list, view, [](BoxView& v) -> glm::vec3& { return v.x; });
  simplify_vector(list, view, [](BoxView& v) -> glm::vec3& { return v.n; });
  simplify_vector(list, view, [](BoxView& v) -> glm::vec3& { return v.box.lo; });
  simplify_vector(list, view, [](BoxView& v) -> glm::vec3& { return v.box.hi; });
  std::erase_if(list, [](const BoxView& v) {
    return v.box.lo.x > v.box.hi.x || v.box.lo.y > v.box.hi.y || v.box.lo.z > v.box.hi.z;
  });
  return list;
}

} // namespace lightcuts::gen
