// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>
#include <lightcuts/core/lights/light.h>

namespace lightcuts {

/// The lights of a scene. A light's index is its place in the order of adding. All that add a light
/// throw InputError, naming the light by its index and the field, where a component is NaN or
/// infinite, an intensity is negative, a direction is not unit (within 1e-5), or an angle or a kind
/// is out of its domain; the set is as before, then. A black light is allowed.
class LightSet {
public:
  /// intensity in W/sr.
  void add_omni(const glm::vec3& position, const glm::vec3& intensity);

  /// A small piece of a diffuse surface with this normal; intensity along it, W/sr: radiance times
  /// area.
  void add_oriented(const glm::vec3& position, const glm::vec3& normal, const glm::vec3& intensity);

  /// Angles between the axis and the cone's rims, radians, 0 <= inner < outer <= pi: full intensity
  /// within the inner one, none beyond the outer one. Their cosines are rounded to floats; a rim
  /// that is lost in that becomes one of one float's step outwards: no cone is narrower than 0.02
  /// degrees.
  void add_spot(const glm::vec3& position, const glm::vec3& axis, const glm::vec3& intensity,
                float inner_angle, float outer_angle);

  /// A luminaire: intensity, W/sr, where the profile's share is 1; axis and plane as of Light, both
  /// unit.
  void add_profile(const glm::vec3& position, const glm::vec3& axis, const glm::vec3& plane,
                   const glm::vec3& intensity, const Profile& profile);

  /// travel: unit, the direction in which its light goes; irradiance of a surface facing it, W/m^2.
  void add_directional(const glm::vec3& travel, const glm::vec3& irradiance);

  /// Adds a light as it is, such as one of another set. A spot's cosines are those of Light.
  void add(const Light& light);

  /// Clamps distances: 1/max(d^2, min_distance^2) for 1/d^2, against the bright spots around VPLs.
  /// Metres, finite and > 0, else InputError. Not called: no clamp.
  void set_min_distance(float min_distance);
  /// 0: no clamp.
  [[nodiscard]] float min_distance() const { return min_distance_; }

  void reserve(std::size_t count) { lights_.reserve(count); }
  [[nodiscard]] std::size_t size() const { return lights_.size(); }
  [[nodiscard]] bool empty() const { return lights_.empty(); }
  [[nodiscard]] LightKinds kinds() const { return kinds_; }
  [[nodiscard]] const Light& operator[](std::size_t i) const { return lights_[i]; }
  [[nodiscard]] auto begin() const { return lights_.begin(); }
  [[nodiscard]] auto end() const { return lights_.end(); }

private:
  void keep(const Light& valid);

  std::vector<Light> lights_;
  LightKinds kinds_ = 0;
  float min_distance_ = 0;
};

} // namespace lightcuts
