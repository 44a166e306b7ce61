// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <string_view>

#include <lightcuts/render/files/file_access.h>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// The extensions of the files that import_model() reads; upper and lower case do not matter.
inline constexpr std::array<std::string_view, 3> model_extensions{".obj", ".gltf", ".glb"};

/// Reads a Wavefront `.obj` with its `.mtl`, or a glTF 2.0 `.gltf`/`.glb`.
///
/// Everything comes out in world space, in the file's units. Kept: triangles (polygons are cut
/// up), normals where present, one surface per material in use, textures of the base colour and of
/// what is emitted with their coordinates, vertex colours, glTF's lights (KHR_lights_punctual) with
/// candela taken as W/sr and lux as W/m^2, glTF's first perspective camera.
/// - OBJ: faces may use vertices that follow. Vertex colours after a position are taken as sRGB.
/// - MTL: diffuse Kd times map_Kd, specular Ks, exponent Ns, emission Ke times map_Ke; of a map's
///   options -clamp, -o and -s. Without Kd it is 1 under a map_Kd and 0.6 else; Ke is 1 under a
///   map_Ke. One value of a colour stands for three. Ka, Ni, Tf and illum do nothing.
/// - glTF: metallic-roughness as Cook-Torrance: diffuse = base (1 - metallic)(1 - d), f0 = mix(d,
///   base, metallic), alpha = roughness^2, at least 2^-14, base being baseColorFactor times
///   baseColorTexture times COLOR_0, d 0.04 or what KHR_materials_ior makes of it. Specular-
///   glossiness: diffuse times 1 - the largest component of specular, f0 = specular, alpha = (1 -
///   glossiness)^2. Emission is emissiveFactor times emissiveStrength times emissiveTexture. A
///   sampler's wrapping counts, not its filters: lookups are bilinear. Morph targets have the
///   file's weights, skins are as their joints stand, instances (EXT_mesh_gpu_instancing) are made.
///
/// Images are files, relative to the model's, or in a glTF's data URIs and buffers; each is loaded
/// once (see decode_texture). Where one cannot be read or a mesh has no coordinates for it, a note
/// says so and the material's factor alone is used.
///
/// Whatever was left out, made up or clamped is said in Scene::notes. Without a camera in the file
/// the model is framed (see `framing`). A model without lights is no error.
///
/// Throws InputError, one line with the file's name, where the file cannot be opened, is not what
/// its name says, is truncated, has no triangles, holds a value outside its domain, or requires a
/// glTF extension that is not supported, and where a library or a buffer is not among the files
/// that `access` allows.
[[nodiscard]] Scene import_model(const std::filesystem::path& file, const FileAccess& access);
[[nodiscard]] inline Scene import_model(const std::filesystem::path& file) {
  return import_model(file, FileAccess(file));
}

/// Adds a model to a scene: triangles, surfaces, lights, notes. Returns whether the file had a
/// camera, which then is the scene's. For scenes of several models; throws as import_model does.
bool append_model(const std::filesystem::path& file, const FileAccess& access, Scene& scene);
inline bool append_model(const std::filesystem::path& file, Scene& scene) {
  return append_model(file, FileAccess(file), scene);
}

} // namespace lightcuts
