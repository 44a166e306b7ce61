// SPDX-License-Identifier: MIT
#include <lightcuts/render/view/surface_material.h>

#include <limits>
#include <variant>

#include <glm/common.hpp>

namespace lightcuts {
namespace {

glm::vec3 finite(const glm::vec3& v) {
  return glm::min(v, glm::vec3(std::numeric_limits<float>::max()));
}

glm::dvec2 interpolated_uv(const TriangleMesh& mesh, const Hit& hit) {
  const glm::uvec3 t = mesh.triangles[hit.triangle];
  const double b = hit.barycentric.x, c = hit.barycentric.y;
  return glm::dvec2(mesh.uv[t.x]) * (1 - b - c) + glm::dvec2(mesh.uv[t.y]) * b +
         glm::dvec2(mesh.uv[t.z]) * c;
}

} // namespace

Material textured(const Surface& surface, const glm::vec3& texel) {
  Material material = surface.material;
  material.diffuse = finite(material.diffuse * texel);
  if (auto* metal = std::get_if<CookTorrance>(&material.lobe)) {
    const glm::vec3& tinted = surface.texture->tinted_f0;
    metal->f0 = glm::clamp(metal->f0 - tinted + tinted * texel, 0.0F, 1.0F);
  }
  return material;
}

Material material_at(const Scene& scene, const Hit& hit) {
  const Surface& surface = scene.surfaces[scene.mesh.surface[hit.triangle]];
  if (!surface.texture) return surface.material;
  const Texture& texture = scene.textures[surface.texture->index];
  return textured(surface, texture.at(interpolated_uv(scene.mesh, hit), surface.texture->wrap));
}

} // namespace lightcuts
