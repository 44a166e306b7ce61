// SPDX-License-Identifier: MIT
#include <lightcuts/cluster_emission.h>

#include <glm/common.hpp>

#include <lightcuts/light_tree.h>

namespace lightcuts {
namespace {

ClusterEmission of_light(const Light& light) {
  return {{light.axis, 0},
          glm::vec3(glm::normalize(glm::dvec3(light.axis))),
          light.cos_inner,
          light.cos_outer};
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
    result[i] = {merged(result[a].cone, result[b].cone),
                 glm::vec3(glm::mix(glm::dvec3(result[a].mean_axis),
                                    glm::dvec3(result[b].mean_axis), share)),
                 std::min(result[a].cos_inner, result[b].cos_inner),
                 std::min(result[a].cos_outer, result[b].cos_outer)};
  }
  return result;
}

} // namespace lightcuts
