// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// What a cloud's floor and blocks can shine with.
struct Gloss {
  const char* name;
  Lobe (*lobe)(float reflectance);
};
extern const std::array<Gloss, 5> glosses;

/// A room with boxes in it under a cloud of lights; see builtin_scenes().
struct CloudScene {
  static constexpr std::uint32_t max_blocks = 100'000;

  std::uint32_t lights = 10'000;
  std::uint32_t blocks = 40; ///< 0: the bare room, convex, in which nothing occludes
  const Gloss* gloss = &glosses[0];
  /// Nothing: all kinds in turn. With lights at infinity the room is open.
  std::optional<LightKind> kind = LightKind::omni;
  float clamp = 0; ///< LightSet::min_distance(), m
  std::uint64_t seed = 1;
};

Scene make_cloud(const CloudScene& parameters);
Scene make_desk(bool red_diagonal);
Scene make_bedroom();

} // namespace lightcuts
