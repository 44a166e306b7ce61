// SPDX-License-Identifier: MIT
#include <lightcuts/render/builtin/builtin_makers.h>
#include <lightcuts/render/builtin/shapes.h>
#include <lightcuts/render/lighting/random.h>

namespace lightcuts {
namespace {

constexpr int columns = 24, rows = 9;
constexpr float cell = 1.0F / 30;       // metres
constexpr float table_height = 0.74F;   // metres
constexpr float light_gap = 0.01F;      // metres from the screen to its lights
constexpr float total_intensity = 0.9F; // W/sr

constexpr glm::vec3 screen_lo{-0.5F * columns * cell, table_height + 0.12F, -0.18F};

/// Column and row of the line from the screen's lower left to its upper right.
bool on_diagonal(int column, int row) { return column * rows / columns == row; }

glm::vec3 colour(int column, int row, bool red_diagonal) {
  return red_diagonal && on_diagonal(column, row) ? glm::vec3(1, 0, 0) : glm::vec3(1);
}

void add_screen(ShapeBuilder& shapes, bool red_diagonal) {
  const auto add_cells = [&](bool diagonal) {
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) {
        if ((red_diagonal && on_diagonal(column, row)) != diagonal) continue;
        const glm::vec3 p =
            screen_lo + cell * glm::vec3(static_cast<float>(column), static_cast<float>(row), 0);
        shapes.quad(p, p + glm::vec3(cell, 0, 0), p + glm::vec3(cell, cell, 0),
                    p + glm::vec3(0, cell, 0));
      }
  };
  // Black: the lights are so close that a reflecting screen would show each as a hot spot.
  shapes.use("screen", {}, glm::vec3(0.9F));
  add_cells(false);
  if (!red_diagonal) return;
  shapes.use("screen, red", {}, {0.9F, 0, 0});
  add_cells(true);
}

void add_lights(LightSet& lights, bool red_diagonal) {
  const float share = total_intensity / (columns * rows);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      lights.add_omni(screen_lo + glm::vec3((static_cast<float>(column) + 0.5F) * cell,
                                            (static_cast<float>(row) + 0.5F) * cell, light_gap),
                      share * colour(column, row, red_diagonal));
}

void add_monitor(ShapeBuilder& shapes) {
  const glm::vec3 lo = screen_lo, hi = lo + glm::vec3(columns * cell, rows * cell, 0);
  const float rim = 0.012F;
  shapes.use("monitor", diffuse_and_phong({0.05F, 0.05F, 0.05F}, glm::vec3(0.2F), 30));
  shapes.box({lo.x - rim, lo.y - rim, lo.z - 0.04F}, {hi.x + rim, hi.y + rim, lo.z - 0.001F});
  shapes.box({-0.03F, table_height + 0.012F, lo.z - 0.07F}, {0.03F, lo.y + 0.15F, lo.z - 0.041F});
  shapes.cylinder({0, table_height, lo.z - 0.04F}, 0.13F, 0.12F, 0.012F, 16, false);
}

void add_room(ShapeBuilder& shapes) {
  shapes.use("floor", diffuse_and_phong({0.40F, 0.30F, 0.22F}, glm::vec3(0.05F), 20));
  shapes.quad({-1.15F, 0, 1.8F}, {1.8F, 0, 1.8F}, {1.8F, 0, -0.7F}, {-1.15F, 0, -0.7F});
  shapes.use("back wall", diffuse_and_phong({0.72F, 0.70F, 0.65F}, {}, 0));
  shapes.quad({-1.15F, 0, -0.7F}, {1.8F, 0, -0.7F}, {1.8F, 2.4F, -0.7F}, {-1.15F, 2.4F, -0.7F});
  shapes.use("side wall", diffuse_and_phong({0.45F, 0.58F, 0.62F}, {}, 0));
  shapes.quad({-1.15F, 0, 1.8F}, {-1.15F, 0, -0.7F}, {-1.15F, 2.4F, -0.7F}, {-1.15F, 2.4F, 1.8F});
}

void add_table(ShapeBuilder& shapes) {
  shapes.use("table top", diffuse_and_phong({0.50F, 0.34F, 0.20F}, glm::vec3(0.25F), 80));
  shapes.box({-0.85F, table_height - 0.03F, -0.45F}, {0.85F, table_height, 0.45F});
  shapes.use("table leg", diffuse_and_phong({0.25F, 0.25F, 0.27F}, {}, 0));
  for (const float x : {-0.80F, 0.74F})
    for (const float z : {-0.40F, 0.34F})
      shapes.standing_box({x, 0, z}, {x + 0.06F, table_height - 0.03F, z + 0.06F});
}

void add_keyboard(ShapeBuilder& shapes) {
  shapes.use("keyboard", diffuse_and_phong({0.15F, 0.15F, 0.16F}, {}, 0));
  shapes.box({-0.22F, table_height, 0.13F}, {0.22F, table_height + 0.015F, 0.27F});
  shapes.use("keys", diffuse_and_phong({0.55F, 0.55F, 0.57F}, {}, 0));
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 12; ++column) {
      const glm::vec3 key(-0.21F + 0.035F * static_cast<float>(column), table_height + 0.015F,
                          0.14F + 0.031F * static_cast<float>(row));
      shapes.standing_box(key, key + glm::vec3(0.029F, 0.006F, 0.025F));
    }
  shapes.use("mouse", diffuse_and_phong({0.65F, 0.65F, 0.66F}, glm::vec3(0.1F), 40));
  shapes.cushion({0.33F, table_height + 0.014F, 0.2F}, {0.03F, 0.016F, 0.05F}, 4);
}

