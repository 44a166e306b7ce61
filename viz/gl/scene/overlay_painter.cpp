// SPDX-License-Identifier: MIT
#include <viz/gl/scene/overlay_painter.h>

#include <algorithm>
#include <cstddef>

#include <viz/gl/scene/scene_picture_shaders.h>

namespace lightcuts::viz {
namespace {

constexpr float hidden_opacity = 0.2F;

struct GpuPoint {
  glm::vec3 position;
  float size; // pixels
  Rgba8 colour;
};
static_assert(sizeof(GpuPoint) == 20);

struct GpuLine {
  glm::vec3 from, to;
  float width; // pixels
  Rgba8 colour;
};
static_assert(sizeof(GpuLine) == 32);

glm::vec3 relative(const glm::vec3& position, const glm::dvec3& anchor) {
  return glm::vec3(glm::dvec3(position) - anchor);
}

void set_view(const Program& program, const PaintView& view) {
  program.set("clip_from_offset", view.clip_from_offset);
  program.set("camera", view.camera);
  program.set("reach", view.reach);
  // What lies in a surface is seen: its depth is that of the surface a pixel or so away.
  program.set("nearer", std::max(1 - 2 * view.pixel, 0.5F));
}

/// Once through everything, once in front only.
template <class Draw>
void draw_twice(const Program& program, Draw draw) {
  enable_blending();
  glDepthMask(GL_FALSE);
  glDisable(GL_DEPTH_TEST);
  program.set("opacity", hidden_opacity);
  draw();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  program.set("opacity", 1.0F);
  draw();
}

} // namespace

PointCloud::PointCloud() {
  const auto attribute = [&](GLuint i, int components, GLenum type, std::size_t offset) {
    layout_.attribute(i, buffer_, components, type, type == GL_UNSIGNED_BYTE, sizeof(GpuPoint),
                      offset);
  };
  attribute(0, 3, GL_FLOAT, offsetof(GpuPoint, position));
  attribute(1, 1, GL_FLOAT, offsetof(GpuPoint, size));
  attribute(2, 4, GL_UNSIGNED_BYTE, offsetof(GpuPoint, colour));
}

void PointCloud::upload(std::span<const ColouredPoint> points, const glm::dvec3& anchor) {
  std::vector<GpuPoint> data;
  data.reserve(points.size());
  for (const ColouredPoint& p : points) data.push_back({relative(p.at, anchor), p.size, p.colour});
  buffer_.upload(GL_ARRAY_BUFFER, std::span<const GpuPoint>(data), GL_STREAM_DRAW);
  count_ = GLsizei(data.size());
}

void PointCloud::draw() const {
  layout_.bind();
  glDrawArrays(GL_POINTS, 0, count_);
}

LineSet::LineSet() {
  const auto attribute = [&](GLuint i, int components, GLenum type, std::size_t offset) {
    layout_.attribute(i, buffer_, components, type, type == GL_UNSIGNED_BYTE, sizeof(GpuLine),
                      offset);
    glVertexAttribDivisor(i, 1);
  };
  attribute(0, 3, GL_FLOAT, offsetof(GpuLine, from));
  attribute(1, 3, GL_FLOAT, offsetof(GpuLine, to));
  attribute(2, 1, GL_FLOAT, offsetof(GpuLine, width));
  attribute(3, 4, GL_UNSIGNED_BYTE, offsetof(GpuLine, colour));
}

void LineSet::upload(std::span<const ColouredLine> lines, const glm::dvec3& anchor) {
  std::vector<GpuLine> data;
  data.reserve(lines.size());
  for (const ColouredLine& l : lines)
    data.push_back({relative(l.a, anchor), relative(l.b, anchor), l.width, l.colour});
  buffer_.upload(GL_ARRAY_BUFFER, std::span<const GpuLine>(data), GL_STREAM_DRAW);
  count_ = GLsizei(data.size());
}

// One instance of two triangles per line: wide lines are no part of the core profile.
void LineSet::draw() const {
  layout_.bind();
  glDrawArraysInstanced(GL_TRIANGLES, 0, 6, count_);
}

OverlayPainter::OverlayPainter()
    : point_program_(point_vertex_shader, point_fragment_shader),
      line_program_(line_vertex_shader, line_fragment_shader) {}

void OverlayPainter::paint(const PointCloud& points, const PaintView& view) const {
  set_view(point_program_, view);
  glEnable(GL_PROGRAM_POINT_SIZE);
  draw_twice(point_program_, [&] { points.draw(); });
}

void OverlayPainter::paint(const LineSet& lines, const PaintView& view) const {
  set_view(line_program_, view);
  line_program_.set("size", view.size);
  line_program_.set("near", view.near);
  draw_twice(line_program_, [&] { lines.draw(); });
}

} // namespace lightcuts::viz
