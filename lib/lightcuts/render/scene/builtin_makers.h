// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// What a cloud's floor and blocks shine with.
enum class Gloss : std::uint8_t { diffuse, phong, ward, ggx };
/// The lights of a cloud; mixed: all four kinds in turn.
enum class CloudLights : std::uint8_t { omni, oriented, spot, directional, mixed };

/// A room with boxes in it under a cloud of lights; see builtin_scenes().
struct CloudScene {
  static constexpr std::uint32_t max_blocks = 100'000;

  std::uint32_t lights = 10'000;
  std::uint32_t blocks = 40; ///< 0: the bare room, convex, in which nothing occludes
  Gloss gloss = Gloss::diffuse;
  CloudLights kind = CloudLights::omni; ///< with directional ones the room is open
  float clamp = 0;                      ///< LightSet::min_distance(), m
  std::uint64_t seed = 1;
};

Scene make_cloud(const CloudScene& parameters);
Scene make_desk(bool red_diagonal);
Scene make_bedroom();

} // namespace lightcuts
