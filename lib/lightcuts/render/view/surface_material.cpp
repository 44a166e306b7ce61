// SPDX-License-Identifier: MIT
#include <lightcuts/render/view/surface_material.h>

#include <limits>
#include <variant>
#include <vector>

#include <glm/common.hpp>

namespace lightcuts {
namespace {

glm::vec3 finite(const glm::vec3& v) {
  return glm::min(v, glm::vec3(std::numeric_limits<float>::max()));
}

/// A value per position, between the triangle's corners.
template <class Exact, class Value>
Exact interpolated(const std::vector<Value>& values, const glm::uvec3& t, const Hit& hit) {
  const double b = hit.barycentric.x, c = hit.barycentric.y;
  return Exact(values[t.x]) * (1 - b - c) + Exact(values[t.y]) * b + Exact(values[t.z]) * c;
}

} // namespace

Material textured(const Surface& surface, const glm::vec3& texel) {
  Material material = surface.material;
  material.diffuse = finite(material.diffuse * texel);
  if (auto* metal = std::get_if<CookTorrance>(&material.lobe)) {
    const glm::vec3& tinted = surface.tinted_f0;
    metal->f0 = glm::clamp(metal->f0 - tinted + tinted * texel, 0.0F, 1.0F);
  }
  return material;
}

Material material_at(const Scene& scene, const Hit& hit) {
  const Surface& surface = scene.surfaces[scene.mesh.surface[hit.triangle]];
  if (!surface.texture && scene.mesh.colours.empty()) return surface.material;
  const glm::uvec3 t = scene.mesh.triangles[hit.triangle];
  glm::vec3 texel(1);
  if (surface.texture)
    texel = scene.textures[surface.texture->index].at(
        interpolated<glm::dvec2>(scene.mesh.uv, t, hit), surface.texture->wrap);
  if (!scene.mesh.colours.empty())
    texel = finite(texel * glm::max(glm::vec3(interpolated<glm::dvec3>(scene.mesh.colours, t, hit)),
                                    glm::vec3(0)));
  return textured(surface, texel);
}

glm::vec3 emission_at(const Scene& scene, const Hit& hit) {
  const Surface& surface = scene.surfaces[scene.mesh.surface[hit.triangle]];
  if (!surface.emission_texture) return surface.emission;
  const glm::dvec2 uv =
      interpolated<glm::dvec2>(scene.mesh.emission_uv, scene.mesh.triangles[hit.triangle], hit);
  const auto& [index, wrap] = *surface.emission_texture;
  return finite(surface.emission * scene.textures[index].at(uv, wrap));
}

} // namespace lightcuts
