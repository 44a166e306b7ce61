// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// What can be seen of a mesh from a point, all around it, coarsely: one look per square of a
/// cube's sides. Small triangles count for the square that their centre is in, so that a look takes
/// time in proportion to the triangles, however many they are.
class Surroundings {
public:
  static constexpr int squares = 8; ///< along an edge of the cube
  static constexpr std::size_t count = 6UL * squares * squares;

  Surroundings(const TriangleMesh& mesh, const glm::dvec3& from);

  [[nodiscard]] const glm::dvec3& from() const { return from_; }
  /// The unit direction of a look, i in [0, count).
  [[nodiscard]] static glm::dvec3 direction(std::size_t i);
  /// Solid angle of a look's square over that of all.
  [[nodiscard]] static double share(std::size_t i);
  /// Distance to what is seen, metres; infinite where nothing is.
  [[nodiscard]] double distance(std::size_t i) const { return looks_[i].distance; }
  /// Whether the seen triangle's front is: its corners run counter-clockwise.
  [[nodiscard]] bool sees_front(std::size_t i) const { return looks_[i].front; }

private:
  struct Look {
    double distance;
    bool front;
  };

  void add_small(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);
  void add_large(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);
  void put(std::size_t i, double distance, bool front);

  glm::dvec3 from_;
  std::vector<Look> looks_;
};

} // namespace lightcuts
