// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <lightcuts/render/io/models/gltf/gltf_file.h>

namespace lightcuts {

/// Notes each extension in the file that changes light or shape and is left out, by its name.
/// Throws InputError where `extensionsRequired` has one that is not supported.
void check_extensions(const GltfFile& file, std::vector<std::string>& notes);

} // namespace lightcuts
