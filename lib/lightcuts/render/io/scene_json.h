// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include <lightcuts/render/files/file_access.h>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// Reads a scene described in JSON:
///
///     {"geometry": "room.obj",                  or a list of models
///      "camera": {"position": [0, 1, 3], "target": [0, 1, 0], "up": [0, 1, 0], "fov": 45},
///      "image": {"width": 640, "height": 480},
///      "lights": [{"position": [0, 2, 0], "intensity": [1, 1, 1]}]}
///
/// Files are relative to the JSON file. Only `geometry` is required, and `up` and `fov` (vertical,
/// degrees) within a camera are optional. `lights`, where given, replace those of the models; they
/// are a list of any of these, made in this order:
///
///     {"type": "omni", "position": [0, 2, 0], "intensity": [1, 1, 1]}
///     {"type": "oriented", "position": [0, 2, 0], "normal": [0, -1, 0], "intensity": 1}
///     {"type": "spot", "position": [0, 2, 0], "axis": [0, -1, 0], "intensity": 1,
///      "inner": 20, "outer": 30}
///     {"type": "profile", "file": "lamp.ies", "position": [0, 2, 0], "axis": [0, -1, 0],
///      "plane": [1, 0, 0], "multiplier": 1, "efficacy": 683}
///     {"type": "directional", "direction": [1, -2, 0], "irradiance": 3}
///     {"generate": "cloud", "count": 1000, "seed": 1, "box": [[0, 1, 0], [4, 2, 4]],
///      "intensity": 20}
///     {"generate": "area", "count": 1000, "seed": 1}
///     {"generate": "environment", "file": "sky.exr", "count": 1024, "turn": 0,
///      "visible": false}
///     {"generate": "rectangle", "position": [0, 2, 0], "normal": [0, -1, 0], "along": [1, 0, 0],
///      "width": 2, "height": 1, "radiance": 5, "count": 64, "seed": 1}
///     {"generate": "disc", "position": [0, 2, 0], "normal": [0, -1, 0], "radius": 1, "power": 9}
///     {"generate": "sphere", "position": [0, 2, 0], "radius": 1, "radiance": 5}
///     {"generate": "tube", "position": [0, 2, 0], "axis": [1, 0, 0], "radius": 0.02, "length": 1,
///      "radiance": 5}
///     {"generate": "vpl", "paths": 1000, "bounces": 10, "seed": 1}
///     {"generate": "surfels", "count": 1000, "seed": 1}
///
/// - Without a type a light is omni. Of a spot `outer` and `inner` are angles off the axis,
/// degrees,
///   0 <= inner < outer <= 180, inner 0 by default. A directional light's direction is that in
///   which it travels. Directions have any length but 0.
/// - Intensities, W/sr (a cloud's: of all its lights together), and irradiances, W/m^2 (of a
/// surface
///   that faces the light), are a number or [r, g, b], each >= 0.
/// - A profile's file is that of read_ies(); candela / efficacy are W/sr. All but file and position
///   may be left out; see Light and usual_plane().
/// - What is generated is described in light_generator.h (the default box and intensity are those
/// of
///   default_cloud), area_lights.h, environment_lights.h, shape_lights.h, virtual_point_lights.h
///   and surfels.h. Only `count` (of an environment: `file`) or `paths` are required. VPLs and
///   surfels reflect the light of the lights before them in the list.
///
/// Each may have a "group": the name of its LightGroup, of letters, digits, '-', '_' and blanks.
///
/// An object as for a cloud, but without "generate", in place of the list is that cloud. At the top
/// level `"min_distance": 0.1`, metres, > 0, clamps distances (LightSet::set_min_distance).
///
/// Only files that `access` allows are read, by default those in the folder of the JSON and below.
///
/// Throws InputError that names file and element, as `scene.json: /lights/3/intensity/0 is
/// negative`; malformed JSON with line and column.
[[nodiscard]] Scene load_scene_json(const std::filesystem::path& file, const FileAccess& access);
[[nodiscard]] inline Scene load_scene_json(const std::filesystem::path& file) {
  return load_scene_json(file, FileAccess(file));
}

} // namespace lightcuts
