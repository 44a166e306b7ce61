// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

namespace lightcuts {

/// Where and from where a surface is seen. Floats are taken as exact real numbers; the length of a
/// direction is divided out wherever it is used.
class ShadingFrame {
public:
  /// position in metres; normal and to_viewer unit vectors (length within 1e-5 of 1). Throws
  /// InputError, naming the field, where a component is not finite or a direction is not unit.
  ShadingFrame(const glm::vec3& position, const glm::vec3& normal, const glm::vec3& to_viewer);

  [[nodiscard]] const glm::vec3& position() const { return position_; }
  [[nodiscard]] const glm::vec3& normal() const { return normal_; }
  [[nodiscard]] const glm::vec3& to_viewer() const { return to_viewer_; }
  /// The viewer's direction mirrored at the normal, 2 (n.o) n - o, rounded: within mirror_error of
  /// the real one.
  [[nodiscard]] const glm::vec3& mirror() const { return mirror_; }
  static constexpr double mirror_error = 0x1.1p-24; ///< radians

  /// 1 / |normal|, 1 / |to_viewer| and 1 / |mirror|.
  [[nodiscard]] double inverse_normal_length() const { return inverse_normal_length_; }
  [[nodiscard]] double inverse_viewer_length() const { return inverse_viewer_length_; }
  [[nodiscard]] double inverse_mirror_length() const { return inverse_mirror_length_; }
  /// cos(normal, to_viewer), sign and zero exact; negative: seen from behind.
  [[nodiscard]] double viewer_cosine() const { return viewer_cosine_; }

private:
  glm::vec3 position_, normal_, to_viewer_, mirror_;
  double inverse_normal_length_, inverse_viewer_length_, inverse_mirror_length_, viewer_cosine_;
};

} // namespace lightcuts
