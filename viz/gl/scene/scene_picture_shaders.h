// SPDX-License-Identifier: MIT
#pragma once

namespace lightcuts::viz {

/// Triangles, lit from the viewer; for SceneMesh.
extern const char* const headlight_vertex_shader;
extern const char* const headlight_fragment_shader;

/// Round points of a size in pixels.
extern const char* const point_vertex_shader;
extern const char* const point_fragment_shader;

/// Lines of a width in pixels, six vertices each.
extern const char* const line_vertex_shader;
extern const char* const line_fragment_shader;

} // namespace lightcuts::viz
