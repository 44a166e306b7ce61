// SPDX-License-Identifier: MIT
#include <lightcuts/render/lighting/light_generator.h>

#include <lightcuts/render/builtin/builtin_makers.h>
#include <lightcuts/render/builtin/shapes.h>
#include <lightcuts/render/lighting/random.h>

namespace lightcuts {
namespace {

// Inner size of the room, metres: x to the right, z towards the viewer.
constexpr float bedroom_width = 4, bedroom_height = 2.6F, bedroom_depth = 4.2F;

Material matt(float r, float g, float b) { return {{r, g, b}, {}}; }

Material shiny(float r, float g, float b, float shine, float exponent) {
  return diffuse_and_phong({r, g, b}, glm::vec3(shine), exponent);
}

void add_walls(ShapeBuilder& shapes) {
  shapes.use("floor", shiny(0.50F, 0.36F, 0.24F, 0.15F, 40));
  for (int i = 0; i < 20; ++i) { // boards
    const float x0 = bedroom_width * static_cast<float>(i) / 20,
                x1 = bedroom_width * static_cast<float>(i + 1) / 20;
    shapes.quad({x0, 0, bedroom_depth}, {x1, 0, bedroom_depth}, {x1, 0, 0}, {x0, 0, 0});
  }
  shapes.use("wall", matt(0.72F, 0.70F, 0.64F));
  shapes.quad({0, 0, 0}, {bedroom_width, 0, 0}, {bedroom_width, bedroom_height, 0},
              {0, bedroom_height, 0});
  shapes.quad({bedroom_width, 0, bedroom_depth}, {0, 0, bedroom_depth},
              {0, bedroom_height, bedroom_depth}, {bedroom_width, bedroom_height, bedroom_depth});
  shapes.quad({0, 0, bedroom_depth}, {0, 0, 0}, {0, bedroom_height, 0},
              {0, bedroom_height, bedroom_depth});
  shapes.quad({bedroom_width, 0, 0}, {bedroom_width, 0, bedroom_depth},
              {bedroom_width, bedroom_height, bedroom_depth}, {bedroom_width, bedroom_height, 0});
  shapes.use("ceiling", matt(0.78F, 0.78F, 0.78F));
  shapes.quad({0, bedroom_height, 0}, {bedroom_width, bedroom_height, 0},
              {bedroom_width, bedroom_height, bedroom_depth}, {0, bedroom_height, bedroom_depth});
  shapes.use("skirting", matt(0.80F, 0.80F, 0.80F));
  shapes.standing_box({0.001F, 0, 0.001F}, {bedroom_width - 0.001F, 0.08F, 0.015F});
  shapes.standing_box({0.001F, 0, 0.016F}, {0.015F, 0.08F, bedroom_depth - 0.001F});
}

void add_window(ShapeBuilder& shapes) {
  shapes.use("window frame", matt(0.82F, 0.82F, 0.82F));
  const auto bar = [&](float z0, float y0, float z1, float y1) {
    shapes.box({0.002F, y0, z0}, {0.05F, y1, z1});
  };
  bar(1.3F, 1.0F, 2.7F, 1.06F);
  bar(1.3F, 2.14F, 2.7F, 2.2F);
  bar(1.3F, 1.061F, 1.36F, 2.139F);
  bar(2.64F, 1.061F, 2.7F, 2.139F);
  bar(1.97F, 1.061F, 2.03F, 2.139F);
  shapes.use("glass", shiny(0.02F, 0.03F, 0.06F, 0.3F, 400));
  shapes.quad({0.01F, 1.0F, 2.7F}, {0.01F, 1.0F, 1.3F}, {0.01F, 2.2F, 1.3F}, {0.01F, 2.2F, 2.7F});
  shapes.use("sill", shiny(0.75F, 0.75F, 0.72F, 0.1F, 60));
  shapes.box({0.002F, 0.96F, 1.2F}, {0.2F, 0.99F, 2.8F});
}

void add_curtains(ShapeBuilder& shapes) {
  shapes.use("curtain", matt(0.30F, 0.36F, 0.55F));
  for (const float start : {0.95F, 2.72F})
    for (int fold = 0; fold < 8; ++fold) {
      const float z0 = start + 0.042F * static_cast<float>(fold), z1 = z0 + 0.042F;
      const float x0 = fold % 2 ? 0.13F : 0.07F, x1 = fold % 2 ? 0.07F : 0.13F;
      shapes.quad({x1, 0.2F, z1}, {x0, 0.2F, z0}, {x0, 2.3F, z0}, {x1, 2.3F, z1});
    }
  shapes.use("rod", shiny(0.35F, 0.30F, 0.20F, 0.4F, 120));
  shapes.box({0.09F, 2.31F, 0.85F}, {0.11F, 2.33F, 3.15F});
}

void add_bed(ShapeBuilder& shapes) {
  shapes.use("bed", shiny(0.42F, 0.26F, 0.15F, 0.12F, 30));
  shapes.box({1.2F, 0.12F, 0.1F}, {2.8F, 0.32F, 2.2F});
  shapes.standing_box({1.15F, 0, 0.03F}, {2.85F, 1.0F, 0.09F});
  shapes.standing_box({1.15F, 0, 2.21F}, {2.85F, 0.45F, 2.26F});
  for (const float x : {1.22F, 2.70F})
    for (const float z : {0.15F, 2.05F})
      shapes.standing_box({x, 0, z}, {x + 0.08F, 0.12F, z + 0.08F});
  shapes.use("mattress", matt(0.78F, 0.77F, 0.72F));
  shapes.box({1.23F, 0.321F, 0.12F}, {2.77F, 0.5F, 2.18F});
  shapes.use("blanket", matt(0.55F, 0.22F, 0.24F));
  shapes.cloth({1.2F, 0.505F, 0.85F}, {2.8F, 0.55F, 2.2F}, 16);
  shapes.quad({1.2F, 0.15F, 2.2F}, {1.2F, 0.15F, 0.85F}, {1.2F, 0.53F, 0.85F}, {1.2F, 0.53F, 2.2F});
  shapes.quad({2.8F, 0.15F, 0.85F}, {2.8F, 0.15F, 2.2F}, {2.8F, 0.53F, 2.2F}, {2.8F, 0.53F, 0.85F});
  shapes.use("pillow", matt(0.80F, 0.80F, 0.78F));
  for (const float x : {1.62F, 2.38F}) shapes.cushion({x, 0.58F, 0.42F}, {0.34F, 0.09F, 0.24F}, 8);
}

void add_bedside_table(ShapeBuilder& shapes, float x) {
  shapes.use("bedside table", shiny(0.45F, 0.30F, 0.18F, 0.12F, 30));
  shapes.box({x, 0.1F, 0.05F}, {x + 0.42F, 0.5F, 0.45F});
  for (const float dx : {0.02F, 0.36F})
    for (const float z : {0.07F, 0.39F})
      shapes.standing_box({x + dx, 0, z}, {x + dx + 0.04F, 0.1F, z + 0.04F});
  shapes.use("drawer", matt(0.60F, 0.45F, 0.30F));
  shapes.box({x + 0.03F, 0.14F, 0.451F}, {x + 0.39F, 0.29F, 0.462F});
  shapes.box({x + 0.03F, 0.31F, 0.451F}, {x + 0.39F, 0.46F, 0.462F});
  shapes.use("knob", shiny(0.50F, 0.42F, 0.20F, 0.4F, 150));
  for (const float y : {0.215F, 0.385F})
    shapes.box({x + 0.195F, y - 0.012F, 0.463F}, {x + 0.225F, y + 0.012F, 0.485F});
}

void add_lamp(ShapeBuilder& shapes, float x) {
  const glm::vec3 base(x, 0.5F, 0.25F);
  shapes.use("lamp", shiny(0.30F, 0.28F, 0.25F, 0.5F, 200));
  shapes.cylinder(base, 0.08F, 0.07F, 0.02F, 16, false);
  shapes.cylinder(base + glm::vec3(0, 0.02F, 0), 0.012F, 0.012F, 0.28F, 8, false, false);
  shapes.use("lamp shade", matt(0.80F, 0.72F, 0.55F));
  shapes.cylinder(base + glm::vec3(0, 0.24F, 0), 0.14F, 0.09F, 0.2F, 16, false, false);
}

void add_wardrobe(ShapeBuilder& shapes) {
  shapes.use("wardrobe", matt(0.62F, 0.50F, 0.36F));
  shapes.standing_box({3.38F, 0, 1.3F}, {3.98F, 1.8F, 2.7F});
  shapes.use("wardrobe door", shiny(0.66F, 0.55F, 0.42F, 0.08F, 30));
  shapes.box({3.36F, 0.06F, 1.33F}, {3.3795F, 1.76F, 1.99F});
  shapes.box({3.36F, 0.06F, 2.01F}, {3.3795F, 1.76F, 2.67F});
  shapes.use("handle", shiny(0.40F, 0.40F, 0.42F, 0.5F, 200));
  shapes.box({3.335F, 0.85F, 1.93F}, {3.359F, 1.05F, 1.95F});
  shapes.box({3.335F, 0.85F, 2.05F}, {3.359F, 1.05F, 2.07F});
}

void add_desk(ShapeBuilder& shapes) {
  shapes.use("desk", shiny(0.55F, 0.42F, 0.28F, 0.2F, 60));
  shapes.box({0.05F, 0.70F, 3.1F}, {0.7F, 0.74F, 4.15F});
  shapes.use("desk leg", matt(0.22F, 0.22F, 0.24F));
  for (const float x : {0.07F, 0.63F})
    for (const float z : {3.12F, 4.08F})
      shapes.standing_box({x, 0, z}, {x + 0.05F, 0.70F, z + 0.05F});
  shapes.use("chair", matt(0.25F, 0.45F, 0.40F));
  shapes.place({{1.0F, 0, 3.2F}, 0.6F, 0.8F});
  shapes.box({-0.21F, 0.43F, -0.21F}, {0.21F, 0.46F, 0.21F});
  shapes.box({-0.21F, 0.52F, 0.18F}, {0.21F, 0.9F, 0.21F});
  for (const float x : {-0.2F, 0.16F})
    for (const float z : {-0.2F, 0.16F})
      shapes.standing_box({x, 0, z}, {x + 0.04F, z > 0 ? 0.519F : 0.429F, z + 0.04F});
  shapes.place({});
}

void add_shelf(ShapeBuilder& shapes) {
  shapes.use("shelf", matt(0.58F, 0.44F, 0.30F));
  shapes.box({3.05F, 1.25F, 0.002F}, {3.95F, 1.28F, 0.26F});
  const glm::vec3 covers[] = {
      {0.60F, 0.20F, 0.15F}, {0.20F, 0.35F, 0.55F}, {0.65F, 0.55F, 0.20F}, {0.25F, 0.45F, 0.25F}};
  Random random(7);
  for (int colour = 0; colour < 4; ++colour) {
    shapes.use("book " + std::to_string(colour + 1), {covers[colour], {}});
    for (int i = colour; i < 16; i += 4) {
      const float x = 3.08F + 0.05F * static_cast<float>(i);
      shapes.standing_box({x, 1.28F, 0.02F},
                          {x + random.between(0.025F, 0.045F), 1.28F + random.between(0.16F, 0.27F),
                           random.between(0.16F, 0.23F)});
    }
  }
}

void add_picture(ShapeBuilder& shapes) {
  shapes.use("picture frame", shiny(0.20F, 0.14F, 0.08F, 0.3F, 80));
  shapes.box({1.5F, 1.25F, 0.002F}, {2.5F, 1.95F, 0.03F});
  shapes.use("picture", matt(0.75F, 0.72F, 0.62F));
  shapes.quad({1.55F, 1.3F, 0.031F}, {2.45F, 1.3F, 0.031F}, {2.45F, 1.9F, 0.031F},
              {1.55F, 1.9F, 0.031F});
  shapes.use("picture, hill", matt(0.25F, 0.42F, 0.22F));
  shapes.quad({1.55F, 1.3F, 0.032F}, {2.45F, 1.3F, 0.032F}, {2.45F, 1.48F, 0.032F},
              {1.9F, 1.68F, 0.032F});
}

void add_rug_and_plant(ShapeBuilder& shapes) {
  shapes.use("rug", matt(0.62F, 0.56F, 0.42F));
  shapes.cloth({1.3F, 0.004F, 2.5F}, {2.9F, 0.014F, 3.7F}, 12);
  shapes.use("pot", shiny(0.55F, 0.28F, 0.18F, 0.1F, 30));
  shapes.cylinder({0.45F, 0, 0.95F}, 0.11F, 0.15F, 0.28F, 16, false, false);
  shapes.use("soil", matt(0.12F, 0.08F, 0.05F));
  shapes.cylinder({0.45F, 0.22F, 0.95F}, 0.135F, 0.138F, 0.02F, 16, false);
  shapes.use("leaf", shiny(0.18F, 0.40F, 0.16F, 0.08F, 30));
  Random random(11);
  for (int i = 0; i < 40; ++i) {
    const glm::vec3 foot(0.45F, 0.24F, 0.95F);
    const float z = random.between(-0.3F, 0.3F), y = random.between(0.3F, 0.8F);
    const glm::vec3 tip = foot + glm::vec3(random.between(-0.3F, 0.3F), y, z);
    const float side_z = random.between(0.02F, 0.05F);
    const glm::vec3 side(random.between(-0.04F, 0.04F), 0, side_z);
    const glm::vec3 middle = 0.5F * (foot + tip) + glm::vec3(0, 0.08F, 0);
    shapes.quad(foot, middle + side, tip, middle - side);
  }
}

} // namespace

Scene make_bedroom() {
  Scene scene;
  ShapeBuilder shapes(scene);
  add_walls(shapes);
  add_window(shapes);
  add_curtains(shapes);
  add_bed(shapes);
  for (const float x : {0.68F, 2.9F}) add_bedside_table(shapes, x);
  for (const float x : {0.89F, 3.11F}) add_lamp(shapes, x);
  add_wardrobe(shapes);
  add_desk(shapes);
  add_shelf(shapes);
  add_picture(shapes);
  add_rug_and_plant(shapes);
  // Above all furniture, and 0.3 m off the walls and what hangs on them.
  const LightCloud cloud{100, 5, {0.3F, 1.85F, 0.3F}, {3.7F, 2.45F, 3.9F}, glm::vec3(10), true};
  generate(cloud, scene.lights);
  scene.camera = {{2.75F, 1.7F, 4.12F}, {1.95F, 0.8F, 0.9F}, {0, 1, 0}, 62};
  return scene;
}

} // namespace lightcuts
