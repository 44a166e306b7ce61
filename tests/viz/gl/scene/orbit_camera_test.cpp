// SPDX-License-Identifier: MIT
#include <viz/gl/scene/orbit_camera.h>

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <lightcuts/render/view/camera.h>

#include <viz/gl/scene/picking.h>

namespace lightcuts::viz {
namespace {

constexpr glm::uvec2 view_size{200, 100};

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance) {
  EXPECT_LT(glm::length(a - b), tolerance)
      << a.x << " " << a.y << " " << a.z << " against " << b.x << " " << b.y << " " << b.z;
}

OrbitCamera somewhere() {
  OrbitCamera camera;
  camera.target = {1, -2, 3};
  camera.distance = 7;
  camera.yaw = 0.7;
  camera.pitch = -0.4;
  camera.vertical_fov = 50;
  return camera;
}

TEST(OrbitCamera, YawAndPitchAreAsStated) {
  OrbitCamera camera;
  camera.distance = 2;
  expect_near(camera.eye(), {0, 0, 2}, 1e-12);
  camera.yaw = std::numbers::pi / 2;
  expect_near(camera.eye(), {2, 0, 0}, 1e-12);
  camera.pitch = std::numbers::pi / 6;
  expect_near(camera.eye(), {std::sqrt(3), 1, 0}, 1e-12);
}

TEST(OrbitCamera, SurvivesTheWayToACameraAndBack) {
  for (const glm::dvec3 up : {glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0),
                              glm::dvec3(0, -1, 0), glm::dvec3(0, 0, -1)}) {
    OrbitCamera camera = somewhere();
    camera.up = up;
    const OrbitCamera back = OrbitCamera::from_camera(camera.to_camera(), camera.target);
    expect_near(back.target, camera.target, 1e-5);
    EXPECT_NEAR(back.distance, camera.distance, 1e-5);
    EXPECT_NEAR(back.yaw, camera.yaw, 1e-6);
    EXPECT_NEAR(back.pitch, camera.pitch, 1e-6);
    EXPECT_EQ(back.vertical_fov, camera.vertical_fov);
    EXPECT_EQ(back.up, camera.up);
    const glm::dvec3 before = camera.eye(), right = camera.frame(view_size).right;
    camera.orbit(0.1, 0);
    EXPECT_GT(glm::dot(camera.eye() - before, right), 0); // more yaw goes to the right
  }
}

TEST(OrbitCamera, SeesWhatTheCameraThatItCameFromSees) {
  const Camera camera{{3, 2, -1}, {0, 1, 5}, {0.1F, 1, 0.2F}, 60};
  const OrbitCamera orbit = OrbitCamera::from_camera(camera, {10, 0, 3});
  expect_near(orbit.eye(), glm::dvec3(camera.position), 1e-9);
  const PinholeView view(orbit.to_camera(), view_size);
  for (const glm::uvec2 pixel : {glm::uvec2(0, 0), glm::uvec2(150, 20), glm::uvec2(199, 99)}) {
    const auto place =
        orbit.screen_position(orbit.eye() + 3.0 * glm::dvec3(view.direction(pixel)), view_size);
    ASSERT_TRUE(place);
    EXPECT_LT(glm::distance(*place, glm::dvec2(pixel) + 0.5), 1e-3);
  }
  // Looks where the camera looks, and is as far from its target as the pivot is deep.
  const glm::dvec3 forward = glm::normalize(glm::dvec3(camera.target - camera.position));
  expect_near(glm::normalize(orbit.target - orbit.eye()), forward, 1e-9);
  EXPECT_NEAR(orbit.distance, glm::dot(glm::dvec3(10, 0, 3) - orbit.eye(), forward), 1e-9);
}

TEST(OrbitCamera, PivotBehindTheCameraIsNotUsed) {
  const Camera camera{{0, 0, 5}, {0, 0, 1}, {0, 1, 0}, 60};
  expect_near(OrbitCamera::from_camera(camera, {0, 0, 9}).target, {0, 0, 1}, 1e-9);
}

TEST(OrbitCamera, OrbitKeepsDistanceAndTargetAndStaysShortOfThePoles) {
  OrbitCamera camera = somewhere();
  for (int i = 0; i < 40; ++i) {
    camera.orbit(0.9, 0.3);
    EXPECT_NEAR(glm::distance(camera.eye(), somewhere().target), 7, 1e-12);
    EXPECT_LT(camera.eye().y - somewhere().target.y, 7);
    EXPECT_LE(std::abs(camera.yaw), 3.15);
    EXPECT_NO_THROW(PinholeView(camera.to_camera(), view_size));
  }
  EXPECT_EQ(camera.pitch, OrbitCamera::max_pitch);
  camera.orbit(0, -100);
  EXPECT_EQ(camera.pitch, -OrbitCamera::max_pitch);
  EXPECT_NE(camera.yaw, somewhere().yaw);
}

