// SPDX-License-Identifier: MIT
#include <cmath>

#include <lightcuts/render/light_generator.h>

#include "builtin_makers.h"
#include "random.h"
#include "shapes.h"

namespace lightcuts {
namespace {

constexpr float width = 8, height = 4, depth = 8; // metres
constexpr float tallest_block = 1.9F;             // lights hang above

/// The room's six inner walls: strictly convex, so nothing occludes.
void add_room(ShapeBuilder& shapes, bool glossy) {
  const glm::vec3 shine = glossy ? glm::vec3(0.3F) : glm::vec3(0);
  const float exponent = glossy ? 50.0F : 0.0F;
  const float w = width / 2, d = depth / 2;
  shapes.use("floor", {{0.55F, 0.52F, 0.48F}, shine, exponent});
  shapes.quad({-w, 0, d}, {w, 0, d}, {w, 0, -d}, {-w, 0, -d});
  shapes.use("ceiling", {{0.75F, 0.75F, 0.75F}, {}, 0});
  shapes.quad({-w, height, -d}, {w, height, -d}, {w, height, d}, {-w, height, d});
  shapes.use("front and back", {{0.70F, 0.70F, 0.66F}, {}, 0});
  shapes.quad({-w, 0, -d}, {w, 0, -d}, {w, height, -d}, {-w, height, -d});
  shapes.quad({w, 0, d}, {-w, 0, d}, {-w, height, d}, {w, height, d});
  shapes.use("left", {{0.65F, 0.30F, 0.25F}, {}, 0});
  shapes.quad({-w, 0, d}, {-w, 0, -d}, {-w, height, -d}, {-w, height, d});
  shapes.use("right", {{0.28F, 0.42F, 0.62F}, {}, 0});
  shapes.quad({w, 0, -d}, {w, 0, d}, {w, height, d}, {w, height, -d});
}

/// A rotation that is uniform without sine or cosine: a point of the disc, normalised.
Placement random_turn(Random& random) {
  for (;;) {
    const float x = random.between(-1, 1), y = random.between(-1, 1);
    const float squared = x * x + y * y;
    if (squared > 0.01F && squared <= 1)
      return {{}, x / std::sqrt(squared), y / std::sqrt(squared)};
  }
}

void add_blocks(ShapeBuilder& shapes, const CloudScene& parameters) {
  const glm::vec3 shine = parameters.glossy ? glm::vec3(0.35F) : glm::vec3(0);
  shapes.use("block", {{0.55F, 0.55F, 0.55F}, shine, parameters.glossy ? 50.0F : 0.0F});
  for (std::uint32_t i = 0; i < parameters.blocks; ++i) {
    Random random(~parameters.seed, i);
    Placement placement = random_turn(random);
    const glm::vec3 half(random.between(0.12F, 0.4F), 0, random.between(0.12F, 0.4F));
    placement.origin = {random.between(-3.4F, 3.4F), 0, random.between(-3.4F, 3.4F)};
    shapes.place(placement);
    shapes.standing_box({-half.x, 0, -half.z},
                        {half.x, random.between(0.2F, tallest_block), half.z});
  }
  shapes.place({});
}

} // namespace

Scene make_cloud(const CloudScene& parameters) {
  Scene scene;
  ShapeBuilder shapes(scene);
  add_room(shapes, parameters.glossy);
  if (parameters.blocks > 0) add_blocks(shapes, parameters);
  scene.camera = {{3.6F, 3.1F, 3.7F}, {-0.5F, 0.7F, -0.9F}, {0, 1, 0}, 60};
  LightCloud cloud = default_cloud(scene.mesh, parameters.lights, parameters.seed);
  cloud.random_colours = true;
  generate(cloud, scene.lights);
  return scene;
}

} // namespace lightcuts
