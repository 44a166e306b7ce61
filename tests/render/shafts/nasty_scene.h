// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/tree/tree_builder.h>
#include <lightcuts/render/view/occluder.h>
#include <lightcuts/render/view/surface_point.h>
#include <oracle/numbers/dice.h>

namespace lightcuts {

/// A few triangles, points on one of them, and lights: needles, planes through the points or the
/// lights, coincident triangles, closed boxes, lights on surfaces, tessellated floors.
struct NastyScene {
  TriangleMesh mesh;
  std::vector<glm::vec3> origins; ///< of shadow rays
  LightSet lights;

  explicit NastyScene(std::uint64_t seed) : dice_(seed) {
    add_floor();
    const glm::vec3 spot(dice_.uniform(-1, 1), 0, dice_.uniform(-1, 1));
    lights_at_ = spot + glm::vec3(dice_.uniform(-1.5, 1.5), dice_.pick({1e-3, 0.2, 1.0, 2.0}),
                                  dice_.uniform(-1.5, 1.5));
    add_points(spot);
    add_lights();
    const int count = dice_.pick({1, 2, 5, 20});
    for (int i = 0; i < count; ++i) add_blocker();
    if (dice_.one_in(4)) add_box();
    if (dice_.one_in(3)) mesh.triangles.push_back(mesh.triangles.back());
  }

private:
  void add(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const auto first = std::uint32_t(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {a, b, c});
    mesh.triangles.emplace_back(first, first + 1, first + 2);
  }
  void add_quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
    add(a, b, c);
    add(a, c, d);
  }
  void add_floor() {
    const int cells = dice_.pick({1, 1, 3, 12});
    tilt_ = dice_.one_in(3) ? float(dice_.uniform(-0.5, 0.5)) : 0;
    const auto at = [&](int i, int k) {
      const float x = -2 + 4 * float(i) / float(cells), z = -2 + 4 * float(k) / float(cells);
      return glm::vec3(x, tilt_ * x, z);
    };
    for (int i = 0; i < cells; ++i)
      for (int k = 0; k < cells; ++k)
        add_quad(at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1));
  }
  void add_points(const glm::vec3& spot) {
    const Occluder floor(mesh);
    const double size = dice_.pick({1e-3, 0.02, 0.1, 0.4});
    while (origins.size() < 16) {
      const glm::vec3 from(spot.x + dice_.uniform(-size, size), 3,
                           spot.z + dice_.uniform(-size, size));
      if (const auto hit = floor.intersect(from, {0, -1, 0}))
        origins.push_back(surface_point(mesh, *hit, {0, -1, 0}).ray_origin);
    }
  }
  void add_lights() {
    const double size = dice_.pick({0.0, 0.05, 0.3, 1.0});
    const bool flat = dice_.one_in(3);
    const int count = dice_.pick({1, 4, 40});
    for (int i = 0; i < count; ++i) {
      glm::vec3 at = lights_at_ + float(size) * dice_.in_cube();
      if (flat) at.y = lights_at_.y;
      at.y = std::max(at.y, tilt_ * at.x);
      lights.add_omni(at, glm::vec3(1));
    }
    if (flat && dice_.one_in(2)) // on a lamp
      add_quad(lights_at_ + glm::vec3(-1, 0, -1), lights_at_ + glm::vec3(1, 0, -1),
               lights_at_ + glm::vec3(1, 0, 1), lights_at_ + glm::vec3(-1, 0, 1));
  }
  glm::vec3 an_origin() { return origins[std::size_t(dice_.below(int(origins.size())))]; }
  glm::vec3 a_light() { return lights[std::size_t(dice_.below(int(lights.size())))].position; }
  glm::vec3 between() {
    const glm::vec3 a = an_origin();
    return a + float(dice_.uniform(-0.1, 1.1)) * (a_light() - a);
  }
  void add_blocker() {
    const float size = float(dice_.pick({0.01, 0.1, 0.5, 2.0}));
    const glm::vec3 p = between() + size * float(dice_.pick({0.0, 0.5, 2.0})) * dice_.in_cube();
    const glm::vec3 a = size * dice_.in_cube(), b = size * dice_.in_cube();
    switch (dice_.below(6)) {
    case 0: // a needle
      add(p, p + a, p + a * 0.5F + b * float(dice_.pick({1e-2, 1e-4, 1e-6})));
      return;
    case 1: // edge-on
      add(p + a, p + a + (a_light() - an_origin()) * float(dice_.uniform(0.1, 2)), an_origin());
      return;
    case 2: { // edge-on and elsewhere
      const glm::vec3 way = a_light() - an_origin(), o = an_origin();
      const glm::vec3 q = o + 2.0F * a;
      add(q, q + way * 0.3F, q + 0.5F * (q - o));
      return;
    }
    case 3: // an axis-aligned plane through a point or a light
      p_in_plane(p, size);
      return;
    case 4: // a large one that covers much
      add_quad(p - a - b, p + a - b, p + a + b, p - a + b);
      return;
    default:
      add(p, p + a, p + b);
    }
  }
  void p_in_plane(glm::vec3 p, float size) {
    const int axis = dice_.below(3);
    p[axis] = (dice_.one_in(2) ? an_origin() : a_light())[axis];
    glm::vec3 a(0), b(0);
    a[(axis + 1) % 3] = size;
    b[(axis + 2) % 3] = size;
    add_quad(p, p + a, p + a + b, p + b);
  }
  void add_box() {
    const glm::vec3 lo(-3), hi(3);
    for (int axis = 0; axis < 3; ++axis)
      for (const float side : {lo.x, hi.x}) {
        glm::vec3 p(lo), a(0), b(0);
        p[axis] = side;
        a[(axis + 1) % 3] = 6;
        b[(axis + 2) % 3] = 6;
        add_quad(p, p + a, p + a + b, p + b);
      }
  }

  gen::Dice dice_;
  glm::vec3 lights_at_{0};
  float tilt_ = 0;
};

} // namespace lightcuts
