// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// Opens a scene of any kind: a built-in one, with parameters (builtin_scenes.h), a `.json` scene
/// (scene_json.h) or a model (model_import.h), see scene_files.h. A file whose name begins like a
/// built-in's takes a "./". The scene is validated, its name is the file's stem or the built-in's
/// spec. Throws InputError; its message and the scene's notes are one line each, whatever files are
/// called.
/// allow_outside: whether files outside the scene's folder are read (see FileAccess); default:
/// false.
[[nodiscard]] Scene open_scene(const std::string& spec, bool allow_outside = false);

/// Throws InputError, naming the element, unless there are triangles, every index is in range,
/// positions, normals, texture coordinates, colours and emissions are finite, normals are unit or
/// zero, materials are valid, surfaces with a texture have texture coordinates, the camera has a
/// direction and a field of view, and the image size is in [1, max_image_side]. Lights and
/// textures are valid by construction; there may be none.
void validate(const Scene& scene);

} // namespace lightcuts
