// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/models/gltf/gltf_model.h>

#include <cmath>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>

#include <lightcuts/render/files/text.h>
#include <lightcuts/render/io/json/json_text.h>
#include <lightcuts/render/io/models/gltf/gltf_extensions.h>
#include <lightcuts/render/io/models/gltf/gltf_file.h>
#include <lightcuts/render/io/models/gltf/gltf_materials.h>
#include <lightcuts/render/io/models/gltf/gltf_meshes.h>
#include <lightcuts/render/io/models/gltf/gltf_nodes.h>
#include <lightcuts/render/io/models/gltf/gltf_profiles.h>
#include <lightcuts/render/lighting/profiles/profile_light.h>

namespace lightcuts {
namespace {

void add(const GltfLight& light, GltfProfiles& profiles, LightSet& lights) {
  switch (light.kind) {
  case LightKind::profile: {
    const IesLuminaire& luminaire = profiles.luminaire(light.profile);
    const auto plane = plane_beside(light.direction, light.plane);
    return lights.add_profile(light.position, light.direction,
                              plane ? *plane : usual_plane(light.direction),
                              scaled_intensity(light.intensity, luminaire.peak), luminaire.profile);
  }
  case LightKind::spot:
    return lights.add_spot(light.position, light.direction, light.intensity, light.inner_angle,
                           light.outer_angle);
  case LightKind::directional:
    return lights.add_directional(light.direction, light.intensity);
  default:
    return lights.add_omni(light.position, light.intensity);
  }
}

bool append(const GltfFile& file, const FileAccess& access, Scene& scene) {
  check_extensions(file, scene.notes);
  const GltfNodes nodes = read_nodes(file, scene.notes);
  GltfMaterials materials(file, access, scene);
  append_meshes(file, nodes, materials, scene);
  materials.finish();
  GltfProfiles profiles(file, access, scene.notes);
  for (const GltfLight& light : nodes.lights) {
    try {
      add(light, profiles, scene.lights);
    } catch (const LuminaireError&) { // which names its own file
      throw;
    } catch (const InputError& error) {
      throw InputError(error.fault(), fmt::format("{}: {}", file.path().string(), error.what()));
    }
  }
  if (nodes.camera) scene.camera = *nodes.camera;
  return nodes.camera.has_value();
}

} // namespace

bool append_gltf(const std::filesystem::path& file, const FileAccess& access, Scene& scene) {
  const auto refuse = [&](const std::string& why) {
    throw InputError(InputFault::malformed_file,
                     one_line(fmt::format("{}: not glTF 2.0: {}", file.string(), why)));
  };
  try {
    return append(GltfFile(file, access), access, scene);
  } catch (const GltfFault& fault) {
    refuse(fault.what());
  } catch (const gltf::Json::exception& error) {
    refuse(plain_message(error));
  }
  return false;
}

} // namespace lightcuts
