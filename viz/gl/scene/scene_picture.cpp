// SPDX-License-Identifier: MIT
#include <viz/gl/scene/scene_picture.h>

#include <algorithm>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <lightcuts/render/scene/bounds.h>

#include <viz/gl/scene/camera_lines.h>
#include <viz/gl/scene/picking.h>
#include <viz/gl/scene/random_order.h>
#include <viz/gl/scene/scene_picture_shaders.h>

namespace lightcuts::viz {
namespace {

/// What is nearer than this share of the farthest distance is not drawn.
constexpr double near_plane_share = 1e-5;
/// Of the faces through which one looks into a room.
constexpr float faint = 0.08F;
/// From here on, lights are small and let others shine through.
constexpr std::size_t many_lights = 2000;

/// Pale, and as bright whatever the reflectance, so that black furniture shows its shape.
glm::vec3 shown_colour(const Surface& surface) {
  const glm::vec3 reflected = glm::min(surface.material.diffuse + surface.emission, 1.0F);
  return glm::mix(glm::vec3(0.6F), glm::pow(reflected, glm::vec3(1 / 2.2F)), 0.45F);
}

/// The hue of a light at full brightness; grey for a black one.
Rgba8 shown_colour(const Light& light, std::uint8_t opacity) {
  const float most = std::max({light.intensity.r, light.intensity.g, light.intensity.b});
  if (!(most > 0)) return {90, 90, 90, opacity};
  return {glm::vec<3, std::uint8_t>(glm::round(255.0F * (light.intensity / most))), opacity};
}

std::vector<ColouredPoint> light_points(const Scene& scene, const Box& bounds) {
  const LightSet& lights = scene.lights;
  std::vector<std::uint32_t> shown = random_order(lights.size());
  shown.resize(std::min(shown.size(), ScenePicture::max_shown_lights));
  const bool many = shown.size() > many_lights;
  std::vector<ColouredPoint> points;
  points.reserve(shown.size());
  for (const std::uint32_t i : shown)
    points.push_back({glm::vec3(shown_position(lights[i], bounds)),
                      shown_colour(lights[i], many ? 140 : 255), many ? 3.0F : 6.0F});
  return points;
}

Box bounds_with_lights(Box box, const LightSet& lights) {
  for (const Light& light : lights)
    if (!is_at_infinity(light.kind)) box.extend(light.position);
  return box;
}

} // namespace

ScenePicture::ScenePicture(const Scene& scene)
    : mesh_(scene), bounds_(bounds_with_lights(mesh_.bounds(), scene.lights)),
      surface_program_(headlight_vertex_shader, headlight_fragment_shader),
      target_({TexelFormat::rgba8}, true) {
  for (const Surface& surface : scene.surfaces) colours_.push_back(shown_colour(surface));
  lights_.upload(light_points(scene, mesh_.bounds()), mesh_.anchor());
}

void ScenePicture::draw(const OrbitCamera& camera, glm::uvec2 size, const Config& config,
                        const Overlay& overlay) {
  const PaintView view = paint_view(camera, size);
  target_.resize(size);
  const DrawScope scope;
  target_.bind();
  const glm::vec4 background = glm::vec4(config.background) / 255.0F;
  glClearColor(background.r, background.g, background.b, background.a);
  glClearDepth(1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  if (config.geometry) draw_geometry(view, config.solid);
  if (config.lights) painter_.paint(lights_, view);
  if (config.traced_camera) draw_traced_camera(view, config);
  draw_overlay(view, overlay);
}

PaintView ScenePicture::paint_view(const OrbitCamera& camera, glm::uvec2 size) const {
  const ViewFrame frame = camera.frame(size);
  const double far = std::max(reach(frame.origin, bounds_), camera.distance);
  const double near = near_plane_share * far;
  return {clip_from_offset(frame, near),
          glm::vec3(frame.origin - mesh_.anchor()),
          glm::vec2(size),
          float(near),
          float(far),
          float(2 * frame.half.y / size.y)};
}

void ScenePicture::draw_geometry(const PaintView& view, SolidFaces solid) const {
  surface_program_.set("clip_from_offset", view.clip_from_offset);
  surface_program_.set("camera", view.camera);
  surface_program_.set("reach", view.reach);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  if (solid == SolidFaces::both) return draw_surfaces(1);
  glEnable(GL_CULL_FACE);
  glFrontFace(GL_CCW);
  glCullFace(GL_BACK);
  draw_surfaces(1);
  glCullFace(GL_FRONT);
  glDepthMask(GL_FALSE);
  enable_blending();
  draw_surfaces(faint);
  glDisable(GL_CULL_FACE);
}

void ScenePicture::draw_surfaces(float opacity) const {
  for (const SceneMesh::Range& range : mesh_.ranges()) {
    surface_program_.set("colour", glm::vec4(colours_[range.surface], opacity));
    mesh_.draw(range);
  }
}

void ScenePicture::draw_traced_camera(const PaintView& view, const Config& config) {
  const double diagonal = diagonal_length(bounds_);
  const double usual = diagonal > 0 ? diagonal / 15 : 1;
  const double depth = config.traced_depth > 0 ? config.traced_depth : usual;
  lines_.upload(camera_lines(*config.traced_camera, config.traced_size, depth, camera_colour),
                mesh_.anchor());
  painter_.paint(lines_, view);
}

void ScenePicture::draw_overlay(const PaintView& view, const Overlay& overlay) {
  lines_.upload(overlay.lines, mesh_.anchor());
  painter_.paint(lines_, view);
  points_.upload(overlay.points, mesh_.anchor());
  painter_.paint(points_, view);
}

} // namespace lightcuts::viz
