// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/render/scene/scene.h>

#include <viz/gl/context/gl_objects.h>
#include <viz/gl/preview/preview_material.h>
#include <viz/gl/preview/scene_textures.h>
#include <viz/gl/scene/light_batch.h>
#include <viz/gl/scene/scene_mesh.h>
#include <viz/gl/scene/view_frame.h>

namespace lightcuts::viz {

/// A picture of a scene by rasterisation that comes at once and gets exact: ALL lights, batch after
/// batch in a random order, but no shadows. Diffuse and Cook-Torrance surfaces as the renderer has
/// them, in single precision; for others see preview_material.h.
///
/// Needs a current OpenGL 3.3 context in every call, always the same; calls leave the
/// framebuffer and the viewport as they were.
class RasterPreview {
public:
  /// The scene must be valid (see lightcuts::validate), unchanged, and outlive the preview. Throws
  /// GlError where the driver refuses.
  explicit RasterPreview(const Scene& scene);

  /// Begins a picture of `size` pixels without any light. Throws InputError as PinholeView does,
  /// GlError where the driver cannot draw pictures that large; there is no picture then.
  void start(const Camera& camera, glm::uvec2 size);

  /// Adds lights until about `milliseconds` have passed, at least one. Whether all lights are in;
  /// true, too, where no picture was begun.
  bool advance(double milliseconds);

  /// How many of the lights are in the picture: 1 at the end, and in a scene without lights.
  [[nodiscard]] float share() const;
  /// Pixels of the picture; (0, 0) where none was begun.
  [[nodiscard]] glm::uvec2 size() const { return size_; }

  /// The picture, linear RGB, row by row from the top: the surface's emission and what it
  /// reflects of the lights so far, times 1/share(): on average over orders of the lights, that is
  /// the whole. 0 where a pixel sees no surface.
  [[nodiscard]] std::vector<glm::vec3> radiance() const;

private:
  void draw_surfaces(const ViewFrame& frame) const;
  void use_surface(std::uint32_t surface) const;
  void add_batch(std::size_t count);
  [[nodiscard]] std::size_t batch_size(double milliseconds) const;

  const Scene* scene_;
  SceneMesh mesh_;
  SceneTextures textures_;
  std::vector<PreviewMaterial> materials_; // per surface
  std::vector<std::uint32_t> order_;       // in which the lights come
  Program surface_program_, lights_program_;
  Buffer batch_buffer_;
  VertexArray no_attributes_;
  Texture2D no_texture_;
  Framebuffer surfaces_, sum_;
  glm::uvec2 size_{0};
  glm::dvec3 camera_{0};              // metres
  std::size_t done_ = 0;              // how many of order_ are in sum_
  std::size_t last_batch_ = 0;        // lights
  double milliseconds_per_light_ = 0; // in the last batch
};

} // namespace lightcuts::viz
