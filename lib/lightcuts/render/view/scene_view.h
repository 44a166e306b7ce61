// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/lobes/shading_point.h>
#include <lightcuts/render/scene/scene.h>
#include <lightcuts/render/shafts/triangle_tree.h>
#include <lightcuts/render/view/camera.h>
#include <lightcuts/render/view/occluder.h>

namespace lightcuts {

/// What a pixel shows.
struct VisiblePoint {
  ShadingPoint point;
  glm::vec3 ray_origin; ///< where shadow rays start: off the surface, on the viewer's side
  glm::vec3 emission;   ///< radiance of the surface itself
};

/// A scene as its camera sees it, one point per pixel, and what light reaches there. All const
/// functions may be called from many threads.
class SceneView {
public:
  /// The scene must be valid (see validate()) and outlive the view.
  explicit SceneView(const Scene& scene);
  /// The scene as another camera sees it, without building what finds triangles again.
  [[nodiscard]] SceneView seen_by(const Camera& camera, glm::uvec2 size) const {
    return {*scene_, occluder_, triangles_, camera, size};
  }

  /// The same mesh in another scene, which has other lights, as the same camera sees it.
  [[nodiscard]] SceneView relit(const Scene& scene) const {
    return {scene, occluder_, triangles_, scene.camera, size_};
  }

  [[nodiscard]] const Scene& scene() const { return *scene_; }
  [[nodiscard]] const Occluder& occluder() const { return *occluder_; }
  /// What shafts are tested against; empty where nothing occludes, or of a mesh with too many
  /// triangles for each block of pixels to look at.
  [[nodiscard]] const TriangleTree& triangles() const { return *triangles_; }
  [[nodiscard]] glm::uvec2 size() const { return size_; }

  /// Whether anything can come between a visible surface and a light; without it, nothing is cast.
  [[nodiscard]] bool may_occlude() const { return may_occlude_; }

  /// The surface seen at the centre of the pixel, if any.
  [[nodiscard]] std::optional<VisiblePoint> at(glm::uvec2 pixel) const;

  /// Radiance from beyond all surfaces through the centre of the pixel, W/(m^2 sr).
  [[nodiscard]] glm::vec3 beyond(glm::uvec2 pixel) const;

  /// Whether light i is seen from the point.
  [[nodiscard]] bool sees(const VisiblePoint& from, std::uint32_t light) const {
    return !may_occlude_ || casts_to(from, light);
  }
  /// Whether a shadow ray from the point reaches light i; cast whether it is needed or not.
  [[nodiscard]] bool casts_to(const VisiblePoint& from, std::uint32_t light) const {
    return !occluder_->occluded(ray_to(from, light));
  }

  /// The shadow ray from the point to light i; to a directional light, out of the scene.
  [[nodiscard]] ShadowRay ray_to(const VisiblePoint& from, std::uint32_t light) const {
    const Light& l = scene_->lights[light];
    if (is_at_infinity(l.kind)) return {from.ray_origin, l.position, out_of_scene_};
    return shadow_ray(from.ray_origin, l.position);
  }

private:
  SceneView(const Scene& scene, std::shared_ptr<const Occluder> occluder,
            std::shared_ptr<const TriangleTree> triangles, const Camera& camera, glm::uvec2 size);

  const Scene* scene_;
  std::shared_ptr<const Occluder> occluder_;
  std::shared_ptr<const TriangleTree> triangles_;
  glm::uvec2 size_;
  PinholeView camera_;
  bool may_occlude_;
  float out_of_scene_; ///< longer than any way between two of its points
};

} // namespace lightcuts
