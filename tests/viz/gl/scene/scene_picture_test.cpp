// SPDX-License-Identifier: MIT
#include <viz/gl/scene/scene_picture.h>

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <lightcuts/core/input_error.h>

#include <tests/render/support/box_scene.h>
#include <viz/gl/context/offscreen_context.h>
#include <viz/gl/scene/picking.h>

namespace lightcuts::viz {
namespace {

using ::testing::Each;

constexpr glm::uvec2 picture_size{90, 60};
constexpr Rgba8 background{24, 26, 30, 255}, green{0, 255, 0, 255};

/// Looks along -z from 10 m away.
OrbitCamera front_camera() {
  OrbitCamera camera;
  camera.distance = 10;
  return camera;
}

/// Of a picture of `picture_size` pixels; the place in pixels from the top left.
Rgba8 colour_at(const std::vector<Rgba8>& pixels, const glm::dvec2& place) {
  const glm::uvec2 pixel(place);
  return pixels.at(std::size_t{pixel.y} * picture_size.x + pixel.x);
}

Rgba8 colour_at(const std::vector<Rgba8>& pixels, const OrbitCamera& camera,
                const glm::vec3& point) {
  return colour_at(pixels, camera.screen_position(point, picture_size).value());
}

/// A wall of 2 m x 2 m in z = 0 that faces the camera.
Scene wall() {
  Scene scene;
  const std::uint32_t surface = test::add_surface(scene, glm::vec3(0.5F));
  test::add_quad(scene, surface, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
  return scene;
}

class ScenePictureTest : public ::testing::Test {
protected:
  void TearDown() override { EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR)); }

