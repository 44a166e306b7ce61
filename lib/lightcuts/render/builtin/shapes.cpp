// SPDX-License-Identifier: MIT
#include <lightcuts/render/builtin/shapes.h>

#include <array>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace lightcuts {
namespace {

/// Points of the unit circle by bisection: square roots round alike everywhere, sine need not.
std::vector<glm::vec2> unit_circle(int segments) {
  std::vector<glm::vec2> points{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  while (static_cast<int>(points.size()) < segments) {
    std::vector<glm::vec2> finer;
    for (std::size_t i = 0; i < points.size(); ++i) {
      finer.push_back(points[i]);
      finer.push_back(glm::normalize(points[i] + points[(i + 1) % points.size()]));
    }
    points = std::move(finer);
  }
  return points;
}

} // namespace

void ShapeBuilder::use(const std::string& name, const Material& material,
                       const glm::vec3& emission) {
  scene_.surfaces.push_back({name, material, emission});
}

std::uint32_t ShapeBuilder::vertex(const glm::vec3& position, const glm::vec3& normal) {
  scene_.mesh.positions.push_back(placement_.point(position));
  scene_.mesh.normals.push_back(placement_.direction(normal));
  return static_cast<std::uint32_t>(scene_.mesh.positions.size() - 1);
}

void ShapeBuilder::triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  scene_.mesh.triangles.push_back({a, b, c});
  scene_.mesh.surface.push_back(static_cast<std::uint32_t>(scene_.surfaces.size() - 1));
}

void ShapeBuilder::quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                        const glm::vec3& d) {
  const glm::vec3 flat{0};
  const std::uint32_t first = vertex(a, flat);
  vertex(b, flat);
  vertex(c, flat);
  vertex(d, flat);
  triangle(first, first + 1, first + 2);
  triangle(first, first + 2, first + 3);
}

void ShapeBuilder::faces(const glm::vec3& lo, const glm::vec3& hi, bool with_bottom) {
  const auto corner = [&](int x, int y, int z) {
    return glm::vec3(x ? hi.x : lo.x, y ? hi.y : lo.y, z ? hi.z : lo.z);
  };
  const auto face = [&](std::array<int, 4> bits) {
    const auto at = [&](int i) {
      return corner(bits[i] & 1, (bits[i] >> 1) & 1, (bits[i] >> 2) & 1);
    };
    quad(at(0), at(1), at(2), at(3));
  };
  face({4, 5, 7, 6}); // +z
  face({1, 0, 2, 3}); // -z
  face({5, 1, 3, 7}); // +x
  face({0, 4, 6, 2}); // -x
  face({6, 7, 3, 2}); // +y
  if (with_bottom) face({0, 1, 5, 4});
}

void ShapeBuilder::disc(const glm::vec3& centre, float radius, int segments, float facing) {
  const std::uint32_t middle = vertex(centre, {0, 0, 0});
  for (const glm::vec2& p : unit_circle(segments))
    vertex(centre + glm::vec3(p.x * radius, 0, -facing * p.y * radius), {0, 0, 0});
  const auto n = static_cast<std::uint32_t>(segments);
  for (std::uint32_t i = 0; i < n; ++i) triangle(middle, middle + 1 + i, middle + 1 + (i + 1) % n);
}

void ShapeBuilder::cylinder(const glm::vec3& base, float bottom_radius, float top_radius,
                            float height, int segments, bool bottom_cap, bool top_cap) {
  const auto first = static_cast<std::uint32_t>(scene_.mesh.positions.size());
  for (const glm::vec2& p : unit_circle(segments)) {
    const glm::vec3 normal =
        glm::normalize(glm::vec3(p.x * height, bottom_radius - top_radius, -p.y * height));
    vertex(base + glm::vec3(p.x * bottom_radius, 0, -p.y * bottom_radius), normal);
    vertex(base + glm::vec3(p.x * top_radius, height, -p.y * top_radius), normal);
  }
  const auto n = static_cast<std::uint32_t>(segments);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = first + 2 * i, b = first + 2 * ((i + 1) % n);
    triangle(a, b, b + 1);
    triangle(a, b + 1, a + 1);
  }
  if (bottom_cap) disc(base, bottom_radius, segments, -1);
  if (top_cap) disc(base + glm::vec3(0, height, 0), top_radius, segments, 1);
}

/// Graph y = height(u, v) over a rectangle, u and v in [-1, 1]; height also returns its slopes.
template <class Height>
void ShapeBuilder::sheet(const glm::vec3& lo, const glm::vec3& hi, int cells, float facing,
                         const Height& height) {
  const auto first = static_cast<std::uint32_t>(scene_.mesh.positions.size());
  const glm::vec3 centre = 0.5F * (lo + hi), half = 0.5F * (hi - lo);
  for (int row = 0; row <= cells; ++row)
    for (int column = 0; column <= cells; ++column) {
      const float u = 2 * static_cast<float>(column) / static_cast<float>(cells) - 1;
      const float v = 2 * static_cast<float>(row) / static_cast<float>(cells) - 1;
      const glm::vec3 h = height(u, v); // value, d/du, d/dv
      vertex({centre.x + half.x * u, h.x, centre.z + half.z * v},
             glm::normalize(facing * glm::vec3(-h.y / half.x, 1, -h.z / half.z)));
    }
  const auto stride = static_cast<std::uint32_t>(cells + 1);
  for (std::uint32_t row = 0; row + 1 < stride; ++row)
    for (std::uint32_t column = 0; column + 1 < stride; ++column) {
      const std::uint32_t a = first + row * stride + column;
      const std::uint32_t b = facing > 0 ? a + stride : a + 1;
      const std::uint32_t d = facing > 0 ? a + 1 : a + stride;
      triangle(a, b, a + stride + 1);
      triangle(a, a + stride + 1, d);
    }
}

void ShapeBuilder::cushion(const glm::vec3& centre, const glm::vec3& half_size, int cells) {
  for (const float side : {1.0F, -1.0F})
    sheet(centre - half_size, centre + half_size, cells, side, [&](float u, float v) {
      const float a = 1 - u * u * u * u, b = 1 - v * v * v * v, s = side * half_size.y;
      return glm::vec3(centre.y + s * a * b, -4 * s * u * u * u * b, -4 * s * v * v * v * a);
    });
}

void ShapeBuilder::cloth(const glm::vec3& lo, const glm::vec3& hi, int cells) {
  sheet(lo, hi, cells, 1, [&](float u, float v) {
    // A product of two polynomials with three bumps along u and two along v, each in [0, 1].
    const float p = u * (4 * u * u - 3), dp = 12 * u * u - 3;                        // Chebyshev T3
    const float q = 8 * v * v * v * v - 8 * v * v + 1, dq = 32 * v * v * v - 16 * v; // T4
    const float s = 0.25F * (hi.y - lo.y);
    return glm::vec3(lo.y + s * (p * p + q * q) * 2, 4 * s * p * dp, 4 * s * q * dq);
  });
}

} // namespace lightcuts
