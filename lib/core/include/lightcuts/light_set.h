// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace lightcuts {

/// A point that radiates alike in all directions.
struct OmniLight {
  glm::vec3 position;  ///< metres
  glm::vec3 intensity; ///< radiant intensity per channel, W/sr, each >= 0
};

/// The lights of a scene. A light's index is its place in the order of adding.
class LightSet {
public:
  /// Adds an omni light. Throws InputError, naming the light by its index, where a component is NaN
  /// or infinite or an intensity is negative. A black light is allowed.
  void add_omni(const glm::vec3& position, const glm::vec3& intensity);

  void reserve(std::size_t count) { lights_.reserve(count); }
  [[nodiscard]] std::size_t size() const { return lights_.size(); }
  [[nodiscard]] bool empty() const { return lights_.empty(); }
  [[nodiscard]] const OmniLight& operator[](std::size_t i) const { return lights_[i]; }
  [[nodiscard]] auto begin() const { return lights_.begin(); }
  [[nodiscard]] auto end() const { return lights_.end(); }

private:
  std::vector<OmniLight> lights_;
};

} // namespace lightcuts
