// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include <lightcuts/render/files/file_access.h>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// Adds the `.obj` to the scene, as model_import.h says. Throws InputError, of what is wrong in a
/// line as `file:line: message`.
void append_obj(const std::filesystem::path& file, const FileAccess& access, Scene& scene);

} // namespace lightcuts
