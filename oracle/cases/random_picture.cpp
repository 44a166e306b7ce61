// SPDX-License-Identifier: MIT
#include <oracle/cases/random_picture.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <oracle/cases/random_case.h>

namespace lightcuts::oracle {
namespace {

using gen::Dice;

void add_triangle(Case& c, const glm::vec3& p, const glm::vec3& q, const glm::vec3& r) {
  c.triangles.push_back({p, q, r, 0});
}

void add_quad(Case& c, const glm::vec3& corner, const glm::vec3& a, const glm::vec3& b) {
  add_triangle(c, corner, corner + a, corner + a + b);
  add_triangle(c, corner, corner + a + b, corner + b);
}

/// Seen from above.
Case things_over_a_floor(Dice& dice, float unit) {
  Case c;
  const int blockers = dice.between(0, 4);
  for (int i = 0; i < blockers; ++i) {
    const glm::vec3 corner =
        unit * glm::vec3(dice.uniform(-2, 1), dice.uniform(0.5, 2), dice.uniform(-2, 1));
    const bool upright = dice.one_in(3);
    add_quad(c, corner, unit * glm::vec3(1, 0, 0),
             unit * (upright ? glm::vec3(0, 0.5F, 0) : glm::vec3(0, 0, -1)));
  }
  const auto floor = 2 * std::ptrdiff_t(dice.below(blockers + 1));
  Case ground;
  add_quad(ground, unit * glm::vec3(-4, 0, 4), unit * glm::vec3(8, 0, 0),
           unit * glm::vec3(0, 0, -8));
  c.triangles.insert(c.triangles.begin() + floor, ground.triangles.begin(), ground.triangles.end());
  for (std::size_t i = 0; i < c.triangles.size(); ++i) c.triangles[i].mesh = std::uint32_t(i / 2);
  const int lights = dice.between(1, 6);
  for (int i = 0; i < lights; ++i) {
    Light light;
    light.position =
        unit * glm::vec3(dice.uniform(-3, 3), dice.uniform(0.25, 3), dice.uniform(-3, 3));
    light.intensity = glm::vec3(unit * unit * float(dice.uniform(0.5, 2)));
    c.lights.push_back(light);
  }
  c.cut = random_cut(dice, lights);
  c.camera = {unit * glm::vec3(0.25F, 6, 1), glm::vec3(0), {0, 1, 0}, 50};
  c.image_size = {dice.between(2, 6), dice.between(2, 6)};
  return c;
}

/// Points of a block on a floor, seen from above, clusters of lights, and what may lie between.
class Shadows {
public:
  Shadows(Dice& dice, float unit) : dice_(dice), unit_(unit) {
    tilt_ = dice_.one_in(3) ? float(dice_.uniform(-0.5, 0.5)) : 0;
    spot_ = on_floor(float(dice_.uniform(-1, 1)), float(dice_.uniform(-1, 1)));
    size_ = float(dice_.pick({1e-3, 0.02, 0.1, 0.4}));
    add_floor();
    add_lights();
    const int blockers = dice_.pick({1, 2, 5, 20});
    for (int i = 0; i < blockers; ++i) add_blocker();
    if (dice_.one_in(4)) add_box();
    if (dice_.one_in(3)) made.triangles.push_back(made.triangles.back());
    const double half = std::atan(double(size_) / height);
    made.camera = {unit_ * (spot_ + glm::vec3(0, height, 0)),
                   unit_ * spot_,
                   {0, 0, 1},
                   float(half * 2 * 180 / 3.14159265358979)};
    made.image_size = {4, 4};
    made.cut = random_cut(dice_, int(made.lights.size()));
  }
  Case made;

private:
  static constexpr float height = 2.5F;

