// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>

#include <glm/vec3.hpp>
#include <lightcuts/core/lights/light.h>
#include <lightcuts/core/lobes/shading_point.h>
#include <oracle/truth/kinds.h>
#include <oracle/truth/vectors.h>

namespace lightcuts::oracle::radiometry {

/// Everything about the way from a point to a light, both above each other's horizon.
template <class Real>
struct Way {
  const ShadingPoint& point;
  glm::vec3 from, to;
  Vector<Real> q;
  Real distance2, distance, n_dot_l;
  /// Once they are known: where they cancel they take a hundred times as long as all the rest, and
  /// are the same for all lobes.
  mutable std::optional<Real> known_half_tangent2, known_schlick;

  Way(const ShadingPoint& p, const Light& light)
      : Way(p, is_far(light.kind) ? glm::vec3(0) : p.position(), light.position) {}
  Way(const ShadingPoint& p, const glm::vec3& start, const glm::vec3& end)
      : point(p), from(start), to(end) {
    for (int i = 0; i < 3; ++i) q[std::size_t(i)] = Real(to[i]) - Real(from[i]);
    distance2 = dot(q, q);
    distance = square_root<Real>(distance2);
    n_dot_l = distance2 == 0 ? Real(0) : Real(cosine_with(p.normal()));
  }
  [[nodiscard]] Real cosine_with(const glm::vec3& u) const {
    return dot_between<Real>(u, from, to) / (length<Real>(u) * distance);
  }
  /// This way in 700 bits: for what cancels too many digits of Real.
  [[nodiscard]] Way<Exact> exact() const { return {point, from, to}; }
};

/// n.v.
template <class Real>
Real viewer_cosine(const ShadingPoint& p) {
  return dot_between<Real>(p.normal(), glm::vec3(0), p.to_viewer()) /
         (length<Real>(p.normal()) * length<Real>(p.to_viewer()));
}

} // namespace lightcuts::oracle::radiometry
