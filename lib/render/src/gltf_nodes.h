// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include <lightcuts/light_set.h>
#include <lightcuts/render/scene.h>

namespace lightcuts {

/// The lights and the camera of a glTF file, in world space. Read from the JSON, since Assimp 5.2
/// keeps one node per light, finds nodes by names that need not be unique, and multiplies the
/// field of view by the aspect ratio.
struct GltfNodes {
  std::vector<Light> omni; ///< candela taken as W/sr
  std::size_t directional = 0, spot = 0, orthographic = 0;
  std::optional<Camera> camera; ///< the first perspective camera in the order of the nodes
};

/// Reads a `.gltf` or `.glb`. Throws InputError with the file's name where it is not glTF 2.0 or
/// the nodes do not form a forest.
GltfNodes read_gltf_nodes(const std::filesystem::path& file);

} // namespace lightcuts
