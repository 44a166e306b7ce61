// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <viz/gl/context/gl_objects.h>
#include <viz/model/cut/overlay.h>

namespace lightcuts::viz {

/// A point of view, for all that is drawn from it.
struct PaintView {
  glm::mat4 clip_from_offset; ///< see view_frame.h
  glm::vec3 camera;           ///< relative to the anchor of the positions, metres
  glm::vec2 size;             ///< of the picture, pixels
  float near;                 ///< metres
  float reach;                ///< metres at which the depth is 1
  float pixel;                ///< width of a pixel at distance 1
};

/// Points in the graphics card's memory.
class PointCloud {
public:
  PointCloud();
  /// Positions are stored relative to `anchor`.
  void upload(std::span<const ColouredPoint> points, const glm::dvec3& anchor);
  void draw() const;
  [[nodiscard]] std::size_t size() const { return std::size_t(count_); }

private:
  Buffer buffer_;
  VertexArray layout_;
  GLsizei count_ = 0;
};

/// Lines in the graphics card's memory.
class LineSet {
public:
  LineSet();
  /// Positions are stored relative to `anchor`.
  void upload(std::span<const ColouredLine> lines, const glm::dvec3& anchor);
  void draw() const;

private:
  Buffer buffer_;
  VertexArray layout_;
  GLsizei count_ = 0;
};

/// Draws lines and points into a picture with depth: fully where they are in front of what is
/// there, faintly where they are behind it.
class OverlayPainter {
public:
  OverlayPainter();
  void paint(const PointCloud& points, const PaintView& view) const;
  void paint(const LineSet& lines, const PaintView& view) const;

private:
  Program point_program_, line_program_;
};

} // namespace lightcuts::viz
