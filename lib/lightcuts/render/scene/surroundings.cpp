// SPDX-License-Identifier: MIT
#include <lightcuts/render/scene/surroundings.h>

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace lightcuts {
namespace {

constexpr double small = 0.1;              // radians; a square has 0.25 in the middle of a side
constexpr std::size_t most_large = 100000; // 0.2 s; more count as small

/// The middle of square i on the cube's surface, one component 1 or -1.
glm::dvec3 on_cube(std::size_t i) {
  constexpr std::size_t n = Surroundings::squares;
  const std::size_t side = i / (n * n);
  const int axis = static_cast<int>(side / 2);
  glm::dvec3 p(0);
  p[axis] = side % 2 == 0 ? 1 : -1;
  p[(axis + 1) % 3] = (double(i / n % n) + 0.5) * 2 / n - 1;
  p[(axis + 2) % 3] = (double(i % n) + 0.5) * 2 / n - 1;
  return p;
}

/// The square that a direction, not 0, goes through.
std::size_t square_of(const glm::dvec3& d) {
  constexpr int n = Surroundings::squares;
  const glm::dvec3 size = glm::abs(d);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto place = [&](int other) {
    return std::clamp(int((d[other] / size[axis] + 1) * n / 2), 0, n - 1);
  };
  const int side = 2 * axis + (d[axis] > 0 ? 0 : 1);
  return std::size_t((side * n + place((axis + 1) % 3)) * n + place((axis + 2) % 3));
}

} // namespace

Surroundings::Surroundings(const TriangleMesh& mesh, const glm::dvec3& from)
    : from_(from), looks_(count, {INFINITY, false}) {
  std::size_t large = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a = glm::dvec3(mesh.positions[t.x]) - from,
                     b = glm::dvec3(mesh.positions[t.y]) - from,
                     c = glm::dvec3(mesh.positions[t.z]) - from;
    const glm::dvec3 centre = (a + b + c) / 3.0;
    const auto off = [&](const glm::dvec3& p) { return glm::dot(p - centre, p - centre); };
    const double radius2 = std::max({off(a), off(b), off(c)});
    if (radius2 < small * small * glm::dot(centre, centre) || ++large > most_large)
      add_small(a, b, c);
    else
      add_large(a, b, c);
  }
}

glm::dvec3 Surroundings::direction(std::size_t i) { return glm::normalize(on_cube(i)); }

double Surroundings::share(std::size_t i) {
  static const double all = [] {
    double sum = 0;
    for (std::size_t k = 0; k < count; ++k) sum += std::pow(glm::length(on_cube(k)), -3);
    return sum;
  }();
  return std::pow(glm::length(on_cube(i)), -3) / all;
}

void Surroundings::put(std::size_t i, double distance, bool front) {
  if (distance < looks_[i].distance) looks_[i] = {distance, front};
}

void Surroundings::add_small(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 centre = (a + b + c) / 3.0;
  if (centre == glm::dvec3(0)) return;
  put(square_of(centre), glm::length(centre), glm::dot(glm::cross(b - a, c - a), centre) < 0);
}

/// Moeller and Trumbore 1997, from the origin.
void Surroundings::add_large(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 q = glm::cross(-a, b - a);
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 d = direction(i);
    const glm::dvec3 p = glm::cross(d, c - a);
    const double determinant = glm::dot(b - a, p);
    if (determinant == 0) continue;
    const double u = glm::dot(-a, p) / determinant, v = glm::dot(d, q) / determinant;
    const double t = glm::dot(c - a, q) / determinant;
    if (u >= 0 && v >= 0 && u + v <= 1 && t > 0) put(i, t, determinant > 0);
  }
}

} // namespace lightcuts
