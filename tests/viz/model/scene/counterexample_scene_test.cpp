// SPDX-License-Identifier: MIT
#include <viz/model/scene/counterexample_scene.h>

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <lightcuts/render/io/open_scene.h>
#include <lightcuts/render/view/scene_view.h>
#include <oracle/cases/random_case.h>

namespace lightcuts::viz {
namespace {

/// One light over one point.
oracle::Case simple_case() {
  oracle::Case on;
  Light light;
  light.kind = LightKind::omni;
  light.position = {1, 5, 2};
  light.intensity = glm::vec3(3);
  on.lights.push_back(light);
  oracle::CaseView view;
  view.view.position = {1, 2, 2};
  view.view.normal = {0, 1, 0};
  view.view.to_viewer = glm::normalize(glm::vec3(1, 1, 0));
  view.view.material = {glm::vec3(0.25F), {}};
  on.views.push_back(view);
  return on;
}

/// What the middle of the picture shows.
std::optional<VisiblePoint> seen_in_the_middle(const Scene& scene) {
  Scene odd = scene;
  odd.image_size = {41, 31}; // has a middle
  return SceneView(odd).at({20, 15});
}

TEST(SceneOfCase, ShowsTheShadingPointInTheMiddle) {
  const Scene scene = scene_of_case(simple_case(), 0);
  validate(scene);
  const auto p = seen_in_the_middle(scene);
  ASSERT_TRUE(p);
  EXPECT_LT(glm::distance(p->point.position(), glm::vec3(1, 2, 2)), 1e-5F);
  EXPECT_LT(glm::distance(p->point.normal(), glm::vec3(0, 1, 0)), 1e-5F);
  EXPECT_LT(glm::distance(p->point.to_viewer(), glm::normalize(glm::vec3(1, 1, 0))), 1e-5F);
  EXPECT_EQ(p->point.material().diffuse, glm::vec3(0.25F));
  ASSERT_EQ(scene.lights.size(), 1U);
  EXPECT_EQ(scene.lights[0].position, glm::vec3(1, 5, 2));
}

TEST(SceneOfCase, HasASquareAsLargeAsTheNearestLightIsFar) {
  const Scene scene = scene_of_case(simple_case(), 0);
  ASSERT_EQ(scene.mesh.positions.size(), 4U);
  for (const glm::vec3& corner : scene.mesh.positions) {
    EXPECT_NEAR(corner.y, 2, 1e-5F);
    EXPECT_NEAR(glm::distance(corner, glm::vec3(1, 2, 2)), 3 * std::sqrt(2), 1e-5);
  }
}

TEST(SceneOfCase, IsThatOfTheViewAskedFor) {
  oracle::Case on = simple_case();
  on.views.push_back(on.views[0]);
  on.views[1].view.position = {7, 8, 9};
  const auto p = seen_in_the_middle(scene_of_case(on, 1));
  ASSERT_TRUE(p);
  EXPECT_LT(glm::distance(p->point.position(), glm::vec3(7, 8, 9)), 1e-4F);
}

TEST(SceneOfCase, HasTheCasesOwnTrianglesAndCamera) {
  oracle::Case on = simple_case();
  on.triangles.push_back({{-9, 0, -9}, {9, 0, -9}, {0, 0, 9}, 0});
  on.camera = {{0, 4, 1}, {0, 0, 0}, {0, 1, 0}, 40};
  on.image_size = {12, 10};
  const Scene scene = scene_of_case(on, 0);
  EXPECT_EQ(scene.mesh.triangles.size(), 1U);
  EXPECT_EQ(scene.camera, on.camera);
  EXPECT_EQ(scene.image_size, glm::uvec2(12, 10));
}

TEST(SceneOfCase, IsASceneThatShowsThePointWhateverTheCase) {
  for (std::uint64_t index = 0; index < 2000; ++index) {
    const oracle::Case on = oracle::random_case(3, index);
    for (std::size_t view = 0; view < on.views.size(); ++view) {
      const Scene scene = scene_of_case(on, view);
      ASSERT_NO_THROW(validate(scene)) << "case " << index;
      if (!on.triangles.empty()) continue;
      const auto p = seen_in_the_middle(scene);
      ASSERT_TRUE(p) << "case " << index;
      const glm::vec3 at = glm::clamp(on.views[view].view.position, -1e15F, 1e15F);
      // What floats can tell apart there.
      const float rounding = glm::distance(scene.camera.position, at) + 0.01F * glm::length(at);
      EXPECT_LT(glm::distance(p->point.position(), at), 1e-4F * rounding) << "case " << index;
    }
  }
}

} // namespace
} // namespace lightcuts::viz
