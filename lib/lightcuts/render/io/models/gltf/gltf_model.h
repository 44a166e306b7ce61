// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include <lightcuts/render/files/file_access.h>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// Adds the `.gltf` or `.glb` to the scene, as model_import.h says. Returns whether it has a
/// camera, which then is the scene's. Throws InputError with the file's name.
bool append_gltf(const std::filesystem::path& file, const FileAccess& access, Scene& scene);

} // namespace lightcuts
