// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/render/io/models/gltf/gltf_accessor.h>
#include <lightcuts/render/io/models/gltf/gltf_file.h>

namespace lightcuts {

/// A part of a glTF mesh that has one material, in the mesh's space, morph targets applied.
struct GltfPrimitive {
  std::optional<std::size_t> material;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;                   ///< as in the file; or empty
  std::vector<glm::vec3> colours;                   ///< COLOR_0; or empty
  std::map<std::size_t, std::vector<glm::vec2>> uv; ///< the texture coordinates asked for, by set
  std::vector<glm::uvec3> triangles;
  GltfElements joints, weights; ///< of skins, four numbers a vertex and set; or empty
};

/// Reads a primitive of triangles, strips or fans; nothing where it has points or lines. `weights`
/// are those of morph targets. Throws GltfFault.
[[nodiscard]] std::optional<GltfPrimitive> read_primitive(const GltfFile& file,
                                                          const gltf::Json& primitive,
                                                          std::span<const double> weights,
                                                          std::span<const std::size_t> uv_sets);

} // namespace lightcuts
