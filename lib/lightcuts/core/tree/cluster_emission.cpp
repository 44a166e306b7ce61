// SPDX-License-Identifier: MIT
#include <lightcuts/core/tree/cluster_emission.h>

#include <glm/common.hpp>

#include <lightcuts/core/tree/light_tree.h>

namespace lightcuts {
namespace {

ClusterEmission of_light(const Light& light) {
  const glm::dvec3 a = glm::normalize(glm::dvec3(light.axis));
  return {.cone = {light.axis, 0},
          .mean_axis = glm::vec3(a),
          .axis_square = glm::vec3(a * a),
          .axis_product = glm::vec3(a.y * a.z, a.z * a.x, a.x * a.y),
          .cos_inner = light.cos_inner,
          .cos_outer = light.cos_outer};
}

double weight(const TreeNode& node) {
  return node.intensity.x + node.intensity.y + node.intensity.z;
}

} // namespace

std::vector<ClusterEmission> emission_of(std::span<const TreeNode> nodes, const LightSet& lights) {
  std::vector<ClusterEmission> result(nodes.size());
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const TreeNode& node = nodes[i];
    if ((node.kinds & kinds_with_axis) == 0 || node.is_mixed()) continue;
    if (node.is_leaf()) {
      result[i] = of_light(lights[node.representative]);
      continue;
    }
    const std::uint32_t a = node.first_child, b = a + 1;
    const double sum = weight(nodes[a]) + weight(nodes[b]);
    const double share = sum > 0 ? weight(nodes[b]) / sum : 0.5;
    const auto mean = [&](glm::vec3 ClusterEmission::*part) {
      return glm::vec3(glm::mix(glm::dvec3(result[a].*part), glm::dvec3(result[b].*part), share));
    };
    result[i] = {.cone = merged(result[a].cone, result[b].cone),
                 .mean_axis = mean(&ClusterEmission::mean_axis),
                 .axis_square = mean(&ClusterEmission::axis_square),
                 .axis_product = mean(&ClusterEmission::axis_product),
                 .cos_inner = std::min(result[a].cos_inner, result[b].cos_inner),
                 .cos_outer = std::min(result[a].cos_outer, result[b].cos_outer)};
  }
  return result;
}

} // namespace lightcuts
