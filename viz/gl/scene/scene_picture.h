// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/geometry/box.h>
#include <lightcuts/render/scene/scene.h>

#include <viz/gl/context/gl_objects.h>
#include <viz/gl/scene/orbit_camera.h>
#include <viz/gl/scene/overlay_painter.h>
#include <viz/gl/scene/scene_mesh.h>
#include <viz/model/cut/overlay.h>

namespace lightcuts::viz {

/// Which sides of triangles are solid; the others are drawn faintly.
enum class SolidFaces {
  fronts, ///< a closed room is seen into like a dollhouse: the walls' fronts are inside
  both    ///< for models whose triangles are wound either way
};

/// A scene and its lights from outside, by OpenGL: geometry in pale colours, lit from the viewer;
/// each light a point of its colour (at most max_shown_lights of them: a random subset, always the
/// same); the traced camera; an overlay of lines and points, faint where hidden.
///
/// Needs a current OpenGL 3.3 context in every call, always the same; calls leave the
/// framebuffer and the viewport as they were.
class ScenePicture {
public:
  static constexpr std::size_t max_shown_lights = 100000;
  static constexpr Rgba8 camera_colour{255, 210, 90, 255}; ///< of the traced camera's lines

  struct Config {
    bool geometry = true;                     ///< default true
    bool lights = true;                       ///< default true
    SolidFaces solid = SolidFaces::fronts;    ///< default fronts
    Rgba8 background{24, 26, 30, 255};        ///< default a dark grey
    std::optional<Camera> traced_camera = {}; ///< shown if given; default none
    glm::uvec2 traced_size{640, 480};         ///< of its image, pixels; default 640 x 480
    double traced_depth = 0;                  ///< of its pyramid, metres; 0: a fifteenth of the
                                              ///< scene's diagonal; default 0
  };

  /// The scene must be valid (see lightcuts::validate), though it may lack triangles. Throws
  /// GlError where the driver refuses. The scene is not needed afterwards.
  explicit ScenePicture(const Scene& scene);

  /// Draws the scene into a picture of `size` pixels. Throws InputError where a camera is invalid
  /// or a side is 0, GlError where the driver cannot draw pictures that large.
  void draw(const OrbitCamera& camera, glm::uvec2 size, const Config& config,
            const Overlay& overlay = {});

  /// The picture, RGBA8; OpenGL's first row, v = 0, is the lowest.
  [[nodiscard]] const Texture2D& texture() const { return target_.colour(0); }
  /// The pixels, row by row from the top.
  [[nodiscard]] std::vector<Rgba8> pixels() const { return target_.read_rgba8(0); }

  /// How many of the scene's lights are drawn.
  [[nodiscard]] std::size_t shown_lights() const { return lights_.size(); }
  /// Of the triangles and the lights that have a place, metres: what OrbitCamera::fit wants. Empty
  /// in an empty scene.
  [[nodiscard]] const Box& bounds() const { return bounds_; }

private:
  [[nodiscard]] PaintView paint_view(const OrbitCamera& camera, glm::uvec2 size) const;
  void draw_geometry(const PaintView& view, SolidFaces solid) const;
  void draw_surfaces(float opacity) const;
  void draw_overlay(const PaintView& view, const Overlay& overlay);
  void draw_traced_camera(const PaintView& view, const Config& config);

  SceneMesh mesh_;
  Box bounds_;
  std::vector<glm::vec3> colours_; // per surface, as shown
  PointCloud lights_, points_;
  LineSet lines_;
  Program surface_program_;
  OverlayPainter painter_;
  Framebuffer target_;
};

} // namespace lightcuts::viz
