// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <string_view>

#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// The extensions of the files that import_model() reads; upper and lower case do not matter.
inline constexpr std::array<std::string_view, 3> model_extensions{".obj", ".gltf", ".glb"};

/// Reads a Wavefront `.obj` with its `.mtl`, or a glTF 2.0 `.gltf`/`.glb`.
///
/// Everything comes out in world space, in the file's units. Kept: triangles (polygons are cut
/// up), normals where present, one surface per material in use, base-colour textures with their
/// coordinates, glTF's lights (KHR_lights_punctual) with candela taken as W/sr and lux as W/m^2,
/// glTF's first perspective camera.
/// - MTL: diffuse Kd times map_Kd, specular Ks, exponent Ns, emission Ke. Ka, illum, opacity and
///   other maps do nothing, nor do the options of map_Kd except -clamp.
/// - glTF: metallic-roughness as Cook-Torrance: diffuse = base (1 - metallic)(1 - 0.04), f0 =
///   mix(0.04, base, metallic), alpha = roughness^2, at least 2^-14, base being
///   baseColorFactor times baseColorTexture. A sampler's wrapping counts, not its filters: lookups
///   are bilinear. KHR_texture_transform counts unless it rotates.
///
/// Images are files, relative to the model's, or in a glTF's data URIs and buffers; each is loaded
/// once (see decode_texture). Where one cannot be read or a mesh has no coordinates for it, a note
/// says so and the material's factor alone is used.
///
/// Whatever was left out, made up or clamped is said in Scene::notes. Without a camera in the file
/// the model is framed (see `framing`). A model without lights is no error.
///
/// Throws InputError, one line with the file's name, where the file cannot be opened, is not what
/// its name says, is truncated, has no triangles, or holds a value outside its domain.
[[nodiscard]] Scene import_model(const std::filesystem::path& file);

/// Adds a model to a scene: triangles, surfaces, lights, notes. Returns whether the file had a
/// camera, which then is the scene's. For scenes of several models; throws as import_model does.
bool append_model(const std::filesystem::path& file, Scene& scene);

} // namespace lightcuts
