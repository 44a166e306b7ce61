// SPDX-License-Identifier: MIT
#include <oracle/cases/simpler.h>

#include <cmath>

#include <oracle/cases/simpler_values.h>

namespace lightcuts::gen {
namespace {

void append_if_other(std::vector<float>& list, float value, float of) {
  if (value != of) list.push_back(value);
}

bool is_cone(const Light& light) { return light.cos_inner > light.cos_outer; }

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
  return oracle::simpler_values(value, {}, {});
}

std::vector<View> simpler(const View& view) { return oracle::simpler_values(view); }
std::vector<Scene> simpler(const Scene& scene) { return oracle::simpler_values(scene); }

std::vector<Light> simpler(const Light& light) {
  std::vector<Light> list;
  if (light.kind != LightKind::omni && light.kind != LightKind::directional)
    list.push_back({.position = light.position, .intensity = light.intensity});
  if (light.kind == LightKind::profile && light.axis != glm::vec3(0, 0, 1)) {
    Light upright = light;
    upright.axis = {0, 0, 1};
    upright.plane = {1, 0, 0};
    list.push_back(upright);
  }
  for (const Light& simpler : oracle::simpler_values(light))
    if (is_cone(simpler)) list.push_back(simpler);
  return list;
}

} // namespace lightcuts::gen
