// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>
#include <lightcuts/core/lights/light.h>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// A light of KHR_lights_punctual.
struct GltfLight {
  LightKind kind = LightKind::omni;
  glm::vec3 position{0};  ///< metres
  glm::vec3 direction{0}; ///< unit, in which a spot or directional light shines
  glm::vec3 intensity{0}; ///< candela taken as W/sr; of a directional light lux taken as W/m^2
  float inner_angle = 0;  ///< of a spot, radians
  float outer_angle = 0;
};

/// The lights and the camera of a glTF file, in world space. Read from the JSON, since Assimp 5.2
/// keeps one node per light, finds nodes by names that need not be unique, and multiplies the
/// field of view by the aspect ratio.
struct GltfNodes {
  std::vector<GltfLight> lights;
  std::size_t orthographic = 0;
  std::optional<Camera> camera; ///< the first perspective camera in the order of the nodes
};

/// Reads a `.gltf` or `.glb`. Throws InputError with the file's name where it is not glTF 2.0 or
/// the nodes do not form a forest.
GltfNodes read_gltf_nodes(const std::filesystem::path& file);

} // namespace lightcuts
