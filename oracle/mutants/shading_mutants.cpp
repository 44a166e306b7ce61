// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <type_traits>

#include <lightcuts/render/view/renderer.h>

#include <oracle/mutants/groups.h>

namespace lightcuts::oracle {
namespace {

struct BackLit : LibraryKernel {
  [[nodiscard]] glm::dvec3 estimate(const LightTree& tree, std::uint32_t node,
                                    const ShadingPoint& point,
                                    const glm::vec3& bound) const override {
    const glm::dvec3 front = LibraryKernel::estimate(tree, node, point, bound);
    if (front != glm::dvec3(0)) return front;
    const ShadingPoint back(point.position(), -point.normal(), point.to_viewer(), point.material());
    return LibraryKernel::estimate(tree, node, back, bound);
  }
};

struct ExponentIgnored : LibraryKernel {
  [[nodiscard]] glm::dvec3 estimate(const LightTree& tree, std::uint32_t node,
                                    const ShadingPoint& point,
                                    const glm::vec3& bound) const override {
    Material material = point.material();
    if (auto* phong = std::get_if<Phong>(&material.lobe)) phong->exponent = 1;
    return LibraryKernel::estimate(
        tree, node, {point.position(), point.normal(), point.to_viewer(), material}, bound);
  }
};

/// The library but for its shadow rays.
template <bool blocked(const SceneView& view, const VisiblePoint& from, std::uint32_t light)>
class OtherOcclusion : public KernelSubject {
public:
  using KernelSubject::KernelSubject;
  [[nodiscard]] bool sees(const SceneView& view, const VisiblePoint& from,
                          std::uint32_t light) const override {
    return !blocked(view, from, light);
  }
};

template <bool blocked(const SceneView& view, const VisiblePoint& from, std::uint32_t light)>
std::unique_ptr<Subject> with_occlusion(const char* name) {
  return std::make_unique<OtherOcclusion<blocked>>(name);
}

bool by_all_beyond(const SceneView& view, const VisiblePoint& from, std::uint32_t light) {
  ShadowRay ray = view.ray_to(from, light);
  ray.far *= 4;
  return view.occluder().occluded(ray);
}

bool by_itself(const SceneView& view, const VisiblePoint& from, std::uint32_t light) {
  return view.occluder().occluded(
      shadow_ray(from.point.position(), view.scene().lights[light].position));
}

bool by_last_mesh(const SceneView& view, const VisiblePoint& from, std::uint32_t light) {
  TriangleMesh last = view.scene().mesh;
  const auto [triangles, surfaces] = std::pair(last.triangles, last.surface);
  last.triangles.clear();
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (surfaces[i] == surfaces.back()) last.triangles.push_back(triangles[i]);
  return Occluder(last).occluded(view.ray_to(from, light));
}

/// The library but for its pictures.
template <void spoil(Rendering& picture, const SceneView& view)>
class OtherPictures : public KernelSubject {
public:
  using KernelSubject::KernelSubject;
  [[nodiscard]] Rendering render(const SceneView& view, const LightTree& tree,
                                 const RenderConfig& config) const override {
    Rendering picture = KernelSubject::render(view, tree, config);
    spoil(picture, view);
    return picture;
  }
};

template <void spoil(Rendering& picture, const SceneView& view)>
std::unique_ptr<Subject> with_pictures(const char* name) {
  return std::make_unique<OtherPictures<spoil>>(name);
}

void leave_last_row_out(Rendering& picture, const SceneView& /*view*/) {
  for (unsigned y = 0; y < picture.size.y; ++y)
    for (unsigned x = 0; x < picture.size.x; ++x)
      if (x + 1 == picture.size.x || y + 1 == picture.size.y)
        picture.radiance[std::size_t(y) * picture.size.x + x] = glm::vec3(0);
}

void normalise_in_floats(Rendering& picture, const SceneView& view) {
  const TriangleMesh& mesh = view.scene().mesh;
  const PinholeView camera(view.scene().camera, picture.size);
  for (unsigned y = 0; y < picture.size.y; ++y)
    for (unsigned x = 0; x < picture.size.x; ++x) {
      const auto hit = view.occluder().intersect(camera.origin(), camera.direction({x, y}));
      if (!hit) continue;
      const glm::uvec3 t = mesh.triangles[hit->triangle];
      const auto& p = mesh.positions;
      const glm::vec3 normal = glm::cross(p[t.y] - p[t.x], p[t.z] - p[t.x]);
      // No area as far as floats can tell: 0/0.
      picture.radiance[std::size_t(y) * picture.size.x + x] *=
          glm::dot(normal, normal) / glm::dot(normal, normal);
    }
}

constexpr Mutant shading_catalogue[] = {
    {"back-lit", "lights surfaces from behind", with_kernel<BackLit>},
    {"exponent-ignored", "does not raise Phong's cosine to its power",
     with_kernel<ExponentIgnored>},
    {"blocker-behind-light", "lets what lies behind a light occlude it",
     with_occlusion<by_all_beyond>},
    {"self-shadow", "starts shadow rays on the surface itself", with_occlusion<by_itself>},
    {"last-mesh-only", "looks for blockers in the last mesh only", with_occlusion<by_last_mesh>},
    {"last-row", "does not render the last row and column", with_pictures<leave_last_row_out>},
    {"degenerate-normal", "divides the normal of a face without area by its length",
     with_pictures<normalise_in_floats>},
};

} // namespace

std::span<const Mutant> shading_mutants() { return shading_catalogue; }

} // namespace lightcuts::oracle
