// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>
#include <lightcuts/core/geometry/box.h>
#include <lightcuts/render/scene/scene.h>

#include <viz/gl/context/gl_objects.h>

namespace lightcuts::viz {

/// The triangles of a scene in the graphics card's memory, 132 bytes each, sorted by surface.
/// Attributes: 0 position relative to anchor(), metres; 1 the vertex's normal, (0,0,0) where one of
/// the triangle's has none; 2 the face's unit normal, (0,0,0) without area; 3 uv, 0 without.
class SceneMesh {
public:
  /// Triangles of one surface: vertices [first, first + count).
  struct Range {
    std::uint32_t surface;
    GLint first;
    GLsizei count;
  };

  /// The scene must be valid (see lightcuts::validate), but may be without triangles.
  explicit SceneMesh(const Scene& scene);

  /// Positions are relative to this, so that scenes far from the origin keep their digits.
  [[nodiscard]] const glm::dvec3& anchor() const { return anchor_; }
  /// Of all triangles, metres; empty without any.
  [[nodiscard]] const Box& bounds() const { return bounds_; }
  /// In the order of surfaces; those without triangles are left out.
  [[nodiscard]] const std::vector<Range>& ranges() const { return ranges_; }

  /// Draws with the program in use.
  void draw(const Range& range) const;

private:
  Box bounds_;
  glm::dvec3 anchor_{0};
  std::vector<Range> ranges_;
  Buffer vertices_;
  VertexArray layout_;
};

} // namespace lightcuts::viz
