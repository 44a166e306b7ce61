// SPDX-License-Identifier: MIT
#include <lightcuts/render/scene/convexity.h>

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <lightcuts/render/builtin/shapes.h>

namespace lightcuts {
namespace {

const glm::vec3 eye(0.5F, 0.5F, 0.5F);

/// A room of 4 m x 2 m x 4 m about the origin, seen from within.
Scene room() {
  Scene scene;
  ShapeBuilder builder(scene);
  builder.use("wall", {glm::vec3(0.5F)});
  builder.box({-2, -1, -2}, {2, 1, 2});
  return scene;
}

LightSet lights_at(std::initializer_list<glm::vec3> positions) {
  LightSet lights;
  for (const glm::vec3& p : positions) lights.add_omni(p, glm::vec3(1));
  return lights;
}

const LightSet inside = lights_at({{-1, 0.5F, 1}, {1.5F, -0.5F, 0}});

template <class Change>
TriangleMesh changed(TriangleMesh mesh, Change&& change) {
  for (glm::vec3& p : mesh.positions) p = change(p);
  return mesh;
}

TEST(Convexity, ARoomWithLightsInsideIsConvex) {
  EXPECT_TRUE(encloses_lights_convexly(room().mesh, inside, eye));
}

TEST(Convexity, DoesNotDependOnWhichWayTrianglesWind) {
  Scene scene = room();
  for (std::size_t i = 0; i < scene.mesh.triangles.size(); i += 2)
    std::swap(scene.mesh.triangles[i].x, scene.mesh.triangles[i].y);
  EXPECT_TRUE(encloses_lights_convexly(scene.mesh, inside, eye));
}

TEST(Convexity, AFloorUnderLightsIsConvex) {
  Scene scene;
  ShapeBuilder builder(scene);
  builder.use("floor", {glm::vec3(0.5F)});
  builder.quad({-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1});
  EXPECT_TRUE(encloses_lights_convexly(scene.mesh, lights_at({{5, 1, 0}}), eye));
  EXPECT_FALSE(encloses_lights_convexly(scene.mesh, lights_at({{5, 1, 0}, {0, -1, 0}}), eye));
}

TEST(Convexity, ARoomWithABlockIsNot) {
  Scene scene = room();
  ShapeBuilder(scene).standing_box({-0.1F, -1, -0.1F}, {0.1F, -0.9F, 0.1F});
  EXPECT_FALSE(encloses_lights_convexly(scene.mesh, inside, eye));
}

TEST(Convexity, AnLShapedRoomIsNot) {
  Scene scene;
  ShapeBuilder builder(scene);
  builder.use("wall", {glm::vec3(0.5F)});
  builder.quad({0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0});
  builder.quad({0, 0, 1}, {-1, 0, 1}, {-1, 1, 1}, {0, 1, 1});
  builder.quad({-1, 0, 1}, {-1, 0, 2}, {-1, 1, 2}, {-1, 1, 1});
  EXPECT_FALSE(encloses_lights_convexly(scene.mesh, lights_at({{2, 0.5F, 1.5F}}), {1, 0.5F, 0.5F}));
}

TEST(Convexity, LightsOutsideAreSeparatedByTheWall) {
  EXPECT_FALSE(encloses_lights_convexly(room().mesh, lights_at({{0, 0, 0}, {0, 3, 0}}), eye));
  EXPECT_FALSE(encloses_lights_convexly(room().mesh, lights_at({{0, 1.0001F, 0}}), eye));
}

TEST(Convexity, LightsOnAWallCountAsInside) {
  EXPECT_TRUE(encloses_lights_convexly(room().mesh, lights_at({{0, 1, 0}, {2, 1, 2}}), eye));
}

// From there, a smooth normal may see lights through the wall.
TEST(Convexity, AnEyeOutsideIsSeparatedByTheWall) {
  EXPECT_FALSE(encloses_lights_convexly(room().mesh, inside, {0, 3, 0}));
}

TEST(Convexity, ARoomScaledAndMovedByRoundNumbersIsConvex) {
  for (const float scale : {0x1p-100F, 1e-3F, 1024.0F, 0x1p60F})
    for (const float shift : {0.0F, 8.0F}) {
      const auto move = [&](const glm::vec3& p) { return scale * (p + shift); };
      LightSet lights;
      for (const Light& l : inside) lights.add_omni(move(l.position), l.intensity);
      EXPECT_TRUE(encloses_lights_convexly(changed(room().mesh, move), lights, move(eye)))
          << scale << " " << shift;
    }
}

// By angles whose cosine and sine are 3/5 and 4/5, times 5, so that floats are exact.
glm::vec3 tilted(const glm::vec3& p) {
  const glm::vec3 q(3 * p.x - 4 * p.y, 4 * p.x + 3 * p.y, 5 * p.z);
  return {3 * q.x - 4 * q.z, 5 * q.y, 4 * q.x + 3 * q.z};
}

TEST(Convexity, ATiltedRoomIsConvex) {
  // One place: the box around several lights would stick out of the tilted room.
  EXPECT_TRUE(encloses_lights_convexly(changed(room().mesh, tilted), lights_at({tilted(eye)}),
                                       tilted(eye)));
}

// A corner one ulp off folds walls along their diagonals, outwards at best.
TEST(Convexity, TellsARoomThatIsBentByOneUlp) {
  int convex = 0;
  for (const float towards : {-100.0F, 100.0F}) {
    const TriangleMesh bent = changed(room().mesh, [=](const glm::vec3& p) {
      glm::vec3 q = tilted(p);
      if (p == glm::vec3(2, 1, 2)) q.y = std::nextafter(q.y, towards);
      return q;
    });
    convex += encloses_lights_convexly(bent, lights_at({tilted(eye)}), tilted(eye)) ? 1 : 0;
  }
  EXPECT_LT(convex, 2);
}

TEST(Convexity, TrianglesWithoutAreaSeparateNothing) {
  Scene scene = room();
  const auto first = static_cast<std::uint32_t>(scene.mesh.positions.size());
  scene.mesh.positions.insert(scene.mesh.positions.end(), 3, glm::vec3(0));
  scene.mesh.positions.back().x = 1;
  scene.mesh.triangles.emplace_back(first, first + 1, first + 2);
  EXPECT_TRUE(encloses_lights_convexly(scene.mesh, inside, eye));
}

TEST(Convexity, ARoomWithoutLightsIsConvex) {
  EXPECT_TRUE(encloses_lights_convexly(room().mesh, LightSet(), eye));
}

TEST(Convexity, IsNotLookedForInLargeMeshes) {
  Scene scene = room();
  while (scene.mesh.triangles.size() <= 10000)
    scene.mesh.triangles.push_back(scene.mesh.triangles.front());
  EXPECT_FALSE(encloses_lights_convexly(scene.mesh, inside, eye));
}

} // namespace
} // namespace lightcuts
