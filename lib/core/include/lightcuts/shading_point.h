// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <lightcuts/material.h>

namespace lightcuts {

/// A point of a surface, seen from one direction. Its floats are taken as exact real numbers;
/// `normal` and `mirror` are directions: their length is divided out wherever they are used.
class ShadingPoint {
public:
  /// position in metres; normal and to_viewer unit vectors (length within 1e-5 of 1; the mirror
  /// direction is computed in double and rounded). Throws InputError, naming the field, where a
  /// component is not finite, a direction is not unit, or the material is out of its domain.
  ShadingPoint(const glm::vec3& position, const glm::vec3& normal, const glm::vec3& to_viewer,
               const Material& material);

  [[nodiscard]] const glm::vec3& position() const { return position_; }
  [[nodiscard]] const glm::vec3& normal() const { return normal_; }
  /// The viewer's direction mirrored at the normal: 2 (n.o) n - o.
  [[nodiscard]] const glm::vec3& mirror() const { return mirror_; }
  [[nodiscard]] const Material& material() const { return material_; }

  /// 1 / |normal| and 1 / |mirror|.
  [[nodiscard]] double inverse_normal_length() const { return inverse_normal_length_; }
  [[nodiscard]] double inverse_mirror_length() const { return inverse_mirror_length_; }

private:
  glm::vec3 position_, normal_, mirror_;
  Material material_;
  double inverse_normal_length_, inverse_mirror_length_;
};

} // namespace lightcuts
