// SPDX-License-Identifier: MIT
#include <lightcuts/render/scene/framing.h>

#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <lightcuts/render/scene/bounds.h>

namespace lightcuts {
namespace {

void add_face(TriangleMesh& mesh, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
              const glm::vec3& d, bool inwards) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const glm::vec3& p : {a, b, c, d}) mesh.positions.push_back(p);
  glm::uvec3 t(first, first + 1, first + 2), u(first, first + 2, first + 3);
  if (inwards) {
    std::swap(t.y, t.z);
    std::swap(u.y, u.z);
  }
  mesh.triangles.insert(mesh.triangles.end(), {t, u});
}

/// A box without the faces whose letters are in `open`: x and X for those of the least and the
/// largest x, and so on.
void add_box(TriangleMesh& mesh, const glm::vec3& lo, const glm::vec3& hi, bool inwards,
             const std::string& open = "") {
  for (int axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true}) {
      if (open.find("xyzXYZ"[axis + 3 * int(upper)]) != std::string::npos) continue;
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      const auto corner = [&](bool in_u, bool in_v) {
        glm::vec3 p;
        p[axis] = upper ? hi[axis] : lo[axis];
        p[u] = in_u ? hi[u] : lo[u];
        p[v] = in_v ? hi[v] : lo[v];
        return p;
      };
      if (upper)
        add_face(mesh, corner(false, false), corner(true, false), corner(true, true),
                 corner(false, true), inwards);
      else
        add_face(mesh, corner(false, false), corner(false, true), corner(true, true),
                 corner(true, false), inwards);
    }
}

void add_sphere(TriangleMesh& mesh, const glm::vec3& centre, float radius) {
  const auto at = [&](int i, int j) {
    const double phi = i * std::numbers::pi / 16, theta = j * std::numbers::pi / 16;
    return centre + radius * glm::vec3(glm::dvec3(std::sin(theta) * std::cos(phi), std::cos(theta),
                                                  -std::sin(theta) * std::sin(phi)));
  };
  for (int i = 0; i < 32; ++i)
    for (int j = 0; j < 16; ++j)
      add_face(mesh, at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j), false);
}

bool contains(const Box& box, const glm::vec3& p) {
  for (int i = 0; i < 3; ++i)
    if (p[i] <= box.lo[i] || p[i] >= box.hi[i]) return false;
  return true;
}

/// From the front, the right and above, by some angle each.
void expect_three_quarters(const TriangleMesh& mesh, const char* what) {
  const Camera camera = framing(mesh);
  const glm::vec3 from = glm::normalize(camera.position - camera.target);
  EXPECT_GT(from.x, 0.3F) << what;
  EXPECT_GT(from.y, 0.2F) << what;
  EXPECT_GT(from.z, 0.5F) << what;
  EXPECT_FALSE(contains(scene_bounds(mesh), camera.position)) << what;
}

TEST(Framing, shows_objects_from_the_front_and_above) {
  TriangleMesh sphere, cube, row, plate, cup;
  add_sphere(sphere, {0, 0, 0}, 1);
  add_box(cube, {0, 0, 0}, {1, 1, 1}, false);
  for (int i = 0; i < 9; ++i) add_sphere(row, {3 * float(i), 0, 0}, 1);
  add_face(plate, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}, {0, 0, 0}, false);
  // A wall of some thickness, seen from within as well.
  add_box(cup, {0, 0, 0}, {1, 1, 1}, false, "Y");
  add_box(cup, {0.1F, 0.1F, 0.1F}, {0.9F, 1, 0.9F}, true, "Y");
  expect_three_quarters(sphere, "sphere");
  expect_three_quarters(cube, "cube");
  expect_three_quarters(row, "row");
  expect_three_quarters(plate, "plate");
  expect_three_quarters(cup, "cup");
}

TEST(Framing, stands_within_a_closed_room) {
  TriangleMesh room;
  add_box(room, {0, 0, 0}, {6, 3, 4}, true);
  Camera camera = framing(room);
  EXPECT_TRUE(contains(scene_bounds(room), camera.position));
  add_box(room, {2, 0, 1}, {4, 2, 3}, false); // the middle is inside of something
  camera = framing(room);
  EXPECT_TRUE(contains(scene_bounds(room), camera.position));
}

TEST(Framing, looks_in_where_a_room_is_open) {
  for (const auto& [open, axis, sign] :
       {std::tuple{"Z", 2, 1}, {"z", 2, -1}, {"X", 0, 1}, {"x", 0, -1}}) {
    TriangleMesh room;
    add_box(room, {-1, -1, -1}, {1, 1, 1}, true, open);
    const glm::vec3 from = framing(room).position;
    EXPECT_GT(float(sign) * from[axis], 1) << open;
    for (int i = 0; i < 3; ++i)
      if (i != axis) {
        EXPECT_NEAR(from[i], 0, 1e-6) << open;
      }
  }
}

TEST(Framing, looks_over_no_wall_into_a_corner) {
  for (const auto& [open, x, z] : {std::tuple{"XZY", 1, 1}, {"xZY", -1, 1}, {"XzY", 1, -1}}) {
    TriangleMesh corner;
    add_box(corner, {-1, -1, -1}, {1, 1, 1}, true, open);
    const glm::vec3 from = framing(corner).position;
    EXPECT_GT(from.x * float(x), 0) << open;
    EXPECT_GT(from.z * float(z), 0) << open;
  }
}

TEST(Framing, takes_a_million_triangles) {
  TriangleMesh mesh;
  for (int i = 0; i < 1000; ++i)
    add_sphere(mesh, {float(i % 10), float(i / 100), float(i / 10 % 10)}, 0.4F);
  EXPECT_GT(mesh.triangles.size(), 1'000'000U);
  expect_three_quarters(mesh, "grid");
}

} // namespace
} // namespace lightcuts
