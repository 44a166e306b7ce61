// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/models/obj/polygon.h>

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace lightcuts {
namespace {

// More work than this, and the rest becomes a fan: some 10^4 corners of the worst kind.
constexpr std::uint64_t most_tests = 200'000'000;

double cross2(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// Newell's normal of the corners relative to the first, twice the area long.
glm::dvec3 mean_normal(std::span<const glm::vec3> corners) {
  glm::dvec3 sum(0);
  const glm::dvec3 origin(corners[0]);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += glm::cross(glm::dvec3(corners[i]) - origin, glm::dvec3(corners[i + 1]) - origin);
  return sum;
}

/// The corners seen along the normal, counter-clockwise: its largest component is left out.
std::vector<glm::dvec2> flattened(std::span<const glm::vec3> corners, const glm::dvec3& normal) {
  const glm::dvec3 size = glm::abs(normal);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  int u = (axis + 1) % 3, v = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(u, v);
  std::vector<glm::dvec2> result;
  result.reserve(corners.size());
  for (const glm::vec3& c : corners) result.emplace_back(c[u], c[v]);
  return result;
}

class EarCutting {
public:
  explicit EarCutting(std::vector<glm::dvec2> points) : points_(std::move(points)) {
    for (std::uint32_t i = 0; i < points_.size(); ++i) left_.push_back(i);
  }

  std::vector<glm::uvec3> cut() {
    std::size_t i = 0, misses = 0;
    while (left_.size() > 3 && misses < left_.size() && tests_ < most_tests) {
      const std::size_t n = left_.size();
      i %= n;
      const std::size_t before = (i + n - 1) % n, after = (i + 1) % n;
      if (!is_ear(left_[before], left_[i], left_[after])) {
        ++i;
        ++misses;
        continue;
      }
      triangles_.emplace_back(left_[before], left_[i], left_[after]);
      left_.erase(left_.begin() + std::ptrdiff_t(i));
      misses = 0;
    }
    for (std::size_t k = 1; k + 1 < left_.size(); ++k)
      triangles_.emplace_back(left_[0], left_[k], left_[k + 1]);
    return std::move(triangles_);
  }

private:
  bool is_ear(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const glm::dvec2 &p = points_[a], &q = points_[b], &r = points_[c];
    if (!(cross2(q - p, r - q) > 0)) return false;
    for (const std::uint32_t k : left_) {
      ++tests_;
      const glm::dvec2& x = points_[k];
      if (k == a || k == b || k == c || x == p || x == q || x == r) continue;
      if (cross2(q - p, x - p) >= 0 && cross2(r - q, x - q) >= 0 && cross2(p - r, x - r) >= 0)
        return false;
    }
    return true;
  }

  std::vector<glm::dvec2> points_;
  std::vector<std::uint32_t> left_;
  std::vector<glm::uvec3> triangles_;
  std::uint64_t tests_ = 0;
};

/// No corner turns the other way, and once around in all: the turns of a star would be more.
bool is_convex(const std::vector<glm::dvec2>& points) {
  const std::size_t n = points.size();
  double turned = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec2 a = points[(i + 1) % n] - points[i];
    const glm::dvec2 b = points[(i + 2) % n] - points[(i + 1) % n];
    if (cross2(a, b) < 0) return false;
    turned += std::atan2(cross2(a, b), glm::dot(a, b));
  }
  return turned < 7; // 2 pi or 4 pi
}

} // namespace

std::vector<glm::uvec3> triangulate(std::span<const glm::vec3> corners) {
  std::vector<glm::uvec3> fan;
  for (std::uint32_t i = 1; i + 1 < corners.size(); ++i) fan.emplace_back(0, i, i + 1);
  if (corners.size() == 3) return fan;
  std::vector<glm::dvec2> points = flattened(corners, mean_normal(corners));
  if (is_convex(points)) return fan;
  return EarCutting(std::move(points)).cut();
}

} // namespace lightcuts
