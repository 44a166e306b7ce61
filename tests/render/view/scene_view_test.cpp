// SPDX-License-Identifier: MIT
#include <lightcuts/render/view/scene_view.h>

#include <algorithm>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <lightcuts/core/kernels/transfer.h>
#include <lightcuts/render/builtin/builtin_scenes.h>

#include <lightcuts/render/builtin/shapes.h>

namespace lightcuts {
namespace {

/// A floor of 2 m x 2 m at y = 0 under a light and a plate of half its size at y = 1 between them.
Scene plate_over_floor(bool with_plate = true) {
  Scene scene;
  ShapeBuilder builder(scene);
  builder.use("floor", {glm::vec3(0.25F)}, {0, 0, 3});
  builder.quad({-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1});
  builder.use("plate", {glm::vec3(0.75F)});
  if (with_plate)
    builder.quad({-0.5F, 1, 0.5F}, {0.5F, 1, 0.5F}, {0.5F, 1, -0.5F}, {-0.5F, 1, -0.5F});
  scene.lights.add_omni({0, 2, 0}, glm::vec3(1));
  scene.camera = {{0, 0.5F, 2}, {0, 0, 0}, {0, 1, 0}, 60};
  scene.image_size = {32, 24};
  return scene;
}

template <class Visit>
void for_each_point(const SceneView& view, Visit&& visit) {
  for (unsigned y = 0; y < view.size().y; ++y)
    for (unsigned x = 0; x < view.size().x; ++x)
      if (const auto p = view.at({x, y})) visit(*p);
}

TEST(SceneView, ShowsTheSurfaceInTheMiddleOfThePicture) {
  Scene scene = plate_over_floor(false);
  scene.image_size = {33, 25};
  const auto p = SceneView(scene).at({16, 12});
  ASSERT_TRUE(p);
  EXPECT_LT(glm::length(p->point.position()), 1e-6F);
  EXPECT_EQ(p->point.normal(), glm::vec3(0, 1, 0));
  EXPECT_EQ(p->point.material().diffuse, glm::vec3(0.25F));
  EXPECT_EQ(p->emission, glm::vec3(0, 0, 3));
  EXPECT_GT(p->ray_origin.y, 0);
}

TEST(SceneView, IsSeenByAnotherCameraAsIfThatWereItsOwn) {
  const Scene scene = plate_over_floor();
  Scene moved = scene;
  moved.camera = {{1, 1.5F, 1}, {0, 0, 0}, {0, 1, 0}, 50};
  moved.image_size = {20, 30};
  const SceneView seen = SceneView(scene).seen_by(moved.camera, moved.image_size);
  const SceneView own(moved);
  EXPECT_EQ(seen.size(), glm::uvec2(20, 30));
  EXPECT_EQ(seen.may_occlude(), own.may_occlude());
  int points = 0;
  for (unsigned y = 0; y < 30; ++y)
    for (unsigned x = 0; x < 20; ++x) {
      const auto a = seen.at({x, y}), b = own.at({x, y});
      ASSERT_EQ(a.has_value(), b.has_value());
      if (!a) continue;
      ++points;
      EXPECT_EQ(a->point.position(), b->point.position());
      EXPECT_EQ(a->point.to_viewer(), b->point.to_viewer());
      EXPECT_EQ(seen.sees(*a, 0), own.sees(*b, 0));
    }
  EXPECT_GT(points, 100);
}

TEST(SceneView, ShowsNothingWhereNothingIs) {
  const Scene scene = plate_over_floor(false);
  EXPECT_FALSE(SceneView(scene).at({0, 0}));
}

TEST(SceneView, MirrorsTheViewersDirection) {
  Scene scene = plate_over_floor(false);
  scene.image_size = {1, 1};
  const auto p = SceneView(scene).at({0, 0});
  ASSERT_TRUE(p);
  const glm::vec3 expected = glm::normalize(glm::vec3(0, 0.5F, -2));
  EXPECT_LT(glm::length(p->point.mirror() - expected), 1e-6F);
}

// The plate's shadow, from a light twice as high, is twice as wide: the whole floor.
TEST(SceneView, SeesTheLightWhereThePlateIsNotBetween) {
  Scene scene = plate_over_floor();
  scene.lights = LightSet();
  scene.lights.add_omni({0, 4, 0}, glm::vec3(1)); // a shadow 4/3 of the plate
  const SceneView view(scene);
  EXPECT_TRUE(view.may_occlude());
  int seen = 0, hidden = 0;
  for_each_point(view, [&](const VisiblePoint& p) {
    const glm::vec3& x = p.point.position();
    if (x.y > 0.01F) return;
    const float edge = std::max(std::abs(x.x), std::abs(x.z)) / (2.0F / 3);
    if (std::abs(edge - 1) < 1e-3F) return;
    EXPECT_EQ(view.sees(p, 0), edge > 1) << x.x << " " << x.z;
    ++(edge > 1 ? seen : hidden);
  });
  EXPECT_GT(seen, 10);
  EXPECT_GT(hidden, 10);
}

TEST(SceneView, CastsNothingWhereNothingCanOcclude) {
  const Scene open = plate_over_floor(false);
  const SceneView view(open);
  EXPECT_FALSE(view.may_occlude());
  for_each_point(view, [&](const VisiblePoint& p) { EXPECT_TRUE(view.sees(p, 0)); });
}

// From below; the shading normal leans so far that the light above the floor is before it.
TEST(SceneView, DoesNotSeeThroughAFloorOfSmoothNormals) {
  Scene scene = plate_over_floor(false);
  for (glm::vec3& n : scene.mesh.normals) n = glm::normalize(glm::vec3(3, -1, 0));
  scene.lights = LightSet();
  scene.lights.add_omni({5, 0.5F, 0}, glm::vec3(1));
  scene.camera = {{0, -2, 0.5F}, {0, 0, 0}, {0, 1, 0}, 60};
  const SceneView view(scene);
  int before_normal = 0;
  for_each_point(view, [&](const VisiblePoint& p) {
    if (transfer(p.point, scene.lights[0]) == glm::dvec3(0)) return;
    ++before_normal;
    EXPECT_FALSE(view.sees(p, 0));
  });
  EXPECT_GT(before_normal, 100);
}

/// The floor with a clamped texture of two texels, 0 at the left and (1, 2, 0.5) at the right,
/// their centres at x = -0.5 and 0.5.
Scene floor_with_a_ramp() {
  Scene scene = plate_over_floor();
  for (const glm::vec3& p : scene.mesh.positions)
    scene.mesh.uv.emplace_back((p.x + 1) / 2, (1 - p.z) / 2);
  scene.textures.emplace_back(glm::uvec2(2, 1), std::vector<glm::vec3>{glm::vec3(0), {1, 2, 0.5F}});
  scene.surfaces[0].texture = SurfaceTexture{0, {Wrap::clamp, Wrap::repeat}};
  return scene;
}

TEST(SceneView, MultipliesTheMaterialByItsTextureAtThePoint) {
  const Scene scene = floor_with_a_ramp();
  int floor = 0, plate = 0;
  for_each_point(SceneView(scene), [&](const VisiblePoint& p) {
    const glm::vec3& diffuse = p.point.material().diffuse;
    if (p.point.position().y > 0.5F) {
      EXPECT_EQ(diffuse, glm::vec3(0.75F));
      ++plate;
      return;
    }
    const glm::vec3 ramp =
        std::clamp(p.point.position().x + 0.5F, 0.0F, 1.0F) * glm::vec3(0.25F, 0.5F, 0.125F);
    EXPECT_LT(glm::length(diffuse - ramp), 1e-6F) << p.point.position().x;
    ++floor;
  });
  EXPECT_GT(floor, 100);
  EXPECT_GT(plate, 10);
}

TEST(SceneView, HasPointsInAllPixelsOfARoom) {
  const Scene scene = make_builtin("cloud?lights=1&blocks=0");
  const SceneView view(scene);
  for (const glm::uvec2 corner : {glm::uvec2(0), view.size() - 1U}) {
    const auto p = view.at(corner);
    ASSERT_TRUE(p);
    EXPECT_GT(glm::dot(p->point.normal(), scene.camera.position - p->point.position()), 0);
  }
}

} // namespace
} // namespace lightcuts
