// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <initializer_list>
#include <numbers>
#include <span>
#include <vector>

#include <glm/geometric.hpp>
#include <oracle/cases/catalogue/catalogue.h>
#include <oracle/numbers/dice.h>

/// What entries of the catalogue are made of.
namespace lightcuts::oracle::making {

// The entries by subject.
[[nodiscard]] std::span<const NamedCase> scales();
[[nodiscard]] std::span<const NamedCase> places();
[[nodiscard]] std::span<const NamedCase> directions();
[[nodiscard]] std::span<const NamedCase> lobes();
[[nodiscard]] std::span<const NamedCase> triangles();
[[nodiscard]] std::span<const NamedCase> counts();

inline constexpr float least = 0x1p-149F, largest = 0x1.fffffep127F;

inline glm::vec3 unit(const glm::dvec3& v) { return glm::vec3(glm::normalize(v)); }

inline Light omni(const glm::vec3& position, const glm::vec3& intensity = glm::vec3(1)) {
  return {.position = position, .intensity = intensity};
}
inline Light oriented(const glm::vec3& position, const glm::vec3& axis) {
  return {
      .kind = LightKind::oriented, .position = position, .intensity = glm::vec3(1), .axis = axis};
}
inline Light spot(const glm::vec3& position, const glm::vec3& axis, float cos_inner,
                  float cos_outer) {
  return {.kind = LightKind::spot,
          .position = position,
          .intensity = glm::vec3(1),
          .axis = axis,
          .cos_inner = cos_inner,
          .cos_outer = cos_outer};
}
inline Light sun(const glm::vec3& towards) {
  return {.kind = LightKind::directional, .position = towards, .intensity = glm::vec3(1)};
}

/// Seen from there.
inline Case lit(std::vector<Light> lights, std::initializer_list<gen::View> views = {{}}) {
  Case c;
  c.lights = std::move(lights);
  for (const gen::View& view : views) c.views.push_back({view, {}});
  return c;
}

/// f(i, dice) for each light.
template <class F>
std::vector<Light> lights(int count, F&& f) {
  gen::Dice dice(std::uint64_t(count) + 7);
  std::vector<Light> list;
  list.reserve(std::size_t(count));
  for (int i = 0; i < count; ++i) list.push_back(f(i, dice));
  return list;
}

/// In a cube of that half-width about a point.
inline glm::vec3 about(gen::Dice& dice, const glm::vec3& centre, double half = 1) {
  return glm::vec3(glm::dvec3(centre) + half * glm::dvec3(dice.in_cube()));
}

} // namespace lightcuts::oracle::making
