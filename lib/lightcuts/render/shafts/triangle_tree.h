// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/geometry/box.h>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// A triangle that may occlude, and what bounds the errors of a ray's test against it.
struct FlatTriangle {
  std::array<glm::dvec3, 3> corners; ///< the longest edge goes from the first to the second
  glm::dvec3 normal;                 ///< unit
  double longest;                    ///< edge, metres
  double slimness;                   ///< longest edge by the height over it, 2 / sqrt 3 or more;
                                     ///< +inf where a ray's single precision may underflow
  std::uint32_t partner;             ///< beyond the longest edge; itself: none

  /// Signed distance from the plane, metres.
  [[nodiscard]] double height(const glm::dvec3& p) const {
    return glm::dot(normal, p - corners[0]);
  }
};

/// The triangles of a mesh that may occlude, in a binary tree of boxes (split at the median of the
/// widest axis). Immutable, for many threads.
class TriangleTree {
public:
  struct Node {
    Box box;
    std::uint32_t first; ///< child, the other follows; of a leaf: triangle
    std::uint32_t count; ///< of a leaf's triangles; 0: inner
  };

  /// The mesh must be valid. Those without area, which block nothing, are left out.
  explicit TriangleTree(const TriangleMesh& mesh);

  [[nodiscard]] std::span<const FlatTriangle> triangles() const { return triangles_; }
  /// The root is the first; none where there is no triangle.
  [[nodiscard]] std::span<const Node> nodes() const { return nodes_; }
  /// Around all positions of the mesh, also of those that no triangle has.
  [[nodiscard]] const Box& box() const { return box_; }

private:
  void split(std::uint32_t node, std::uint32_t first, std::uint32_t count);
  void pair_up();

  std::vector<FlatTriangle> triangles_;
  std::vector<Node> nodes_;
  Box box_ = Box::empty();
};

} // namespace lightcuts
