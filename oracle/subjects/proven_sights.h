// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include <lightcuts/core/tree/light_tree.h>
#include <lightcuts/render/shafts/shaft_prover.h>
#include <lightcuts/render/view/scene_view.h>

namespace lightcuts::oracle {

/// What a prover by these rules proves of each node of the tree, from the root down as far as
/// nothing is proven: see Subject::prove().
template <class Rules>
std::vector<ProvenSight> proven_sights(const SceneView& view, const LightTree& tree,
                                       std::span<const VisiblePoint> points) {
  std::vector<glm::vec3> origins;
  for (const VisiblePoint& p : points) origins.push_back(p.ray_origin);
  BasicShaftProver<Rules> prover(view.triangles(), std::move(origins));
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0U);
  prover.start(all);
  std::vector<ProvenSight> sights(tree.nodes().size(), ProvenSight::unknown);
  std::vector<std::pair<std::uint32_t, ProvenVisibility::Proof>> open{{0, {}}};
  while (!open.empty()) {
    const auto [node, within] = open.back();
    open.pop_back();
    const TreeNode& cluster = tree.node(node);
    const ProvenVisibility::Proof proof = prover.prove(cluster, within);
    sights[node] = proof.sight;
    if (proof.sight != ProvenSight::unknown || cluster.is_leaf()) continue;
    open.emplace_back(cluster.first_child + 1, proof);
    open.emplace_back(cluster.first_child, proof);
  }
  return sights;
}

} // namespace lightcuts::oracle
