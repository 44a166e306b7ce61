// SPDX-License-Identifier: MIT
#include <viz/gl/scene/scene_picture_shaders.h>

namespace lightcuts::viz {

const char* const headlight_vertex_shader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 vertex_normal;
layout(location = 2) in vec3 face_normal;
uniform vec3 camera; // relative to the mesh's anchor
uniform mat4 clip_from_offset;
out vec3 offset;
out vec3 normal;
flat out vec3 face;

void main() {
  offset = position - camera;
  normal = vertex_normal;
  face = face_normal;
  gl_Position = clip_from_offset * vec4(offset, 1.0);
}
)";

const char* const headlight_fragment_shader = R"(#version 330 core
in vec3 offset;
in vec3 normal;
flat in vec3 face;
uniform vec4 colour;
uniform float reach;
out vec4 result;

void main() {
  vec3 n = dot(normal, normal) < 1e-12 ? face : normalize(normal);
  float facing = abs(dot(n, normalize(offset)));
  float depth = min(1.0 / (gl_FragCoord.w * reach), 1.0);
  // Darker with the distance: else parallel faces would melt into one.
  result = vec4(colour.rgb * (0.35 + 0.65 * facing) * (1.0 - 0.35 * depth), colour.a);
  gl_FragDepth = depth;
}
)";

const char* const point_vertex_shader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in float point_size;
layout(location = 2) in vec4 point_colour;
uniform vec3 camera; // relative to the anchor of the positions
uniform mat4 clip_from_offset;
out vec4 colour;

void main() {
  colour = point_colour;
  gl_PointSize = point_size;
  gl_Position = clip_from_offset * vec4(position - camera, 1.0);
}
)";

const char* const point_fragment_shader = R"(#version 330 core
in vec4 colour;
uniform float reach, nearer, opacity;
out vec4 result;

void main() {
  vec2 from_centre = 2.0 * gl_PointCoord - 1.0;
  if (dot(from_centre, from_centre) > 1.0) discard;
  result = vec4(colour.rgb, colour.a * opacity);
  gl_FragDepth = min(nearer / (gl_FragCoord.w * reach), 1.0);
}
)";

const char* const line_vertex_shader = R"(#version 330 core
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in float width;
layout(location = 3) in vec4 line_colour;
uniform vec3 camera; // relative to the anchor of the positions
uniform mat4 clip_from_offset;
uniform vec2 size;
uniform float near;
out vec4 colour;

// The end `a`, or where the line comes out of the plane in front of the camera.
vec4 in_front(vec4 a, vec4 b) {
  return a.w < near && b.w > near ? mix(a, b, (near - a.w) / (b.w - a.w)) : a;
}

void main() {
  vec4 a = clip_from_offset * vec4(from - camera, 1.0);
  vec4 b = clip_from_offset * vec4(to - camera, 1.0);
  vec4 first = in_front(a, b), second = in_front(b, a);
  vec2 along = (second.xy / second.w - first.xy / first.w) * size;
  float pixels = length(along);
  vec2 across = pixels > 0.0 ? vec2(-along.y, along.x) / pixels : vec2(0.0, 1.0);
  // Two triangles of the corners 0 1 2 and 2 1 3: of each end, one on either side.
  int corner = gl_VertexID < 3 ? gl_VertexID : (gl_VertexID == 3 ? 2 : gl_VertexID == 4 ? 1 : 3);
  vec4 end = corner < 2 ? first : second;
  float side = (corner & 1) == 0 ? -1.0 : 1.0;
  colour = line_colour;
  gl_Position = vec4(end.xy + side * width / size * across * end.w, end.zw);
}
)";

const char* const line_fragment_shader = R"(#version 330 core
in vec4 colour;
uniform float reach, nearer, opacity;
out vec4 result;

void main() {
  result = vec4(colour.rgb, colour.a * opacity);
  gl_FragDepth = min(nearer / (gl_FragCoord.w * reach), 1.0);
}
)";

} // namespace lightcuts::viz
