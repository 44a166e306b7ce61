// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <lightcuts/render/scene/scene.h>

#include <viz/gl/context/gl_objects.h>

namespace lightcuts::viz {

/// Textures with more texels on a side are shown with fewer, each the mean of a block.
inline constexpr std::uint32_t max_shown_texture_side = 2048;

/// The base textures of a scene in the graphics card's memory, linear RGB floats.
class SceneTextures {
public:
  explicit SceneTextures(const std::vector<Texture>& textures);

  /// Binds the surface's texture to a unit, bilinear and wrapped as lightcuts::Texture::at does;
  /// v upwards. The surface has a texture.
  void bind(const SurfaceTexture& texture, GLuint unit) const;

private:
  std::vector<Texture2D> textures_;
};

} // namespace lightcuts::viz
