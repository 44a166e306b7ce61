// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/render/io/models/gltf/gltf_file.h>
#include <lightcuts/render/io/models/gltf/gltf_materials.h>
#include <lightcuts/render/io/models/gltf/gltf_nodes.h>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// Adds the triangles of all nodes with a mesh, where morph targets, skins and
/// EXT_mesh_gpu_instancing put them at rest. Throws GltfFault, and InputError where there are none
/// or a vertex is not finite.
void append_meshes(const GltfFile& file, const GltfNodes& nodes, GltfMaterials& materials,
                   Scene& scene);

} // namespace lightcuts
