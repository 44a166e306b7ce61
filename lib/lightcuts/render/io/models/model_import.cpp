// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/models/model_import.h>

#include <algorithm>
#include <string>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>

#include <lightcuts/render/files/text.h>
#include <lightcuts/render/io/models/gltf/gltf_model.h>
#include <lightcuts/render/io/models/obj/obj_file.h>
#include <lightcuts/render/scene/framing.h>

namespace lightcuts {

bool append_model(const std::filesystem::path& file, const FileAccess& access, Scene& scene) {
  const std::string extension = lower_extension(file);
  if (extension == ".obj") {
    append_obj(file, access, scene);
    return false;
  }
  if (std::ranges::find(model_extensions, extension) == model_extensions.end())
    throw InputError(InputFault::unsupported,
                     fmt::format("{}: unknown kind of model '{}'; known: {}", file.string(),
                                 extension, fmt::join(model_extensions, ", ")));
  return append_gltf(file, access, scene);
}

Scene import_model(const std::filesystem::path& file, const FileAccess& access) {
  Scene scene;
  scene.name = file.stem().string();
  if (!append_model(file, access, scene)) {
    scene.camera = framing(scene.mesh);
    scene.notes.push_back(fmt::format("{}: no camera in the file: framed", file.string()));
  }
  return scene;
}

} // namespace lightcuts