  void add(const glm::vec3& p, const glm::vec3& q, const glm::vec3& r) {
    add_triangle(made, unit_ * p, unit_ * q, unit_ * r);
  }
  void add_sides(const glm::vec3& corner, const glm::vec3& a, const glm::vec3& b) {
    add_quad(made, unit_ * corner, unit_ * a, unit_ * b);
  }
  [[nodiscard]] glm::vec3 on_floor(float x, float z) const { return {x, tilt_ * x, z}; }
  void add_floor() {
    const int cells = dice_.pick({1, 1, 3, 12});
    const float side = 4.0F / float(cells);
    for (int i = 0; i < cells; ++i)
      for (int k = 0; k < cells; ++k)
        add_sides(on_floor(side * float(i) - 2, side * float(k) - 2), on_floor(side, 0),
                  on_floor(0, side));
  }
  void add_lights() {
    const auto wide = float(dice_.pick({0.0, 0.05, 0.3, 1.0}));
    const bool flat = dice_.one_in(3);
    const glm::vec3 at =
        spot_ + glm::vec3(dice_.uniform(-1.5, 1.5), dice_.pick({1e-3, 0.2, 1.0, 2.0}),
                          dice_.uniform(-1.5, 1.5));
    const int count = dice_.pick({1, 4, 24, 24});
    for (int i = 0; i < count; ++i) {
      glm::vec3 position = at + wide * dice_.in_cube();
      if (flat) position.y = at.y;
      position.y = std::max(position.y, tilt_ * position.x);
      Light light;
      light.position = unit_ * position;
      light.intensity = glm::vec3(unit_ * unit_);
      made.lights.push_back(light);
    }
    if (flat && dice_.one_in(2)) // on a lamp
      add_sides(at - glm::vec3(1, 0, 1), {2, 0, 0}, {0, 0, 2});
  }
  glm::vec3 a_point() {
    return on_floor(spot_.x + float(dice_.uniform(-size_, size_)),
                    spot_.z + float(dice_.uniform(-size_, size_)));
  }
  glm::vec3 a_light() {
    const int i = dice_.below(int(made.lights.size()));
    return made.lights[std::size_t(i)].position / unit_;
  }
  void add_blocker() {
    const glm::vec3 from = a_point(), way = a_light() - from;
    const auto wide = float(dice_.pick({0.01, 0.1, 0.5, 2.0}));
    const glm::vec3 p = from + float(dice_.uniform(-0.1, 1.1)) * way +
                        wide * float(dice_.pick({0.0, 0.5, 2.0})) * dice_.in_cube();
    const glm::vec3 a = wide * dice_.in_cube(), b = wide * dice_.in_cube();
    switch (dice_.below(6)) {
    case 0: // a needle
      add(p, p + a, p + a * 0.5F + b * float(dice_.pick({1e-2, 1e-4, 1e-6})));
      return;
    case 1: // edge-on
      add(p + a, p + a + way * float(dice_.uniform(0.1, 2)), from);
      return;
    case 2: // edge-on and elsewhere
      add(from + 2.0F * a, from + 2.0F * a + way * 0.3F, from + 3.0F * a);
      return;
    case 3:
      add_plane(dice_.one_in(2) ? from : from + way, p, wide);
      return;
    case 4: // a large one that covers much
      add_sides(p - a - b, 2.0F * a, 2.0F * b);
      return;
    default:
      add(p, p + a, p + b);
    }
  }
  /// Along two axes, through `through`, near p.
  void add_plane(const glm::vec3& through, glm::vec3 p, float wide) {
    const int axis = dice_.below(3);
    p[axis] = through[axis];
    glm::vec3 a(0), b(0);
    a[(axis + 1) % 3] = wide;
    b[(axis + 2) % 3] = wide;
    add_sides(p, a, b);
  }
  /// Around everything.
  void add_box() {
    constexpr float half = 4;
    for (int axis = 0; axis < 3; ++axis)
      for (const float side : {-half, half}) {
        glm::vec3 p(-half), a(0), b(0);
        p[axis] = side;
        a[(axis + 1) % 3] = 2 * half;
        b[(axis + 2) % 3] = 2 * half;
        add_sides(p, a, b);
      }
  }

  Dice& dice_;
  float unit_, tilt_ = 0, size_ = 0;
  glm::vec3 spot_{0}; ///< in the middle of the points
};

} // namespace

Case picture_case(Dice& dice) {
  const float unit = dice.pick({1.0F, 1.0F, 0x1p-60F, 0x1p10F});
  Dice aside = dice.aside();
  Case c = aside.one_in(3) ? things_over_a_floor(dice, unit) : Shadows(aside, unit).made;
  c.views.push_back({{}, {}});
  c.views[0].view.material = {glm::vec3(0.5F), {}};
  return c;
}

} // namespace lightcuts::oracle
