// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/lights/light.h>
#include <lightcuts/render/io/models/gltf/gltf_file.h>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// A light of KHR_lights_punctual, or an instance of a light profile of EXT_lights_ies.
struct GltfLight {
  std::string name;
  LightKind kind = LightKind::omni;
  glm::vec3 position{0};  ///< metres
  glm::vec3 direction{0}; ///< unit, in which a spot, profile or directional light shines
  glm::vec3 intensity{0}; ///< candela taken as W/sr; of a directional light lux taken as W/m^2;
                          ///< of a profile: what multiplies the candela of its file
  float inner_angle = 0;  ///< of a spot, radians
  float outer_angle = 0;
  glm::vec3 plane{0};      ///< of a profile: unit, horizontal angle 0
  std::size_t profile = 0; ///< of a profile: its index in the file's list
};

/// A node with a mesh.
struct GltfMeshNode {
  std::size_t node = 0, mesh = 0;
  std::optional<std::size_t> skin;
};

/// The nodes of a glTF file's scene, in world space.
struct GltfNodes {
  std::vector<glm::dmat4> world; ///< of every node, also of those outside the scene
  std::vector<GltfMeshNode> meshes;
  std::vector<GltfLight> lights;
  std::optional<Camera> camera; ///< the first perspective camera in the order of the nodes
};

/// Walks the file's scene (its first where it names none). Hidden nodes (KHR_node_visibility) have
/// no meshes and lights. Notes what is left out or changed. Throws GltfFault where the nodes do not
/// form a forest.
[[nodiscard]] GltfNodes read_nodes(const GltfFile& file, std::vector<std::string>& notes);

/// The transform that translation, rotation (x, y, z, w; any length but 0) and scale make.
[[nodiscard]] glm::dmat4 transform_of(const glm::dvec3& translation, const glm::dvec4& rotation,
                                      const glm::dvec3& scale);

} // namespace lightcuts
