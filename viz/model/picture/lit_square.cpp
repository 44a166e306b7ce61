// SPDX-License-Identifier: MIT
#include <viz/model/picture/lit_square.h>

#include <algorithm>
#include <unordered_map>

#include <glm/common.hpp>
#include <lightcuts/core/kernels/contribution_bound.h>
#include <lightcuts/render/shafts/shaft_prover.h>

namespace lightcuts::viz {

/// Proves as another does, and remembers who asked and what was found.
class LitSquare::Recorder final : public ProvenVisibility {
public:
  Recorder(LitSquare& square, ProvenVisibility& inner) : square_(square), inner_(inner) {}

  void start(std::span<const std::uint32_t> points) override {
    // A block that is parted starts again as others: the last start of a pixel counts.
    for (const std::uint32_t p : points) square_.block_of_[p] = square_.blocks_.size();
    square_.blocks_.emplace_back(points.begin(), points.end());
    found_.emplace_back();
    inner_.start(points);
  }
  Proof prove(const TreeNode& cluster, const Proof& within) override {
    const Proof proof = inner_.prove(cluster, within);
    found_.back()[&cluster] = proof.sight;
    return proof;
  }

  /// Of a cluster of the pixel's cut.
  [[nodiscard]] ProvenSight sight(std::size_t p, const TreeNode& cluster) const {
    const auto& found = found_[square_.block_of_[p]];
    const auto at = found.find(&cluster);
    // Nobody asks about what is within a cluster that is seen, and a hidden one is not refined.
    return at == found.end() ? ProvenSight::seen : at->second;
  }

private:
  LitSquare& square_;
  ProvenVisibility& inner_;
  std::vector<std::unordered_map<const TreeNode*, ProvenSight>> found_; ///< by block
};

LitSquare::LitSquare(const SceneView& view, const LightTree& tree, const CutConfig& config,
                     std::uint64_t seed, glm::uvec2 pixel)
    : tree_(&tree), square_(view, pixel), block_of_(square_.pixels.size()),
      proofs_(square_.pixels.size()), asked_(square_.pixels.size()) {
  const auto sees = [&](std::uint32_t p, std::uint32_t light) {
    asked_[p].push_back(light);
    return view.sees(square_.seen[p], light);
  };
  ShaftProver shafts(view.triangles(), square_.ray_origins());
  Recorder recorder(*this, shafts);
  BlockCutSelector select(tree, config, seed);
  const auto cuts = select(square_.points, square_.query, {sees, &recorder}, &clusters_);
  cuts_.assign(cuts.begin(), cuts.end());
  if (tree.empty()) return;
  for (std::size_t p = 0; p < cuts_.size(); ++p) {
    for (const CutCluster& c : clusters_[p])
      proofs_[p].push_back(recorder.sight(p, tree.node(c.node)));
    std::ranges::sort(asked_[p]);
  }
}

std::size_t LitSquare::index_of(glm::uvec2 pixel) const {
  return std::size_t(std::ranges::find(square_.pixels, pixel) - square_.pixels.begin());
}

std::vector<std::optional<Sight>> LitSquare::sights(std::size_t p) const {
  std::vector<std::optional<Sight>> sights;
  for (std::size_t i = 0; i < clusters_[p].size(); ++i) {
    const CutCluster& cluster = clusters_[p][i];
    std::optional<Sight>& sight = sights.emplace_back();
    if (proofs_[p][i] != ProvenSight::unknown) {
      sight = proofs_[p][i] == ProvenSight::seen ? Sight::seen : Sight::hidden;
    } else if (!cluster.visible || cluster.estimate != glm::dvec3(0)) {
      const TreeNode& node = tree_->node(cluster.node);
      const bool own = node.is_leaf() && std::ranges::binary_search(asked_[p], node.representative);
      sight = own ? Sight::ray : Sight::share;
    }
  }
  return sights;
}

double LitSquare::proven(std::size_t p) const {
  double known = 0, all = 0;
  bool all_known = true;
  for (std::size_t i = 0; i < clusters_[p].size(); ++i) {
    const CutCluster& cluster = clusters_[p][i];
    glm::dvec3 light = cluster.estimate;
    if (proofs_[p][i] == ProvenSight::hidden) {
      const ShadingPoint& point = square_.points[p].point;
      const ShadingPoint* const at = &point;
      centroid_estimates(*tree_, cluster.node, {&at, 1}, {&light, 1});
      light = glm::min(light, glm::dvec3(contribution_bound(*tree_, cluster.node, point)));
    }
    const double sum = light.x + light.y + light.z;
    all += sum;
    if (proofs_[p][i] != ProvenSight::unknown)
      known += sum;
    else
      all_known = false;
  }
  if (all_known) return 1; // of no light, too
  return all > 0 ? known / all : 0;
}

} // namespace lightcuts::viz
