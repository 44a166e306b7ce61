// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/jobs/progress.h>
#include <lightcuts/core/records/fields.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <lightcuts/render/io/open_scene.h>

namespace lightcuts {

/// A view in place of the scene's own, which it shares the direction upwards with.
struct CameraRequest {
  glm::vec3 position{0, 0, 1};
  glm::vec3 target{0, 0, 0};
  std::optional<float> vertical_fov; ///< degrees, in (0, 180); nothing: the scene's own

  bool operator==(const CameraRequest&) const = default;

  template <class Visitor>
  static constexpr void fields(Visitor&& field) {
    constexpr Domain fov = {.least = 0, .most = 180, .optional = true};
    field("position", &CameraRequest::position);
    field("target", &CameraRequest::target);
    field("vertical_fov", &CameraRequest::vertical_fov, fov);
  }
};

/// A scene to open, with the lights to add to it and the tree to build.
struct SceneRequest {
  std::string spec;                        ///< as open_scene() takes it
  std::optional<glm::uvec2> image_size;    ///< pixels; nothing: the scene's own
  std::uint32_t lights = 0;                ///< random ones in place of its own; 0: its own
  std::uint32_t area_lights = 0;           ///< see add_area_lights(); default: none
  std::string environment;                 ///< see add_environment_lights(): a file; "": none
  std::uint32_t environment_lights = 1024; ///< how many it adds
  float environment_turn = 0;        ///< degrees about +y, in [-360, 360]; see EnvironmentLights
  bool environment_visible = false;  ///< whether the camera sees it; default: false
  std::uint32_t vpls = 0;            ///< paths of add_virtual_point_lights(); default: none
  std::uint32_t surfels = 0;         ///< see add_surfels(); default: none
  std::optional<float> min_distance; ///< clamps distances, metres; nothing: the scene's own
  std::uint64_t seed = 1;            ///< of the lights that are made
  std::uint64_t tree_seed = 1;       ///< of the choice of representatives
  Builder builder = Builder::greedy;
  bool allow_outside = false; ///< whether it may name files outside its folder; default: false
  std::optional<CameraRequest> camera; ///< nothing: the scene's own

  bool operator==(const SceneRequest&) const = default;

  template <class Visitor>
  static constexpr void fields(Visitor&& field) {
    constexpr Domain size = {.least = 1, .most = max_image_side, .optional = true};
    constexpr Domain turn = {.least = -360, .most = 360, .optional = true};
    constexpr Domain distance = {.least = 1e-30, .most = 1e30, .optional = true};
    field("scene", &SceneRequest::spec);
    field("image_size", &SceneRequest::image_size, size);
    field("lights", &SceneRequest::lights, domain::optional);
    field("area_lights", &SceneRequest::area_lights, domain::optional);
    field("environment", &SceneRequest::environment, domain::optional);
    field("environment_lights", &SceneRequest::environment_lights, domain::optional);
    field("environment_turn", &SceneRequest::environment_turn, turn);
    field("environment_visible", &SceneRequest::environment_visible, domain::optional);
    field("vpls", &SceneRequest::vpls, domain::optional);
    field("surfels", &SceneRequest::surfels, domain::optional);
    field("min_distance", &SceneRequest::min_distance, distance);
    field("lights_seed", &SceneRequest::seed, domain::optional);
    field("tree_seed", &SceneRequest::tree_seed, domain::optional);
    field("builder", &SceneRequest::builder, domain::optional);
    field("allow_outside", &SceneRequest::allow_outside, domain::optional);
    field("scene_camera", &SceneRequest::camera, domain::optional);
  }
};

/// Opens the scene, and makes its lights in the order of the members: VPLs and surfels reflect all
/// those before them. threads: 0: one per core; the same lights for any number. Throws InputError,
/// and Cancelled.
[[nodiscard]] Scene open_scene(const SceneRequest& request, unsigned threads = 0,
                               const Progress& progress = {});

} // namespace lightcuts
