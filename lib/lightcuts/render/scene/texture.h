// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace lightcuts {

/// Largest width and height of a texture, texels.
inline constexpr std::uint32_t max_texture_side = 16384;

/// How a texture goes on outside [0, 1] of a coordinate.
enum class Wrap : std::uint8_t {
  repeat, ///< again and again
  mirror, ///< again and again, every second time reversed
  clamp,  ///< with the texel at the edge
};

/// How a texture goes on in either direction.
struct TextureWrap {
  Wrap u = Wrap::repeat;
  Wrap v = Wrap::repeat;
};

/// An image that scales a surface's colour, place by place: linear RGB, finite and >= 0. All const
/// functions may be called from many threads.
class Texture {
public:
  /// size.x * size.y texels, row by row from the top. A component that is negative or not a number
  /// becomes 0, one that is infinite the largest float. Throws InputError where a side is not in
  /// [1, max_texture_side] or the number of texels is another one.
  Texture(glm::uvec2 size, std::vector<glm::vec3> texels);

  [[nodiscard]] glm::uvec2 size() const { return size_; }

  /// How many texels the constructor had to change.
  [[nodiscard]] std::size_t clamped() const { return clamped_; }

  /// The colour at uv (finite), bilinear between the centres of texels. u runs to the right and v
  /// upwards: (0, 0) is the lower left corner of the image, (1, 1) the upper right one, so that
  /// glTF's v, which runs downwards, is 1 - v here. Never NaN, infinite or negative.
  [[nodiscard]] glm::vec3 at(const glm::dvec2& uv, const TextureWrap& wrap = {}) const;

private:
  glm::uvec2 size_;
  std::vector<glm::vec3> texels_;
  std::size_t clamped_ = 0;
};

} // namespace lightcuts
