// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <lightcuts/render/scene.h>

namespace lightcuts {

/// A room among boxes: `cloud?lights=N&blocks=B&material=diffuse|glossy&seed=S`.
struct CloudScene {
  static constexpr std::uint32_t max_blocks = 100'000;

  std::uint32_t lights = 10'000;
  std::uint32_t blocks = 40; ///< 0: the bare room, convex, in which nothing occludes
  bool glossy = false;       ///< floor and blocks get a Phong lobe, exponent 50
  std::uint64_t seed = 1;
};

Scene make_cloud(const CloudScene& parameters);
Scene make_desk(bool red_diagonal);
Scene make_bedroom();

} // namespace lightcuts
