// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// A corner of triangles, in world space.
struct MeshVertex {
  glm::vec3 position{0};
  glm::vec3 normal{0};                       ///< unit; 0: the face's
  std::optional<glm::vec2> uv = {};          ///< nothing: (0, 0)
  std::optional<glm::vec2> emission_uv = {}; ///< nothing: (0, 0)
  std::optional<glm::vec3> colour = {};      ///< nothing: white
};

/// Adds one model's triangles to a scene, whose lists it keeps of equal length.
class MeshBuilder {
public:
  /// `file` begins messages. The scene must outlive it.
  MeshBuilder(std::string file, Scene& scene);

  /// Index of the new position. Throws InputError where the mesh has as many as it can count.
  std::uint32_t add(const MeshVertex& vertex);

  /// Leaves out, and counts, a triangle without area.
  void add_triangle(const glm::uvec3& corners, std::uint32_t surface);

  /// Notes what was left out. Throws InputError where no triangle was added.
  void finish();

private:
  static constexpr std::size_t most = 1'000'000'000;

  std::string file_;
  Scene& scene_;
  std::size_t first_triangle_, without_area_ = 0;
};

/// v / |v| rounded to floats, 0 where that is no direction.
[[nodiscard]] glm::vec3 unit_or_zero(const glm::dvec3& v);

} // namespace lightcuts
