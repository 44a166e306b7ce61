// SPDX-License-Identifier: MIT
#include <viz/gl/preview/preview_shaders.h>

namespace lightcuts::viz {

const char* const surface_vertex_shader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 vertex_normal;
layout(location = 2) in vec3 face_normal;
layout(location = 3) in vec2 vertex_uv;
uniform vec3 camera; // relative to the mesh's anchor
uniform mat4 clip_from_offset;
out vec3 offset;
out vec3 normal;
flat out vec3 face;
out vec2 uv;

void main() {
  offset = position - camera;
  normal = vertex_normal;
  face = face_normal;
  uv = vertex_uv;
  gl_Position = clip_from_offset * vec4(offset, 1.0);
}
)";

const char* const surface_fragment_shader = R"(#version 330 core
in vec3 offset;
in vec3 normal;
flat in vec3 face;
in vec2 uv;
uniform float reach;
uniform vec4 diffuse_alpha;
uniform vec3 f0, tinted_f0, emission;
uniform float textured; // 0 or 1
uniform sampler2D base;
layout(location = 0) out vec4 out_offset;
layout(location = 1) out vec4 out_normal;
layout(location = 2) out vec4 out_diffuse;
layout(location = 3) out vec4 out_f0;
layout(location = 4) out vec4 out_emission;

const float largest = 3.4e38;

// As lightcuts::surface_point does.
vec3 shading_normal() {
  vec3 geometric = dot(face, offset) > 0.0 ? -face : face;
  float squared = dot(normal, normal);
  if (squared < 1e-12) return geometric;
  vec3 n = normal * inversesqrt(squared);
  if (dot(n, geometric) < 0.0) n = -n;
  return dot(n, offset) < 0.0 ? n : geometric;
}

void main() {
  vec3 texel = mix(vec3(1.0), texture(base, uv).rgb, textured);
  out_offset = vec4(offset, 1.0);
  out_normal = vec4(shading_normal(), diffuse_alpha.a);
  out_diffuse = vec4(min(diffuse_alpha.rgb * texel, vec3(largest)), 0.0);
  out_f0 = vec4(clamp(f0 - tinted_f0 + tinted_f0 * texel, 0.0, 1.0), 0.0);
  out_emission = vec4(emission, 0.0);
  // Depth over reach: a float keeps its digits towards 0.
  gl_FragDepth = min(1.0 / (gl_FragCoord.w * reach), 1.0);
}
)";

const char* const full_screen_vertex_shader = R"(#version 330 core
void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
)";

const char* const lights_fragment_shader = R"(#version 330 core
struct Light {
  vec4 place, intensity, ramp; // see light_batch.h
};
layout(std140) uniform Lights {
  Light lights[256];
};
uniform int light_count;
uniform float min_distance2;
uniform sampler2D offsets, normals, diffuses, f0s;
out vec4 sum;

const float inverse_pi = 0.318309886;
const float tiny = 1e-37;

// tan^2(n,h) as Sight::half_tangent2 has it: where l and v are all but opposite l + v has few of
// their digits left, and n.l + n.v divides it. There, by the difference of their heights, which
// divides out, and by det(n, l, v), in which only what they differ aside is left to be magnified.
float half_tangent2(vec3 n, vec3 l, vec3 v, float light, float viewer) {
  vec3 both = l + v;
  float sum2 = dot(both, both);
  float up = max(light + viewer, 1e-15);
  if (sum2 >= 0.0625) {
    vec3 along = both - dot(n, both) * n;
    return min(dot(along, along) / (up * up), 1e30);
  }
  float light_sine = sqrt(max(1.0 - light * light, 0.0));
  float viewer_sine = sqrt(max(1.0 - viewer * viewer, 0.0));
  float in_plane = (light - viewer) / (light_sine + viewer_sine);
  float aside = dot(n, cross(both, v)) / up;
  float divisor = light_sine * viewer_sine + 1.0 - 0.5 * sum2 + light * viewer;
  return min(in_plane * in_plane + 2.0 * aside * aside / divisor, 1e30);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 seen = texelFetch(offsets, pixel, 0);
  if (seen.w == 0.0) discard;
  vec3 p = seen.xyz;
  vec4 normal_alpha = texelFetch(normals, pixel, 0);
  vec3 n = normal_alpha.xyz;
  float a2 = normal_alpha.w * normal_alpha.w;
  vec3 lambert = texelFetch(diffuses, pixel, 0).rgb * inverse_pi;
  vec3 f0 = texelFetch(f0s, pixel, 0).rgb;
  vec3 v = -normalize(p);
  float viewer = dot(n, v);
  float lobe_scale = viewer > 0.0 ? a2 * inverse_pi * 0.5 : 0.0; // 0 without a lobe
  float viewer_masked = sqrt(a2 + (1.0 - a2) * viewer * viewer);
  vec3 total = vec3(0.0);
  for (int i = 0; i < light_count; ++i) {
    vec4 place = lights[i].place, intensity = lights[i].intensity, ramp = lights[i].ramp;
    vec3 q = place.xyz - place.w * p;
    float distance2 = max(dot(q, q), tiny);
    vec3 l = q * inversesqrt(distance2);
    float cosine = max(dot(n, l), 0.0);
    float t = clamp(ramp.w - dot(ramp.xyz, l), 0.0, 1.0);
    float sent = mix(t, t * t, intensity.w);
    float falloff = place.w > 0.0 ? 1.0 / max(distance2, min_distance2) : 1.0;

    float tangent2 = half_tangent2(n, l, v, cosine, viewer);
    float ratio = (1.0 + tangent2) / max(a2 + tangent2, tiny);
    float masked = sqrt(a2 + (1.0 - a2) * cosine * cosine);
    float lobe =
        lobe_scale * ratio * ratio / max(cosine * viewer_masked + viewer * masked, 1e-20);
    float w = 1.0 - sqrt(0.5 + 0.5 * clamp(dot(l, v), -1.0, 1.0));
    vec3 fresnel = f0 + (1.0 - f0) * (w * w * (w * w) * w);

    total += (lambert + (lobe_scale > 0.0 ? lobe : 0.0) * fresnel) *
             (cosine * sent * falloff * intensity.rgb);
  }
  sum = vec4(total, 0.0);
}
)";

} // namespace lightcuts::viz
