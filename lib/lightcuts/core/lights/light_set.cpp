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

/// Refuses what is wrong with one light. Texts are made for those that are refused only.
class Door {
public:
  explicit Door(std::size_t index) : index_(index) {}

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
                       light() + field + " has length " + std::to_string(length) + ", not 1");
  }
  void require(bool holds, const char* field, float value, const char* why) const {
    if (!holds) refuse(field, value, why);
  }

  /// All fields that the light's kind has.
  void require_valid(const Light& light) const {
    require_known(light.kind);
    for_each_field(light, [this](const char* field, const auto& value, const Domain& domain) {
      require_in(domain, field, value);
    });
    if (light.kind == LightKind::spot && light.cos_inner <= light.cos_outer)
      refuse(InputFault::out_of_domain, "cos_inner", light.cos_inner,
             "expected more than cos_outer");
  }

private:
  void require_known(LightKind kind) const {
    if (unsigned(kind) >= unsigned(light_kind_count))
      throw InputError(InputFault::out_of_domain,
                       light() + "kind is " + std::to_string(unsigned(kind)) + ", not one of " +
                           std::to_string(light_kind_count));
  }
  void require_in(const Domain& /*known*/, const char* /*field*/, LightKind /*kind*/) const {}
  void require_in(const Domain& /*valid*/, const char* /*field*/, const Profile& /*p*/) const {}
  void require_in(const Domain& domain, const char* field, float value) const {
    if (value >= domain.least && value <= domain.most) return; // NaN is not
    refuse(std::isfinite(value) ? InputFault::out_of_domain : InputFault::not_finite, field, value,
           "out of its domain");
  }
  void require_in(const Domain& domain, const char* field, const glm::vec3& v) const {
    if (domain.unit) return require_unit(field, v);
    if (domain.least == 0) return require_intensity(field, v);
    require_finite(field, v);
  }

  [[noreturn]] void refuse(const std::string& field, float value, const char* why) const {
    refuse(fault_of(value), field, value, why);
  }
  [[noreturn]] void refuse(InputFault fault, const std::string& field, float value,
                           const char* why) const {
    throw InputError(fault, light() + field + " is " + number_text(value) + ", " + why);
  }
  [[nodiscard]] std::string light() const { return "light " + std::to_string(index_) + ": "; }

  std::size_t index_;
};

} // namespace

void LightSet::keep(const Light& valid) {
  lights_.push_back(valid);
  kinds_ |= only(valid.kind);
}

void LightSet::add(const Light& light) {
  Door(size()).require_valid(light);
  keep(light);
}

void LightSet::add_omni(const glm::vec3& position, const glm::vec3& intensity) {
  const Door door(size());
  door.require_finite("position", position);
  door.require_intensity("intensity", intensity);
  keep({.kind = LightKind::omni, .position = position, .intensity = intensity});
}

void LightSet::add_oriented(const glm::vec3& position, const glm::vec3& normal,
                            const glm::vec3& intensity) {
  const Door door(size());
  door.require_finite("position", position);
  door.require_unit("normal", normal);
  door.require_intensity("intensity", intensity);
  keep({.kind = LightKind::oriented, .position = position, .intensity = intensity, .axis = normal});
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
  keep({.kind = LightKind::spot,
        .position = position,
        .intensity = intensity,
        .axis = axis,
        .cos_inner = cos_inner,
        .cos_outer = std::min(cos_outer, std::nextafter(cos_inner, -2.0F))});
}

void LightSet::add_profile(const glm::vec3& position, const glm::vec3& axis, const glm::vec3& plane,
                           const glm::vec3& intensity, const Profile& profile) {
  add({.kind = LightKind::profile,
       .position = position,
       .intensity = intensity,
       .axis = axis,
       .plane = plane,
       .profile = profile});
}

void LightSet::add_directional(const glm::vec3& travel, const glm::vec3& irradiance) {
  const Door door(size());
  door.require_unit("direction", travel);
  door.require_intensity("irradiance", irradiance);
  keep({.kind = LightKind::directional, .position = -travel, .intensity = irradiance});
}

void LightSet::set_min_distance(float min_distance) {
  if (!(min_distance > 0 && std::isfinite(min_distance)))
    throw InputError(fault_of(min_distance), "min_distance is " + number_text(min_distance) +
                                                 ", expected a finite number above 0");
  min_distance_ = min_distance;
}

} // namespace lightcuts
