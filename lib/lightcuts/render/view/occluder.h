// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// Share of a shadow ray left untested at the light's end, so that a surface on which the light
/// lies does not shadow it.
inline constexpr float shadow_ray_gap = 0x1p-14F;

/// The segment origin + t direction, 0 <= t <= far.
struct ShadowRay {
  glm::vec3 origin;    ///< metres
  glm::vec3 direction; ///< metres, any length; zero: a segment that nothing blocks
  float far;           ///< in lengths of direction
};

/// The shadow ray from origin towards light (metres, finite): direction = light - origin rounded
/// to float, far = 1 - shadow_ray_gap. Where that difference exceeds the largest float, direction
/// is halved and far doubled.
[[nodiscard]] ShadowRay shadow_ray(const glm::vec3& origin, const glm::vec3& light);

/// Where a ray meets a triangle.
struct Hit {
  std::uint32_t triangle; ///< index into TriangleMesh::triangles
  glm::vec2 barycentric;  ///< weights of the triangle's second and third vertex
  float distance;         ///< from the ray's origin, in lengths of its direction
};

/// Whether a triangle of the mesh has no area, so that it blocks nothing.
[[nodiscard]] bool blocks_nothing(const TriangleMesh& mesh, const glm::uvec3& triangle);

/// Answers what a ray meets first and whether a segment is blocked, by Embree 3 in its robust mode
/// (single precision; `brute_force_occlusion` of the oracle states how precise). Triangles are
/// two-sided; those without area block nothing. Embree sees the mesh scaled by a power of two to
/// unit size, so that scaling scene and rays by powers of two changes no answer. A ray that
/// starts 2^60 times the mesh's largest coordinate away meets nothing. All const functions may be
/// called from many threads.
class Occluder {
public:
  /// Copies what it needs of the mesh. Throws InputError where a position is not finite, an index
  /// is out of range, or Embree fails (out of memory, say).
  explicit Occluder(const TriangleMesh& mesh);
  ~Occluder();
  Occluder(Occluder&&) noexcept;
  Occluder& operator=(Occluder&&) noexcept;

  /// The nearest triangle along origin + t direction, t >= 0; nothing for a zero direction.
  /// origin and direction finite.
  [[nodiscard]] std::optional<Hit> intersect(const glm::vec3& origin,
                                             const glm::vec3& direction) const;

  /// Whether any triangle meets the segment. origin and direction finite.
  [[nodiscard]] bool occluded(const ShadowRay& ray) const;

private:
  struct Embree;
  std::unique_ptr<Embree> embree_;
};

} // namespace lightcuts
