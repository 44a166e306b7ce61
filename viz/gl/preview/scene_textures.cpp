// SPDX-License-Identifier: MIT
#include <viz/gl/preview/scene_textures.h>

#include <algorithm>

namespace lightcuts::viz {
namespace {

GLint gl_wrap(Wrap wrap) {
  switch (wrap) {
  case Wrap::repeat:
    return GL_REPEAT;
  case Wrap::mirror:
    return GL_MIRRORED_REPEAT;
  case Wrap::clamp:
    break;
  }
  return GL_CLAMP_TO_EDGE;
}

/// How many texels along a side become one.
std::uint32_t block_side(glm::uvec2 size) {
  const std::uint32_t most = std::min(max_shown_texture_side, Texture2D::max_side());
  return (std::max(size.x, size.y) + most - 1) / most;
}

/// The mean over texel `place` of a picture of `size` texels, from block * block samples. With a
/// block of 1 that is the texel itself.
glm::vec3 block_mean(const Texture& texture, glm::uvec2 size, glm::uvec2 place,
                     std::uint32_t block) {
  constexpr TextureWrap wrap{Wrap::clamp, Wrap::clamp};
  glm::dvec3 sum(0);
  for (std::uint32_t y = 0; y < block; ++y)
    for (std::uint32_t x = 0; x < block; ++x) {
      const glm::dvec2 inside = (glm::dvec2(x, y) + 0.5) / double(block);
      sum += glm::dvec3(texture.at((glm::dvec2(place) + inside) / glm::dvec2(size), wrap));
    }
  return glm::vec3(sum / double(block * block));
}

Texture2D uploaded(const Texture& texture) {
  const std::uint32_t block = block_side(texture.size());
  const glm::uvec2 size = (texture.size() + (block - 1)) / block;
  std::vector<glm::vec3> texels;
  texels.reserve(std::size_t{size.x} * size.y);
  // v runs upwards, as OpenGL's rows do.
  for (std::uint32_t y = 0; y < size.y; ++y)
    for (std::uint32_t x = 0; x < size.x; ++x)
      texels.push_back(block_mean(texture, size, {x, y}, block));
  Texture2D result;
  result.upload(size, std::span<const glm::vec3>(texels));
  result.set_filter(GL_LINEAR);
  return result;
}

} // namespace

SceneTextures::SceneTextures(const std::vector<Texture>& textures) {
  textures_.reserve(textures.size());
  for (const Texture& texture : textures) textures_.push_back(uploaded(texture));
}

void SceneTextures::bind(const SurfaceTexture& texture, GLuint unit) const {
  const Texture2D& shown = textures_[texture.index];
  shown.set_wrap(gl_wrap(texture.wrap.u), gl_wrap(texture.wrap.v));
  shown.bind(unit);
}

} // namespace lightcuts::viz
