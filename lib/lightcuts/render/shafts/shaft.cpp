// SPDX-License-Identifier: MIT
#include <lightcuts/render/shafts/shaft.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include <glm/geometric.hpp>

namespace lightcuts {
namespace {

/// The corner of the box that is farthest in the direction that signs give.
glm::dvec3 corner_towards(const Box& box, const glm::dvec3& signs) {
  glm::dvec3 corner;
  for (int k = 0; k < 3; ++k) corner[k] = signs[k] > 0 ? box.hi[k] : box.lo[k];
  return corner;
}

} // namespace

Shaft::Shaft(const Box& from, const Box& to) : around_(from) {
  around_.extend(to);
  for (int axis = 0; axis < 3; ++axis) { // to which the side is parallel
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    for (const double sign_a : {-1.0, 1.0})
      for (const double sign_b : {-1.0, 1.0}) {
        glm::dvec3 signs(0);
        signs[a] = sign_a;
        signs[b] = sign_b;
        const glm::dvec3 start = corner_towards(from, signs);
        const glm::dvec3 way = corner_towards(to, signs) - start;
        // The normal of the line through both corners has these signs, or it is no side.
        if (!(sign_a * way[a] * (sign_b * way[b]) < 0)) continue;
        glm::dvec3 normal(0);
        normal[a] = sign_a * std::abs(way[b]);
        normal[b] = sign_b * std::abs(way[a]);
        normal = glm::normalize(normal);
        sides_[std::size_t(side_count_++)] = {normal, glm::dot(normal, start)};
      }
  }
}

double Shaft::separation(const Box& box) const {
  double most = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k)
    most = std::max({most, double(box.lo[k]) - double(around_.hi[k]),
                     double(around_.lo[k]) - double(box.hi[k])});
  for (const Side& side : std::span(sides_).first(std::size_t(side_count_)))
    most = std::max(most, glm::dot(side.normal, corner_towards(box, -side.normal)) - side.offset);
  return most;
}

double Shaft::separation(const FlatTriangle& triangle) const {
  const auto& [a, b, c] = triangle.corners;
  double most = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k)
    most = std::max({most, std::min({a[k], b[k], c[k]}) - double(around_.hi[k]),
                     double(around_.lo[k]) - std::max({a[k], b[k], c[k]})});
  for (const Side& side : std::span(sides_).first(std::size_t(side_count_)))
    most = std::max(most, std::min({glm::dot(side.normal, a), glm::dot(side.normal, b),
                                    glm::dot(side.normal, c)}) -
                              side.offset);
  return most;
}

} // namespace lightcuts