TEST(OrbitCamera, PanMovesTheTargetWithTheCursor) {
  OrbitCamera camera = somewhere();
  const glm::dvec3 point = camera.target;
  const glm::dvec2 before = camera.screen_position(point, view_size).value();
  EXPECT_LT(glm::distance(before, glm::dvec2(100, 50)), 1e-9);
  camera.pan({13, -21}, view_size);
  EXPECT_LT(
      glm::distance(camera.screen_position(point, view_size).value(), before + glm::dvec2(13, -21)),
      1e-9);
  EXPECT_EQ(camera.distance, 7);
}

TEST(OrbitCamera, DollyScalesTheDistanceWithinLimits) {
  OrbitCamera camera = somewhere();
  camera.dolly(0.5);
  EXPECT_EQ(camera.distance, 3.5);
  for (int i = 0; i < 200; ++i) camera.dolly(0.5);
  EXPECT_EQ(camera.distance, OrbitCamera::min_distance);
  for (int i = 0; i < 200; ++i) camera.dolly(2);
  EXPECT_EQ(camera.distance, OrbitCamera::max_distance);
}

TEST(OrbitCamera, FitShowsTheWholeBox) {
  const Box box{{-3, 1, 100}, {5, 2, 130}};
  for (const glm::uvec2 size : {glm::uvec2(300, 100), glm::uvec2(100, 300)}) {
    OrbitCamera camera = somewhere();
    camera.fit(box, size);
    double farthest = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 p((corner & 1) != 0 ? box.lo.x : box.hi.x,
                         (corner & 2) != 0 ? box.lo.y : box.hi.y,
                         (corner & 4) != 0 ? box.lo.z : box.hi.z);
      const auto place = camera.screen_position(p, size);
      ASSERT_TRUE(place);
      EXPECT_TRUE(place->x >= 0 && place->x <= size.x && place->y >= 0 && place->y <= size.y);
      farthest = std::max(farthest, glm::distance(*place, 0.5 * glm::dvec2(size)));
    }
    EXPECT_GT(farthest, 20); // and not from the moon
    EXPECT_EQ(camera.yaw, somewhere().yaw);
  }
  OrbitCamera camera = somewhere();
  camera.fit(Box::empty(), view_size);
  EXPECT_EQ(camera.distance, 7);
  camera.fit({{1, 1, 1}, {1, 1, 1}}, view_size);
  EXPECT_EQ(camera.distance, 1);
}

TEST(OrbitCamera, BehindTheCameraNothingIsSeen) {
  const OrbitCamera camera = somewhere();
  EXPECT_FALSE(camera.screen_position(2.0 * camera.eye() - camera.target, view_size));
}

TEST(Picking, FindsTheNearestPointWithinTheRadius) {
  OrbitCamera camera;
  camera.distance = 10;
  const ViewFrame frame = camera.frame(view_size);
  const std::vector<glm::dvec3> points{{0, 0, 20}, {1, 0, 0}, {0, 0, 0}, {0, 0, 3}, {0, 0, -3}};
  const auto pick = [&](const glm::dvec2& mouse, double radius) {
    return pick_point(frame, view_size, points, mouse, radius);
  };
  EXPECT_EQ(pick({100, 50}, 3), 3U); // of three in line, the one in front
  const glm::dvec2 place = camera.screen_position(points[1], view_size).value();
  EXPECT_EQ(pick(place + glm::dvec2(2, 0), 3), 1U);
  EXPECT_EQ(pick(place + glm::dvec2(2, 0), 1.9), std::nullopt);
  EXPECT_EQ(pick(0.6 * place + 0.4 * glm::dvec2(100, 50), 50), 1U);
}

TEST(Picking, DirectionalLightsAreAroundTheScene) {
  LightSet lights;
  lights.add_omni({0, 0, 0}, glm::vec3(1));
  lights.add_directional({-1, 0, 0}, glm::vec3(1));
  const Box scene{{-1, -1, -1}, {3, 1, 1}};
  expect_near(shown_position(lights[0], scene), glm::dvec3(0), 1e-12);
  expect_near(shown_position(lights[1], scene), {1 + std::sqrt(24), 0, 0}, 1e-6);
  expect_near(shown_position(lights[1], Box::empty()), {1, 0, 0}, 1e-12);
  OrbitCamera camera;
  camera.distance = 30;
  const glm::dvec2 place =
      camera.screen_position(shown_position(lights[1], scene), view_size).value();
  const std::array places{shown_position(lights[0], scene), shown_position(lights[1], scene)};
  EXPECT_EQ(pick_point(camera.frame(view_size), view_size, places, place, 1), 1U);
}

} // namespace
} // namespace lightcuts::viz
