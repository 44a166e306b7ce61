// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <assimp/material.h>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// Translates a material as model_import.h says. `where` (file and material) begins its errors;
/// a clamped exponent is added to `notes`. Throws InputError for what is out of its domain.
Surface surface_of(const aiMaterial& material, bool is_gltf, const std::string& where,
                   std::vector<std::string>& notes);

/// What of the surface's specular reflectance a base-colour texture multiplies.
glm::vec3 tinted_f0(const aiMaterial& material, bool is_gltf);

} // namespace lightcuts