void add_mug(ShapeBuilder& shapes) {
  const glm::vec3 base(0.52F, table_height, 0.08F);
  shapes.use("mug", diffuse_and_phong({0.15F, 0.32F, 0.60F}, glm::vec3(0.3F), 100));
  shapes.cylinder(base, 0.038F, 0.042F, 0.095F, 16, true, false);
  shapes.box(base + glm::vec3(0.038F, 0.065F, -0.006F), base + glm::vec3(0.07F, 0.077F, 0.006F));
  shapes.box(base + glm::vec3(0.038F, 0.022F, -0.006F), base + glm::vec3(0.07F, 0.034F, 0.006F));
  shapes.box(base + glm::vec3(0.07F, 0.022F, -0.006F), base + glm::vec3(0.082F, 0.077F, 0.006F));
  shapes.use("coffee", diffuse_and_phong({0.08F, 0.04F, 0.02F}, glm::vec3(0.1F), 200));
  shapes.cylinder(base + glm::vec3(0, 0.07F, 0), 0.038F, 0.04F, 0.005F, 16, false);
}

void add_books(ShapeBuilder& shapes) {
  const glm::vec3 covers[] = {{0.60F, 0.16F, 0.14F}, {0.20F, 0.42F, 0.24F}, {0.70F, 0.58F, 0.25F}};
  const float sines[] = {0, 0.28F, -0.6F}, cosines[] = {1, 0.96F, 0.8F}; // Pythagorean triples
  for (int i = 0; i < 3; ++i) {
    shapes.use("book " + std::to_string(i + 1), {covers[i], {}});
    const float y = table_height + 0.036F * static_cast<float>(i);
    shapes.place({{-0.6F, y, 0.12F}, cosines[i], sines[i]});
    shapes.box({-0.1F, 0, -0.14F}, {0.1F, 0.035F, 0.14F});
  }
  shapes.use("paper", diffuse_and_phong({0.80F, 0.80F, 0.76F}, {}, 0));
  shapes.place({{0.62F, table_height, 0.28F}, 0.96F, 0.28F});
  shapes.box({-0.105F, 0, -0.14F}, {0.105F, 0.004F, 0.14F});
  shapes.place({});
}

} // namespace

Scene make_desk(bool red_diagonal) {
  Scene scene;
  ShapeBuilder shapes(scene);
  add_room(shapes);
  add_table(shapes);
  add_monitor(shapes);
  add_screen(shapes, red_diagonal);
  add_keyboard(shapes);
  add_mug(shapes);
  add_books(shapes);
  add_lights(scene.lights, red_diagonal);
  scene.camera = {{1.0F, 1.55F, 1.2F}, {-0.16F, 0.78F, 0.0F}, {0, 1, 0}, 42};
  return scene;
}

} // namespace lightcuts
