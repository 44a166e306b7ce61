// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <lightcuts/contribution.h>
#include <lightcuts/light_set.h>
#include <lightcuts/shading_point.h>

namespace lightcuts {

struct TreeNode;

/// Where a cluster's intensity is: its centroid, inside the cluster's box, and the covariance
/// around it, m^2, weighted by intensity (summed over channels). Of a leaf: the light's position,
/// and 0.
struct ClusterMoments {
  glm::vec3 centroid{0};
  glm::vec3 variance{0};   ///< xx, yy, zz
  glm::vec3 covariance{0}; ///< yz, zx, xy
};

/// The moments of all nodes, in one bottom-up pass. nodes as LightTree has them.
[[nodiscard]] std::vector<ClusterMoments> moments_of(std::span<const TreeNode> nodes,
                                                     const LightSet& lights);

/// What the second moment adds to n.q/|q|^3 at the centroid, as a factor: with g = n.q/|q|^3 and
/// its Hessian H, the mean of g over the cluster is g + tr(H C)/2 to second order, and
///   tr(H C) / 2g = (-3 n.C q / n.q - 3/2 tr C + 15/2 q.C q / |q|^2) / |q|^2 .
/// The series means nothing near the cluster: limited to [1/2, 2].
[[nodiscard]] inline double second_moment_factor(const glm::vec3& n, const glm::dvec3& q,
                                                 const ClusterMoments& m) {
  const glm::dvec3 v(m.variance);
  const glm::dvec3 w(m.covariance);
  const glm::dvec3 cq(v.x * q.x + w.z * q.y + w.y * q.z, w.z * q.x + v.y * q.y + w.x * q.z,
                      w.y * q.x + w.x * q.y + v.z * q.z);
  const double length2 = glm::dot(q, q);
  const double n_dot_q = glm::dot(glm::dvec3(n), q);
  const double n_dot_cq = glm::dot(glm::dvec3(n), cq);
  const double factor =
      1 + (-3 * n_dot_cq / n_dot_q - 1.5 * (v.x + v.y + v.z) + 7.5 * glm::dot(q, cq) / length2) /
              length2;
  // Written so that NaN (0/0, inf - inf) gives 1.
  return factor > 2 ? 2 : factor < 0.5 ? 0.5 : factor > 0 ? factor : 1;
}

/// Mean radiance per unit of radiant intensity that the cluster sends if nothing occludes it: its
/// material term at the centroid, the geometric one to second order. Exact for a leaf (see
/// transfer()); in error by O((size/distance)^3) for diffuse, ^2 for glossy surfaces.
[[nodiscard]] inline glm::dvec3 cluster_transfer(const ShadingPoint& point,
                                                 const ClusterMoments& m) {
  const glm::dvec3 at_centroid = transfer(point, m.centroid);
  if (at_centroid == glm::dvec3(0) || m.variance == glm::vec3(0)) return at_centroid;
  const glm::dvec3 q = glm::dvec3(m.centroid) - glm::dvec3(point.position());
  return at_centroid * second_moment_factor(point.normal(), q, m);
}

} // namespace lightcuts
