// SPDX-License-Identifier: MIT
#include <lightcuts/core/tree/cluster_moments.h>

#include <lightcuts/core/tree/light_tree.h>

namespace lightcuts {
namespace {

/// In double, as they are summed up.
struct Sums {
  double weight = 0;
  glm::dvec3 mean{0}, variance{0}, covariance{0};
};

/// Of two clusters together (Chan, Golub & LeVeque 1979).
Sums together(const Sums& a, const Sums& b) {
  Sums sum;
  sum.weight = a.weight + b.weight;
  const double share_a = sum.weight > 0 ? a.weight / sum.weight : 0.5;
  const double share_b = 1 - share_a;
  const glm::dvec3 d = b.mean - a.mean;
  sum.mean = a.mean + share_b * d;
  const double between = share_a * share_b;
  sum.variance = share_a * a.variance + share_b * b.variance + between * d * d;
  sum.covariance = share_a * a.covariance + share_b * b.covariance +
                   between * glm::dvec3(d.y * d.z, d.z * d.x, d.x * d.y);
  return sum;
}

} // namespace

std::vector<ClusterMoments> moments_of(std::span<const TreeNode> nodes, const LightSet& lights) {
  std::vector<Sums> sums(nodes.size());
  std::vector<ClusterMoments> moments(nodes.size());
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const TreeNode& node = nodes[i];
    if (node.is_leaf()) {
      sums[i].weight = node.intensity.x + node.intensity.y + node.intensity.z;
      sums[i].mean = glm::dvec3(lights[node.representative].position);
    } else {
      sums[i] = together(sums[node.first_child], sums[node.first_child + 1]);
    }
    constexpr double largest = std::numeric_limits<float>::max();
    const auto to_floats = [](const glm::dvec3& v) {
      return glm::vec3(glm::clamp(v, -largest, largest));
    };
    moments[i] = {glm::clamp(to_floats(sums[i].mean), node.box.lo, node.box.hi),
                  to_floats(sums[i].variance), to_floats(sums[i].covariance)};
  }
  return moments;
}

} // namespace lightcuts
