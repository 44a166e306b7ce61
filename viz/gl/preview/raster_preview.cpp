// SPDX-License-Identifier: MIT
#include <viz/gl/preview/raster_preview.h>

#include <algorithm>
#include <array>

#include <lightcuts/core/jobs/seconds_since.h>
#include <viz/gl/preview/preview_shaders.h>
#include <viz/gl/scene/random_order.h>

namespace lightcuts::viz {
namespace {

std::vector<PreviewMaterial> preview_materials(const Scene& scene) {
  std::vector<PreviewMaterial> materials;
  for (const Surface& surface : scene.surfaces)
    materials.push_back(preview_material(surface.material));
  return materials;
}

/// What is nearer than this share of the farthest surface's distance is not shown.
constexpr double nearest_share = 1e-6;

constexpr std::array sampler_names{"offsets", "normals", "diffuses", "f0s"};

} // namespace

RasterPreview::RasterPreview(const Scene& scene)
    : scene_(&scene), mesh_(scene), textures_(scene.textures), materials_(preview_materials(scene)),
      order_(random_order(scene.lights.size())),
      surface_program_(surface_vertex_shader, surface_fragment_shader),
      lights_program_(full_screen_vertex_shader, lights_fragment_shader),
      surfaces_(std::vector(5, TexelFormat::rgba32f), true), sum_({TexelFormat::rgba32f}, false) {
  no_texture_.upload({1, 1}, std::span<const glm::vec3>(std::array{glm::vec3(1)}));
  lights_program_.bind_block("Lights", 0);
  const float clamp = scene.lights.min_distance();
  lights_program_.set("min_distance2", clamp * clamp);
  for (int unit = 0; unit < int(sampler_names.size()); ++unit)
    lights_program_.set(sampler_names[std::size_t(unit)], unit);
}

void RasterPreview::start(const Camera& camera, glm::uvec2 size) {
  size_ = glm::uvec2(0);
  const ViewFrame frame = view_frame(camera, size);
  surfaces_.resize(size);
  sum_.resize(size);
  draw_surfaces(frame);
  const DrawScope scope;
  sum_.bind();
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  size_ = size;
  camera_ = frame.origin;
  done_ = last_batch_ = 0;
}

void RasterPreview::draw_surfaces(const ViewFrame& frame) const {
  const DrawScope scope;
  surfaces_.bind();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glClearColor(0, 0, 0, 0);
  glClearDepth(1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const double far = reach(frame.origin, mesh_.bounds());
  surface_program_.set("clip_from_offset", clip_from_offset(frame, nearest_share * far));
  surface_program_.set("camera", glm::vec3(frame.origin - mesh_.anchor()));
  surface_program_.set("reach", float(far));
  for (const SceneMesh::Range& range : mesh_.ranges()) {
    use_surface(range.surface);
    mesh_.draw(range);
  }
}

void RasterPreview::use_surface(std::uint32_t index) const {
  const PreviewMaterial& material = materials_[index];
  const Surface& surface = scene_->surfaces[index];
  surface_program_.set("diffuse_alpha", glm::vec4(material.diffuse, material.alpha));
  surface_program_.set("f0", material.f0);
  surface_program_.set("emission", surface.emission);
  surface_program_.set("textured", surface.texture ? 1.0F : 0.0F);
  surface_program_.set("tinted_f0", surface.tinted_f0);
  if (surface.texture)
    textures_.bind(*surface.texture, 0);
  else
    no_texture_.bind(0);
}

bool RasterPreview::advance(double milliseconds) {
  if (size_.x == 0) return true;
  const auto begin = Clock::now();
  for (double left = milliseconds; done_ < order_.size();) {
    const auto before = Clock::now();
    const std::size_t count = batch_size(left);
    add_batch(count);
    glFinish();
    last_batch_ = count;
    milliseconds_per_light_ = 1000 * seconds_since(before) / double(count);
    left = milliseconds - 1000 * seconds_since(begin);
    if (left <= 0) break;
  }
  return done_ == order_.size();
}

/// As many as fit into the time at the last batch's pace, but not many times more than then, as a
/// small batch tells little.
std::size_t RasterPreview::batch_size(double milliseconds) const {
  const std::size_t most = std::min(max_light_batch, order_.size() - done_);
  if (last_batch_ == 0) return std::min<std::size_t>(most, 4);
  const double fitting = milliseconds / std::max(milliseconds_per_light_, 1e-6);
  const double wanted = std::min({fitting, 4.0 * double(last_batch_), double(most)});
  return std::max<std::size_t>(1, std::size_t(std::max(wanted, 0.0)));
}

void RasterPreview::add_batch(std::size_t count) {
  std::vector<GpuLight> batch(max_light_batch); // the block's size, whatever is used of it
  for (std::size_t i = 0; i < count; ++i)
    batch[i] = gpu_light(scene_->lights[order_[done_ + i]], camera_);
  batch_buffer_.upload(GL_UNIFORM_BUFFER, std::span<const GpuLight>(batch), GL_STREAM_DRAW);
  const DrawScope scope;
  sum_.bind();
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, batch_buffer_.id());
  for (std::size_t unit = 0; unit < sampler_names.size(); ++unit)
    surfaces_.colour(unit).bind(GLuint(unit));
  lights_program_.set("light_count", int(count));
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE);
  no_attributes_.bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  done_ += count;
}

float RasterPreview::share() const {
  return order_.empty() ? 1.0F : float(double(done_) / double(order_.size()));
}

std::vector<glm::vec3> RasterPreview::radiance() const {
  if (size_.x == 0) return {};
  const std::vector<glm::vec4> emission = surfaces_.read_rgba32f(4), sum = sum_.read_rgba32f(0);
  const float scale = done_ == 0 ? 0.0F : float(double(order_.size()) / double(done_));
  std::vector<glm::vec3> result(sum.size());
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = glm::vec3(emission[i]) + scale * glm::vec3(sum[i]);
  return result;
}

} // namespace lightcuts::viz
