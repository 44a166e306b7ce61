// SPDX-License-Identifier: MIT
#include <lightcuts/render/view/pixel_square.h>

#include <gtest/gtest.h>
#include <lightcuts/core/blocks/block_cut_selector.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <lightcuts/render/builtin/builtin_scenes.h>
#include <lightcuts/render/shafts/shaft_prover.h>
#include <lightcuts/render/view/renderer.h>

namespace lightcuts {
namespace {

struct SquaredRoom {
  Scene scene = make_builtin("cloud?lights=300&blocks=5&material=glossy");
  LightTree tree = build(scene.lights);
  RenderConfig config{.method = methods::block_cuts, .cut = {0.1F, 100}, .seed = 3};

  SquaredRoom() { scene.image_size = {21, 13}; }
};

TEST(PixelSquare, HasThePixelsOfItsSquareThatSeeASurface) {
  const SquaredRoom room;
  const SceneView view(room.scene);
  const PixelSquare square(view, {20, 12});
  EXPECT_EQ(square.pixels.front(), glm::uvec2(16, 8));
  EXPECT_EQ(square.pixels.back(), glm::uvec2(20, 12));
  EXPECT_EQ(square.pixels.size(), 25U) << "the room is closed";
  EXPECT_EQ(square.query, 8U * 21 + 16);
  for (std::size_t i = 0; i < square.pixels.size(); ++i) {
    const auto p = view.at(square.pixels[i]);
    EXPECT_EQ(square.points[i].place, glm::vec2(square.pixels[i]));
    EXPECT_EQ(square.points[i].point.position(), p->point.position());
    EXPECT_EQ(square.seen[i].ray_origin, p->ray_origin);
  }
}

TEST(PixelSquare, IsLitAsAWhole) {
  const SquaredRoom room;
  const SceneView view(room.scene);
  const Rendering picture = render(view, room.tree, room.config);
  BlockCutSelector select(room.tree, room.config.cut, room.config.seed);
  for (const glm::uvec2 corner : {glm::uvec2(0, 0), glm::uvec2(16, 8)}) {
    const PixelSquare square(view, corner);
    const auto sees = [&](std::uint32_t p, std::uint32_t light) {
      return view.casts_to(square.seen[p], light);
    };
    ShaftProver proven(view.triangles(), square.ray_origins());
    const auto cuts = select(square.points, square.query, {sees, &proven});
    for (std::size_t k = 0; k < cuts.size(); ++k) {
      const std::size_t i = std::size_t(square.pixels[k].y) * 21 + square.pixels[k].x;
      EXPECT_EQ(picture.radiance[i], cuts[k].radiance);
      EXPECT_EQ(picture.certified_error[i], cuts[k].certified_error);
      EXPECT_EQ(picture.cut_size[i], float(cuts[k].size));
      EXPECT_EQ(picture.end[i], cuts[k].end);
      EXPECT_GT(picture.microseconds[i], 0);
    }
  }
}

TEST(PixelSquare, HasTheSameBitsWhicheverPixelsAreWanted) {
  const SquaredRoom room;
  const SceneView view(room.scene);
  const Rendering whole = render(view, room.tree, room.config);
  Rendering some = blank_rendering(view.size());
  const auto wanted = [](glm::uvec2 pixel) { return (pixel.x + pixel.y) % 5 == 0; };
  render_into(some, view, room.tree, room.config, wanted);
  std::uint64_t count = 0;
  for (unsigned y = 0; y < 13; ++y)
    for (unsigned x = 0; x < 21; ++x) {
      const std::size_t i = std::size_t(y) * 21 + x;
      EXPECT_EQ(some.radiance[i], wanted({x, y}) ? whole.radiance[i] : glm::vec3(0));
      count += wanted({x, y}) ? 1 : 0;
    }
  EXPECT_EQ(some.surface_pixels, count);
}

} // namespace
} // namespace lightcuts
