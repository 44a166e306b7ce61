// SPDX-License-Identifier: MIT
#include <oracle/cases/simpler.h>

#include <cmath>
#include <utility>
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

void simplify_lobe(std::vector<View>& list, const View& view) {
  const Lobe& lobe = view.material.lobe;
  if (std::holds_alternative<NoLobe>(lobe)) return;
  list.push_back(view);
  list.back().material.lobe = NoLobe{};
  const auto simplify_as = [&]<class OneLobe>(glm::vec3 OneLobe::*colour) {
    if (std::holds_alternative<OneLobe>(lobe))
      simplify_vector(list, view, [colour](View& v) -> glm::vec3& {
        return std::get<OneLobe>(v.material.lobe).*colour;
      });
  };
  simplify_as(&Phong::reflectance);
  simplify_as(&Ward::reflectance);
  simplify_as(&CookTorrance::f0);
  const auto simplify_alpha = [&]<class OneLobe>(float OneLobe::*alpha) {
    if (std::holds_alternative<OneLobe>(lobe))
      for (const float value : {1.0F, 0.5F, 0.125F}) {
        if (std::get<OneLobe>(lobe).*alpha == value) return;
        list.push_back(view);
        std::get<OneLobe>(list.back().material.lobe).*alpha = value;
      }
  };
  simplify_alpha(&Ward::alpha);
  simplify_alpha(&CookTorrance::alpha);
  if (std::holds_alternative<Phong>(lobe))
    simplify(list, view,
             [](View& v) -> float& { return std::get<Phong>(v.material.lobe).exponent; });
}

/// A half-space with a soft rim, or a cone of 60 degrees.
void simplify_cone(std::vector<Light>& list, const Light& light) {
  for (const auto& [inner, outer] : {std::pair(1.0F, 0.0F), std::pair(1.0F, 0.5F)}) {
    if (light.cos_inner == inner && light.cos_outer == outer) return;
    list.push_back(light);
    list.back().cos_inner = inner;
    list.back().cos_outer = outer;
  }
}

/// Copies of `whole` in which one part, reached by `part`, is simpler.
template <class T, class Part>
void simplify_part(std::vector<T>& list, const T& whole, Part&& part) {
  T copy = whole;
  for (const auto& value : simpler(std::as_const(part(copy)))) {
    part(copy) = value;
    list.push_back(copy);
  }
}

} // namespace

std::vector<float> simpler(const float& value) {
  if (value == 0) return std::signbit(value) ? std::vector<float>{0} : std::vector<float>{};
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
  for (const glm::vec3& axis : {glm::vec3(0, 0, 1), glm::vec3(0, 1, 0), glm::vec3(1, 0, 0),
                                glm::vec3(0, 0, -1), glm::vec3(0, -1, 0), glm::vec3(-1, 0, 0)}) {
    if (v == axis) break;
    list.push_back(axis);
  }
  // Still as good as unit without its tiny components.
  glm::vec3 grazing = v;
  for (int i = 0; i < 3; ++i)
    if (std::abs(v[i]) < 0x1p-12F) grazing[i] = 0;
  if (grazing != v) list.push_back(grazing);
  return list;
}

std::vector<glm::vec3> simpler(const glm::vec3& value) {
  std::vector<glm::vec3> list;
  simplify_vector(list, value, [](glm::vec3& v) -> glm::vec3& { return v; });
  return list;
}

std::vector<View> simpler(const View& view) {
  std::vector<View> list;
  simplify_vector(list, view, [](View& v) -> glm::vec3& { return v.position; });
  simplify_direction(list, view, [](View& v) -> glm::vec3& { return v.normal; });
  simplify_direction(list, view, [](View& v) -> glm::vec3& { return v.to_viewer; });
  simplify_vector(list, view, [](View& v) -> glm::vec3& { return v.material.diffuse; });
  simplify_lobe(list, view);
  return list;
}

std::vector<Light> simpler(const Light& light) {
  std::vector<Light> list;
  if (light.kind != LightKind::omni && light.kind != LightKind::directional) {
    list.push_back({.position = light.position, .intensity = light.intensity});
  }
  const auto position = [](Light& l) -> glm::vec3& { return l.position; };
  if (light.kind == LightKind::directional)
    simplify_direction(list, light, position);
  else
    simplify_vector(list, light, position);
  if ((only(light.kind) & kinds_with_axis) != 0)
    simplify_direction(list, light, [](Light& l) -> glm::vec3& { return l.axis; });
  if (light.kind == LightKind::spot) simplify_cone(list, light);
  simplify_vector(list, light, [](Light& l) -> glm::vec3& { return l.intensity; });
  return list;
}

std::vector<Scene> simpler(const Scene& scene) {
  std::vector<Scene> list = with_fewer_lights(scene);
  simplify_part(list, scene, [](Scene& s) -> View& { return s.view; });
  simplify(list, scene, [](Scene& s) -> float& { return s.min_distance; });
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    simplify_part(list, scene, [i](Scene& s) -> Light& { return s.lights[i]; });
  return list;
}

} // namespace lightcuts::gen
