// SPDX-License-Identifier: MIT
#include <lightcuts/core/lights/light_set.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <glm/geometric.hpp>

#include <lightcuts/core/input_error.h>
#include <lightcuts/core/numerics/number_text.h>

namespace lightcuts {
namespace {

/// Refuses what is wrong with one light.
class Door {
public:
  explicit Door(std::size_t index) : light_("light " + std::to_string(index) + ": ") {}

  void require_finite(const char* field, const glm::vec3& v, const char* axes = "xyz") const {
    for (int i = 0; i < 3; ++i)
      if (!std::isfinite(v[i]))
        refuse(std::string(field) + "." + axes[i], v[i], "not a finite number");
  }
  void require_intensity(const char* field, const glm::vec3& v) const {
    require_finite(field, v, "rgb");
    for (int c = 0; c < 3; ++c)
      if (v[c] < 0) refuse(std::string(field) + "." + "rgb"[c], v[c], "negative");
  }
  void require_unit(const char* field, const glm::vec3& v) const {
    require_finite(field, v);
    const double length = glm::length(glm::dvec3(v));
    if (!(std::abs(length - 1) <= 1e-5))
      throw InputError(InputFault::not_unit,
                       light_ + field + " has length " + std::to_string(length) + ", not 1");
  }
  void require(bool holds, const char* field, float value, const char* why) const {
    if (!holds) refuse(field, value, why);
  }

private:
  [[noreturn]] void refuse(const std::string& field, float value, const char* why) const {
    throw InputError(fault_of(value), light_ + field + " is " + number_text(value) + ", " + why);
  }
  std::string light_;
};

} // namespace

void LightSet::add_omni(const glm::vec3& position, const glm::vec3& intensity) {
  const Door door(size());
  door.require_finite("position", position);
  door.require_intensity("intensity", intensity);
  add({.kind = LightKind::omni, .position = position, .intensity = intensity});
}

void LightSet::add_oriented(const glm::vec3& position, const glm::vec3& normal,
                            const glm::vec3& intensity) {
  const Door door(size());
  door.require_finite("position", position);
  door.require_unit("normal", normal);
  door.require_intensity("intensity", intensity);
  add({.kind = LightKind::oriented, .position = position, .intensity = intensity, .axis = normal});
}

void LightSet::add_spot(const glm::vec3& position, const glm::vec3& axis,
                        const glm::vec3& intensity, float inner_angle, float outer_angle) {
  const Door door(size());
  door.require_finite("position", position);
  door.require_unit("axis", axis);
  door.require_intensity("intensity", intensity);
  // The nearest float to pi lies above it.
  constexpr float half_turn = std::numbers::pi_v<float>;
  door.require(outer_angle > 0 && outer_angle <= half_turn, "outer angle", outer_angle,
               "expected more than 0 and at most pi");
  door.require(inner_angle >= 0 && inner_angle < outer_angle, "inner angle", inner_angle,
               "expected 0 or more and less than the outer angle");
  const auto cos_inner = static_cast<float>(std::cos(double(inner_angle)));
  const auto cos_outer = static_cast<float>(std::cos(double(outer_angle)));
  add({.kind = LightKind::spot,
       .position = position,
       .intensity = intensity,
       .axis = axis,
       .cos_inner = cos_inner,
       .cos_outer = std::min(cos_outer, std::nextafter(cos_inner, -2.0F))});
}

void LightSet::add_directional(const glm::vec3& travel, const glm::vec3& irradiance) {
  const Door door(size());
  door.require_unit("direction", travel);
  door.require_intensity("irradiance", irradiance);
  add({.kind = LightKind::directional, .position = -travel, .intensity = irradiance});
}

void LightSet::set_min_distance(float min_distance) {
  if (!(min_distance > 0 && std::isfinite(min_distance)))
    throw InputError(fault_of(min_distance), "min_distance is " + number_text(min_distance) +
                                                 ", expected a finite number above 0");
  min_distance_ = min_distance;
}

} // namespace lightcuts
