// SPDX-License-Identifier: MIT
#include <lightcuts/render/view/scene_view.h>

#include <utility>

#include <lightcuts/core/numerics/rounding.h>
#include <lightcuts/render/lighting/environment/backdrop.h>
#include <lightcuts/render/scene/bounds.h>
#include <lightcuts/render/scene/convexity.h>
#include <lightcuts/render/view/surface_material.h>
#include <lightcuts/render/view/surface_point.h>

namespace lightcuts {

namespace {

constexpr std::size_t most_triangles = 1 << 17; // a block's start looks at each

}

SceneView::SceneView(const Scene& scene)
    : SceneView(scene, std::make_shared<const Occluder>(scene.mesh), nullptr, scene.camera,
                scene.image_size) {
  const bool has_shafts = may_occlude_ && scene.mesh.triangles.size() <= most_triangles;
  triangles_ = std::make_shared<const TriangleTree>(has_shafts ? scene.mesh : TriangleMesh());
}

SceneView::SceneView(const Scene& scene, std::shared_ptr<const Occluder> occluder,
                     std::shared_ptr<const TriangleTree> triangles, const Camera& camera,
                     glm::uvec2 size)
    : scene_(&scene), occluder_(std::move(occluder)), triangles_(std::move(triangles)), size_(size),
      camera_(camera, size),
      may_occlude_(!encloses_lights_convexly(scene.mesh, scene.lights, camera.position)),
      out_of_scene_(round_down(2 * diagonal_length(scene_bounds(scene.mesh)))) {}

std::optional<VisiblePoint> SceneView::at(glm::uvec2 pixel) const {
  const glm::vec3 direction = camera_.direction(pixel);
  const auto hit = occluder_->intersect(camera_.origin(), direction);
  if (!hit) return std::nullopt;
  const SurfacePoint s = surface_point(scene_->mesh, *hit, direction);
  return VisiblePoint{
      ShadingPoint(s.position, s.shading_normal, -direction, material_at(*scene_, *hit)),
      s.ray_origin, emission_at(*scene_, *hit)};
}

glm::vec3 SceneView::beyond(glm::uvec2 pixel) const {
  glm::dvec3 sum(0);
  for (const auto& backdrop : scene_->backdrops)
    sum += glm::dvec3(backdrop->radiance(camera_.direction(pixel)));
  return {to_float(sum.x), to_float(sum.y), to_float(sum.z)};
}

} // namespace lightcuts
