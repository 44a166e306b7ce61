// SPDX-License-Identifier: MIT
#include <cmath>

#include <lightcuts/render/lighting/light_generator.h>
#include <lightcuts/render/lighting/light_kinds.h>

#include <lightcuts/render/builtin/builtin_makers.h>
#include <lightcuts/render/builtin/shapes.h>
#include <lightcuts/render/lighting/random.h>

namespace lightcuts {
namespace {

constexpr float cloud_width = 8, cloud_height = 4, cloud_depth = 8; // metres
constexpr float tallest_block = 1.9F;                               // lights hang above

Lobe phong(float reflectance) { return Phong{glm::vec3(reflectance), 50}; }
Lobe ward(float reflectance) { return Ward{glm::vec3(reflectance), 0.15F}; }
Lobe ggx(float reflectance) { return CookTorrance{glm::vec3(0.2F * reflectance), 0.15F}; }

/// The room's inner walls, of an open one those away from the camera: strictly convex, so nothing
/// occludes.
void add_room(ShapeBuilder& shapes, const CloudScene& parameters) {
  const float w = cloud_width / 2, d = cloud_depth / 2;
  const bool closed = parameters.kind && !is_at_infinity(*parameters.kind);
  shapes.use("floor", {{0.55F, 0.52F, 0.48F}, parameters.gloss->lobe(0.3F)});
  shapes.quad({-w, 0, d}, {w, 0, d}, {w, 0, -d}, {-w, 0, -d});
  if (closed) {
    shapes.use("ceiling", {{0.75F, 0.75F, 0.75F}, {}});
    shapes.quad({-w, cloud_height, -d}, {w, cloud_height, -d}, {w, cloud_height, d},
                {-w, cloud_height, d});
  }
  shapes.use("front and back", {{0.70F, 0.70F, 0.66F}, {}});
  shapes.quad({-w, 0, -d}, {w, 0, -d}, {w, cloud_height, -d}, {-w, cloud_height, -d});
  if (closed) shapes.quad({w, 0, d}, {-w, 0, d}, {-w, cloud_height, d}, {w, cloud_height, d});
  shapes.use("left", {{0.65F, 0.30F, 0.25F}, {}});
  shapes.quad({-w, 0, d}, {-w, 0, -d}, {-w, cloud_height, -d}, {-w, cloud_height, d});
  if (!closed) return;
  shapes.use("right", {{0.28F, 0.42F, 0.62F}, {}});
  shapes.quad({w, 0, -d}, {w, 0, d}, {w, cloud_height, d}, {w, cloud_height, -d});
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
  shapes.use("block", {{0.55F, 0.55F, 0.55F}, parameters.gloss->lobe(0.35F)});
  for (std::uint32_t i = 0; i < parameters.blocks; ++i) {
    Random random(~parameters.seed, i);
    Placement placement = random_turn(random);
    const float half_depth = random.between(0.12F, 0.4F), half_width = random.between(0.12F, 0.4F);
    placement.origin = {random.between(-3.4F, 3.4F), 0, random.between(-3.4F, 3.4F)};
    shapes.place(placement);
    shapes.standing_box({-half_width, 0, -half_depth},
                        {half_width, random.between(0.2F, tallest_block), half_depth});
  }
  shapes.place({});
}

void add_lights(const TriangleMesh& room, const CloudScene& parameters, LightSet& lights) {
  LightCloud cloud = default_cloud(room, parameters.lights, parameters.seed);
  cloud.random_colours = true;
  LightSet omni;
  generate(cloud, omni);
  lights.reserve(omni.size());
  if (parameters.clamp > 0) lights.set_min_distance(parameters.clamp);
  for (std::uint32_t i = 0; i < omni.size(); ++i) {
    const Light& light = omni[i];
    Random random(parameters.seed + 1, i);
    const LightKind kind = parameters.kind.value_or(LightKind(i % light_kind_count));
    with_kind_in_scenes(kind, [&](auto described) { described.add(light, random, lights); });
  }
}

} // namespace

const std::array<Gloss, 5> glosses{{{"diffuse", [](float) -> Lobe { return NoLobe{}; }},
                                    {"phong", phong},
                                    {"ward", ward},
                                    {"ggx", ggx},
                                    {"glossy", phong}}};

Scene make_cloud(const CloudScene& parameters) {
  Scene scene;
  ShapeBuilder shapes(scene);
  add_room(shapes, parameters);
  if (parameters.blocks > 0) add_blocks(shapes, parameters);
  scene.camera = {{3.6F, 3.1F, 3.7F}, {-0.5F, 0.7F, -0.9F}, {0, 1, 0}, 60};
  add_lights(scene.mesh, parameters, scene.lights);
  return scene;
}

} // namespace lightcuts