  /// The scene with an overlay from the front.
  static std::vector<Rgba8> drawn(const Scene& scene, const Overlay& overlay,
                                  const ScenePicture::Config& config = {}) {
    ScenePicture picture(scene);
    picture.draw(front_camera(), picture_size, config, overlay);
    return picture.pixels();
  }

private:
  OffscreenContext context_;
};

TEST_F(ScenePictureTest, EmptySceneDrawsNothing) {
  ScenePicture picture(Scene{});
  picture.draw(front_camera(), picture_size, {});
  EXPECT_EQ(picture.pixels().size(), 90U * 60);
  EXPECT_THAT(picture.pixels(), Each(background));
  EXPECT_EQ(picture.bounds(), Box::empty());
}

TEST_F(ScenePictureTest, LineIsWhereItsPointsAreSeen) {
  const glm::vec3 from{-3, -1, 1}, to{2, 1.5F, -4};
  const auto pixels = drawn({}, {.lines = {{from, to, green, 3.5F}}});
  const OrbitCamera camera = front_camera();
  for (const float t : {0.02F, 0.3F, 0.5F, 0.98F}) {
    const glm::vec3 p = glm::mix(from, to, t);
    EXPECT_EQ(colour_at(pixels, camera, p), green) << t;
    for (const double aside : {-4.0, 4.0}) {
      const glm::dvec2 place =
          camera.screen_position(p, picture_size).value() + glm::dvec2(0, aside);
      EXPECT_EQ(colour_at(pixels, place), background) << t;
    }
  }
  EXPECT_EQ(colour_at(pixels, camera, glm::mix(from, to, 1.1F)), background);
}

TEST_F(ScenePictureTest, LineFromBehindTheCameraIsDrawnUpToIt) {
  // Below the axis, from behind the eye to the depth of the target.
  const glm::vec3 from{0, -1, 30}, to{0, -1, 0};
  const OrbitCamera camera = front_camera();
  for (const auto& line : {ColouredLine{from, to, green}, ColouredLine{to, from, green}}) {
    const auto pixels = drawn({}, {.lines = {line}});
    for (const float z : {1.0F, 4.0F, 7.0F})
      EXPECT_EQ(colour_at(pixels, camera, {0, -1, z}), green);
    EXPECT_EQ(colour_at(pixels, {45, 10}), background); // not mirrored at the eye
  }
  EXPECT_THAT(drawn({}, {.lines = {{from, {0, 1, 20}, green}}}), Each(background));
}

TEST_F(ScenePictureTest, WidthsAndSizesAreInPixels) {
  const auto count = [](const std::vector<Rgba8>& pixels) {
    return std::count(pixels.begin(), pixels.end(), green);
  };
  const auto line = [&](float weight) { // 90 pixels long
    return count(drawn({}, {.lines = {{{-40, 0.1F, 0}, {40, 0.1F, 0}, green, weight}}}));
  };
  EXPECT_EQ(line(1), 90);
  EXPECT_EQ(line(2), 180);
  EXPECT_GE(line(3.5F), 270);
  const auto point = [&](float weight) {
    return double(count(drawn({}, {.points = {{{0, 0, 0}, green, weight}}})));
  };
  EXPECT_NEAR(point(6), 3.14 * 3 * 3, 6);
  EXPECT_NEAR(point(10), 3.14 * 5 * 5, 9);
}

TEST_F(ScenePictureTest, HiddenPartsAreFaint) {
  const glm::vec3 behind{0.5F, 0.5F, -1}, before{-0.5F, 0.5F, 1};
  const Overlay overlay{
      .lines = {{{0.5F, -9, -1}, {0.5F, 9, -1}, green}, {{-0.5F, -9, 1}, {-0.5F, 9, 1}, green}}};
  const auto pixels = drawn(wall(), overlay), bare = drawn(wall(), {});
  const OrbitCamera camera = front_camera();
  EXPECT_EQ(colour_at(pixels, camera, before), green);
  const Rgba8 faint = colour_at(pixels, camera, behind), grey = colour_at(bare, camera, behind);
  EXPECT_NE(grey, background);
  EXPECT_GT(faint.g, grey.g + 5);
  EXPECT_LT(faint.g, 230);
  EXPECT_GT(faint.r, 40);
  EXPECT_EQ(faint.a, 255);
}

TEST_F(ScenePictureTest, LineInASurfaceIsSeen) {
  const glm::vec3 from{-0.9F, -0.7F, 0}, to{0.9F, 0.8F, 0};
  ScenePicture picture(wall());
  OrbitCamera camera = front_camera();
  camera.orbit(0.9, 0.3); // depths differ all over the wall
  picture.draw(camera, picture_size, {}, {.lines = {{from, to, green}}});
  for (float t = 0.05F; t < 1; t += 0.05F)
    EXPECT_EQ(colour_at(picture.pixels(), camera, glm::mix(from, to, t)), green) << t;
}

TEST_F(ScenePictureTest, LightsShowTheirColour) {
  Scene scene = wall();
  scene.lights.add_omni({0.5F, 0, 1}, {0, 0, 30});
  scene.lights.add_spot({-0.5F, 0, 1}, {0, -1, 0}, {0.25F, 0, 0}, 0.1F, 0.2F);
  scene.lights.add_directional({-1, 0, 0}, {1, 1, 0});
  const OrbitCamera camera = front_camera();
  const auto pixels = drawn(scene, {});
  EXPECT_EQ(colour_at(pixels, camera, {0.5F, 0, 1}), Rgba8(0, 0, 255, 255));
  EXPECT_EQ(colour_at(pixels, camera, {-0.5F, 0, 1}), Rgba8(255, 0, 0, 255));
  const glm::dvec3 sun = shown_position(scene.lights[2], {{-1, -1, 0}, {1, 1, 0}});
  EXPECT_EQ(colour_at(pixels, camera, sun), Rgba8(255, 255, 0, 255));
  EXPECT_THAT(drawn(scene, {}, {.geometry = false, .lights = false}), Each(background));
}

TEST_F(ScenePictureTest, OfManyLightsASubsetIsDrawn) {
  Scene scene;
  for (std::uint32_t i = 0; i < 100003; ++i) scene.lights.add_omni({0, 0, 0}, glm::vec3(1));
  const ScenePicture picture(scene);
  EXPECT_EQ(picture.shown_lights(), ScenePicture::max_shown_lights);
}

TEST_F(ScenePictureTest, ClosedRoomIsSeenInto) {
  Scene scene = test::closed_box({4, 3, 4}, glm::vec3(0.5F));
  scene.lights.add_omni({2, 1.5F, 2}, {1, 0, 0});
  ScenePicture picture(scene);
  OrbitCamera camera;
  camera.yaw = 0.4;
  camera.pitch = 0.5;
  camera.fit(picture.bounds(), picture_size);
  picture.draw(camera, picture_size, {});
  EXPECT_EQ(colour_at(picture.pixels(), camera, {2, 1.5F, 2}), Rgba8(255, 0, 0, 255));
  for (const Rgba8& pixel : picture.pixels()) EXPECT_EQ(pixel.a, 255);
  picture.draw(camera, picture_size, {.solid = SolidFaces::both});
  EXPECT_GT(colour_at(picture.pixels(), camera, {2, 1.5F, 2}).g, 50); // behind a wall
}

TEST_F(ScenePictureTest, TracedCameraIsAPyramid) {
  ScenePicture::Config config;
  config.traced_camera = Camera{{0, 0, 2}, {0, 0, 1}, {0, 1, 0}, 40};
  config.traced_depth = 2;
  const auto pixels = drawn({}, {}, config);
  // Half-way along the edge to its upper right corner; tan 20 degrees, and 4/3 of it to the right.
  const glm::vec3 corner{2 * 0.36397F * 4 / 3, 2 * 0.36397F, 0};
  EXPECT_EQ(colour_at(pixels, front_camera(), glm::mix(glm::vec3(0, 0, 2), corner, 0.5F)),
            ScenePicture::camera_colour);
}

TEST_F(ScenePictureTest, PictureCanChangeItsSize) {
  ScenePicture picture(wall());
  for (const glm::uvec2 size : {glm::uvec2(64, 48), glm::uvec2(1, 1), glm::uvec2(31, 77)}) {
    picture.draw(front_camera(), size, {});
    EXPECT_EQ(picture.texture().size(), size);
    const std::vector<Rgba8> pixels = picture.pixels();
    ASSERT_EQ(pixels.size(), std::size_t{size.x} * size.y);
    EXPECT_NE(pixels[(size.y / 2) * size.x + size.x / 2], background); // the wall
  }
  EXPECT_THROW(picture.draw(front_camera(), {0, 5}, {}), InputError);
}

TEST_F(ScenePictureTest, IsTheSameFarFromTheOrigin) {
  constexpr glm::vec3 far{0x1p18F, -0x1p17F, 0x1p19F};
  Scene scene = wall();
  const Overlay overlay{.lines = {{{-1, -0.5F, 1}, {1, 0.5F, 0.5F}, green}}};
  const auto near_pixels = drawn(scene, overlay);
  for (glm::vec3& p : scene.mesh.positions) p += far;
  Overlay moved = overlay;
  moved.lines[0].a += far;
  moved.lines[0].b += far;
  ScenePicture picture(scene);
  OrbitCamera camera = front_camera();
  camera.target = far;
  picture.draw(camera, picture_size, {}, moved);
  EXPECT_EQ(picture.pixels(), near_pixels);
}

} // namespace
} // namespace lightcuts::viz
