// SPDX-License-Identifier: MIT
#include <lightcuts/render/scene/framing.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <lightcuts/render/scene/bounds.h>
#include <lightcuts/render/scene/surroundings.h>

namespace lightcuts {
namespace {

// Shares of what is seen from the middle. A room without one of its walls has 5/6.
constexpr double closed = 0.9, open_to_one_side = 0.7;
constexpr double walls_show_fronts = 0.7; // of what is seen: from within an object backs are
constexpr glm::dvec3 reach_of_walls(0.7, 0.5,
                                    0.7); // of the mesh's box; less may be seen of the floor
constexpr double clearly_freer = 0.2;     // more of a view's directions
constexpr double within_fov = 60;         // degrees
constexpr std::size_t most_looked_at_often = 1'000'000; // triangles

constexpr std::array<glm::dvec3, 4> sides{
    {{0, 0, 1}, {1, 0, 0}, {-1, 0, 0}, {0, 0, -1}}}; // the front first

glm::dvec3 centre_of(const Box& box) { return 0.5 * (glm::dvec3(box.lo) + glm::dvec3(box.hi)); }

/// What the surroundings tell of a mesh as a room.
struct Room {
  double seen = 0;   ///< share of directions in which anything is
  double fronts = 0; ///< share of those in which it shows its front
  glm::dvec3 extent{0};
  std::array<double, 4> open{}; ///< share of the directions without anything that leaves by each of
                                ///< the sides

  Room(const Surroundings& around, const Box& box) {
    glm::dvec3 lo(INFINITY), hi(-INFINITY);
    const glm::dvec3 half = 0.5 * (glm::dvec3(box.hi) - glm::dvec3(box.lo));
    for (std::size_t i = 0; i < Surroundings::count; ++i) {
      const glm::dvec3 d = Surroundings::direction(i);
      const double share = Surroundings::share(i);
      if (std::isinf(around.distance(i))) {
        for (std::size_t s = 0; s < sides.size(); ++s)
          if (leaves_by(d, half, sides[s])) open[s] += share;
        continue;
      }
      seen += share;
      if (around.sees_front(i)) fronts += share;
      lo = glm::min(lo, d * around.distance(i));
      hi = glm::max(hi, d * around.distance(i));
    }
    extent = hi - lo;
    if (seen > 0) fronts /= seen;
    for (double& o : open) o /= std::max(1 - seen, 1e-9);
  }

  [[nodiscard]] bool has_walls(const Box& box) const {
    const glm::dvec3 size = glm::dvec3(box.hi) - glm::dvec3(box.lo);
    return fronts >= walls_show_fronts && glm::all(glm::greaterThan(extent, reach_of_walls * size));
  }

private:
  /// Whether a ray from the middle leaves the box by that side.
  static bool leaves_by(const glm::dvec3& d, const glm::dvec3& half, const glm::dvec3& side) {
    const glm::dvec3 steps = glm::abs(d) / glm::max(half, glm::dvec3(1e-300));
    const double along = glm::dot(d, side);
    return along > 0 && glm::dot(steps, glm::abs(side)) >= std::max({steps.x, steps.y, steps.z});
  }
};

/// The whole box in view, with a little air.
Camera from_outside(const Box& box, const glm::dvec3& direction) {
  const glm::dvec3 forward = glm::normalize(direction);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
  const glm::dvec3 up = glm::cross(right, forward), centre = centre_of(box);
  constexpr double tangent = 0.41421356237309505; // of half of 45 degrees
  constexpr double aspect = 4.0 / 3, air = 1.05;
  double distance = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p =
        glm::dvec3(corner & 1 ? box.hi.x : box.lo.x, corner & 2 ? box.hi.y : box.lo.y,
                   corner & 4 ? box.hi.z : box.lo.z) -
        centre;
    const double reach =
        std::max(std::abs(glm::dot(p, up)), std::abs(glm::dot(p, right)) / aspect) / tangent;
    distance = std::max(distance, air * reach - glm::dot(p, forward));
  }
  return {glm::vec3(centre - distance * forward), glm::vec3(centre), {0, 1, 0}, 45};
}

/// Near the farthest wall, at the height of the middle, with the view through it.
Camera from_within(const Surroundings& around) {
  double farthest = 0;
  glm::dvec3 way(0, 0, 1);
  for (std::size_t i = 0; i < Surroundings::count; ++i) {
    const glm::dvec3 d = Surroundings::direction(i);
    const double distance = around.distance(i);
    // Level, and the front where others are hardly farther.
    const double wanted = distance * (d.z > 0.7 ? 1.1 : 1);
    if (std::abs(d.y) > 0.2 || std::isinf(distance) || wanted <= farthest) continue;
    farthest = wanted;
    way = d * distance;
  }
  return {glm::vec3(around.from() + 0.85 * glm::dvec3(way.x, 0, way.z)),
          glm::vec3(around.from()),
          {0, 1, 0},
          static_cast<float>(within_fov)};
}

std::optional<Camera> of_room(const Surroundings& around, const Box& box) {
  const Room room(around, box);
  if (!room.has_walls(box)) return std::nullopt;
  if (room.seen >= closed) return from_within(around);
  if (room.seen >= open_to_one_side)
    for (std::size_t s = 0; s < sides.size(); ++s)
      if (room.open[s] >= 0.75) return from_outside(box, -sides[s]);
  return std::nullopt;
}

/// Share of the directions towards the side, not downwards, in which nothing is in the way.
double view_from(const Surroundings& around, double x, double z) {
  double all = 0, free = 0;
  for (std::size_t i = 0; i < Surroundings::count; ++i) {
    const glm::dvec3 d = Surroundings::direction(i);
    if (d.x * x <= 0 || d.z * z <= 0 || d.y < 0) continue;
    all += Surroundings::share(i);
    if (std::isinf(around.distance(i))) free += Surroundings::share(i);
  }
  return free / all;
}

/// Towards the mesh: from the front and the right, unless walls stand there and not elsewhere.
glm::dvec3 three_quarters(const Surroundings& around, const Room& room) {
  glm::dvec2 best(1, 1);
  double freest = view_from(around, 1, 1) + clearly_freer;
  if (room.fronts >= walls_show_fronts)
    for (const glm::dvec2& other : {glm::dvec2(-1, 1), glm::dvec2(1, -1), glm::dvec2(-1, -1)})
      if (const double free = view_from(around, other.x, other.y); free > freest) {
        best = other;
        freest = free;
      }
  return {-0.6 * best.x, -0.5, -best.y};
}

} // namespace

Camera framing(const TriangleMesh& mesh) {
  const Box box = scene_bounds(mesh);
  const glm::dvec3 centre = centre_of(box), size = glm::dvec3(box.hi) - glm::dvec3(box.lo);
  // Something may stand in the middle of a room: then from beside it and above it.
  for (const glm::dvec3& step : {glm::dvec3(0), glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0),
                                 glm::dvec3(-1, 0, 0), glm::dvec3(0, 0, -1), glm::dvec3(0, 1, 0)}) {
    const Surroundings around(mesh, centre + 0.3 * step * size);
    if (const auto camera = of_room(around, box)) return *camera;
    if (mesh.triangles.size() > most_looked_at_often) break;
  }
  const Surroundings around(mesh, centre);
  return from_outside(box, three_quarters(around, Room(around, box)));
}

} // namespace lightcuts
