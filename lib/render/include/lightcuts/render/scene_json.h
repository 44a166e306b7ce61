// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include <lightcuts/render/scene.h>

namespace lightcuts {

/// Reads a scene described in JSON:
///
///     {"geometry": "room.obj",                  or a list of .obj, .gltf, .glb files
///      "camera": {"position": [0, 1, 3], "target": [0, 1, 0], "up": [0, 1, 0], "fov": 45},
///      "image": {"width": 640, "height": 480},
///      "lights": [{"position": [0, 2, 0], "intensity": [1, 1, 1]}]}
///
/// Files are relative to the JSON file. Only `geometry` is required, and `up` and `fov` (vertical,
/// degrees) within a camera are optional. `lights`, where given, replace those of the models; they
/// are a list, or an object that generates a cloud (light_generator.h):
///
///     {"count": 1000, "seed": 1, "box": [[0, 1, 0], [4, 2, 4]], "intensity": 20}
///
/// of which only `count` is required; `intensity` is that of all lights together, default and
/// default box as in default_cloud. Any intensity, W/sr, is a number or [r, g, b].
///
/// Throws InputError that names file and element, as `scene.json: /lights/3/intensity/0 is
/// negative`; malformed JSON with line and column.
[[nodiscard]] Scene load_scene_json(const std::filesystem::path& file);

} // namespace lightcuts
