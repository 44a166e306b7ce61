// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/lights/light_set.h>

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

/// The moments of all nodes, in one bottom-up pass. nodes as LightTree has them; of a cluster with
/// directional lights among others they mean nothing.
[[nodiscard]] std::vector<ClusterMoments> moments_of(std::span<const TreeNode> nodes,
                                                     const LightSet& lights);

/// What the second moment adds to g = n.q a.q/|q|^k at the centroid, as a factor: with the Hessian
/// H of g the mean of g over the cluster is g + tr(H C)/2 to second order, and
///   tr(H C) / 2g = n.C a / (n.q a.q)
///                  + (-k n.C q / n.q - k a.C q / a.q - k/2 tr C + k (k+2)/2 q.C q / |q|^2) / |q|^2
///                  .
/// The series means nothing near the cluster: limited to [1/2, 2].
class SecondMoment {
public:
  SecondMoment(const ClusterMoments& moments, const glm::dvec3& q) : moments_(moments), q_(q) {
    cq_ = times(q);
    length2_ = glm::dot(q, q);
  }

  /// g = n.q / |q|^k: an omni light for k = 3, a directional one for k = 1.
  [[nodiscard]] double factor(const glm::vec3& n, int k) const {
    return limited(1 + common(glm::dvec3(n), k));
  }

  /// g = n.q a.q / |q|^4: an oriented light, a its mean axis.
  [[nodiscard]] double oriented_factor(const glm::vec3& n, const glm::vec3& a) const {
    const glm::dvec3 nd(n), ad(a);
    const double a_dot_q = glm::dot(ad, q_);
    return limited(1 + common(nd, 4) - 4 * glm::dot(ad, cq_) / (a_dot_q * length2_) +
                   glm::dot(nd, times(ad)) / (glm::dot(nd, q_) * a_dot_q));
  }

private:
  [[nodiscard]] glm::dvec3 times(const glm::dvec3& p) const {
    const glm::dvec3 v(moments_.variance), w(moments_.covariance);
    return {v.x * p.x + w.z * p.y + w.y * p.z, w.z * p.x + v.y * p.y + w.x * p.z,
            w.y * p.x + w.x * p.y + v.z * p.z};
  }
  [[nodiscard]] double common(const glm::dvec3& n, int k) const {
    const glm::vec3& v = moments_.variance;
    return (-k * glm::dot(n, cq_) / glm::dot(n, q_) - 0.5 * k * (double(v.x) + v.y + v.z) +
            0.5 * k * (k + 2) * glm::dot(q_, cq_) / length2_) /
           length2_;
  }
  // Written so that NaN (0/0, inf - inf) gives 1.
  [[nodiscard]] static double limited(double factor) {
    return factor > 2 ? 2 : factor < 0.5 ? 0.5 : factor > 0 ? factor : 1;
  }

  const ClusterMoments& moments_;
  glm::dvec3 q_, cq_;
  double length2_;
};

} // namespace lightcuts
