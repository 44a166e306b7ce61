// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include <glm/vec3.hpp>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// Where a piece of furniture stands and which way it faces: a rotation about +y, then a shift.
struct Placement {
  glm::vec3 origin{0};        ///< metres
  float cosine = 1, sine = 0; ///< of the angle that turns +z towards +x

  [[nodiscard]] glm::vec3 point(const glm::vec3& p) const { return origin + direction(p); }
  [[nodiscard]] glm::vec3 direction(const glm::vec3& d) const {
    return {cosine * d.x + sine * d.z, d.y, cosine * d.z - sine * d.x};
  }
};

/// Adds simple shapes to a scene. Triangles are counter-clockwise seen from outside the solid.
class ShapeBuilder {
public:
  explicit ShapeBuilder(Scene& scene) : scene_(scene) {}

  /// Adds a surface; shapes that follow are made of it.
  void use(const std::string& name, const Material& material,
           const glm::vec3& emission = {0, 0, 0});

  /// Shapes that follow are placed so; `Placement{}` undoes it.
  void place(const Placement& placement) { placement_ = placement; }

  /// Flat quadrilateral, counter-clockwise seen from outside.
  void quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d);

  /// Box whose faces look outwards.
  void box(const glm::vec3& lo, const glm::vec3& hi) { faces(lo, hi, true); }

  /// Box without its bottom, for what stands on a floor: no two faces coincide.
  void standing_box(const glm::vec3& lo, const glm::vec3& hi) { faces(lo, hi, false); }

  /// Upright cylinder or cone stump with smooth sides and, where asked for, flat caps. `segments`
  /// is 4 times a power of two.
  void cylinder(const glm::vec3& base, float bottom_radius, float top_radius, float height,
                int segments, bool bottom_cap = true, bool top_cap = true);

  /// Cushion: lens of the given half-size, smooth, `cells` x `cells` quadrilaterals per side.
  void cushion(const glm::vec3& centre, const glm::vec3& half_size, int cells);

  /// Cloth that lies in y = lo.y with soft bumps up to hi.y, smooth, `cells` x `cells`.
  void cloth(const glm::vec3& lo, const glm::vec3& hi, int cells);

private:
  std::uint32_t vertex(const glm::vec3& position, const glm::vec3& normal);
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void faces(const glm::vec3& lo, const glm::vec3& hi, bool with_bottom);
  void disc(const glm::vec3& centre, float radius, int segments, float facing);
  template <class Height>
  void sheet(const glm::vec3& lo, const glm::vec3& hi, int cells, float facing,
             const Height& height);

  Scene& scene_;
  Placement placement_;
};

} // namespace lightcuts
