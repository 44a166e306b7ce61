// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/render/scene/scene.h>

#include <lightcuts/render/lighting/random.h>

namespace lightcuts {

/// A triangle whose emission a texture multiplies, in pieces between the centres of texels, where a
/// bilinear lookup is one polynomial: their integrals are exact but for the rounding of double.
class TexturedEmitter {
public:
  /// A light in place of a part of the triangle.
  struct Sample {
    glm::dvec2 barycentric; ///< of the corners b and c
    glm::dvec3 intensity;   ///< integral of the radiance over the part, W/sr along the normal
  };

  /// The triangle's surface has an emission texture. The scene must be valid and outlive it.
  TexturedEmitter(const Scene& scene, std::uint32_t triangle);

  /// Integral of the radiance over the triangle's area, W/sr per channel.
  [[nodiscard]] const glm::dvec3& intensity() const { return intensity_; }

  /// Whether the pieces are so many, or so thin in the texture, that the radiance was sampled at
  /// many points instead.
  [[nodiscard]] bool is_approximate() const { return approximate_; }

  /// The triangle in `count` parts of equal mean intensity, neighbours as far as may be; in each a
  /// point, drawn in proportion to the intensity of the pieces. The intensities sum to intensity().
  [[nodiscard]] std::vector<Sample> samples(std::uint32_t count, Random random) const;

private:
  /// Part of the triangle within a square of the texture, or a triangle of a subdivision.
  struct Piece {
    std::uint64_t order; ///< along a curve through the texture
    std::int64_t column, row;
    glm::dvec3 intensity;
  };

  void add_cells();
  void add_row(std::int64_t row, const std::vector<glm::dvec2>& strip);
  void add_subdivision();
  [[nodiscard]] std::vector<glm::dvec2> outline(const Piece& piece) const;
  [[nodiscard]] glm::dvec2 barycentric(const glm::dvec2& texel) const;
  [[nodiscard]] glm::dvec3 radiance_at(const glm::dvec2& texel) const;

  const Texture& texture_;
  TextureWrap wrap_;
  glm::dvec3 emission_;
  double area_;           ///< m^2
  glm::dvec2 corners_[3]; ///< in texels from the first one's centre
  double doubled_texels_; ///< twice the triangle's signed area in the texture
  std::int64_t side_ = 1; ///< of a piece's square, texels
  bool approximate_ = false;
  std::vector<Piece> pieces_;
  glm::dvec3 intensity_{0};
};

} // namespace lightcuts
