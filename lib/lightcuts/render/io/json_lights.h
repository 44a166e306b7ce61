// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include <lightcuts/render/files/file_access.h>
#include <lightcuts/render/scene/scene.h>

#include <lightcuts/render/io/json/json_element.h>

namespace lightcuts {

/// Adds what the element "lights" of a scene file describes (see load_scene_json), one after the
/// other: what is generated from lights uses those before it. `folder`: what file names in it are
/// relative to; `access`: whether they may be read. The mesh and the surfaces must be there. Throws
/// InputError that names the element.
void add_lights(const JsonElement& lights, const std::filesystem::path& folder,
                const FileAccess& access, Scene& scene);

} // namespace lightcuts
