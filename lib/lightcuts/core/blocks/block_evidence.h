// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <lightcuts/core/blocks/block_visibility.h>
#include <lightcuts/core/blocks/cut_chain.h>
#include <lightcuts/core/lobes/shading_point.h>
#include <lightcuts/core/tree/light_tree.h>

namespace lightcuts {

/// What the points of a block know of the clusters of a cut: each what the cluster contributes to
/// it where nothing occludes, and whether it sees one light of the cluster. Which light, is drawn
/// by intensity; those of the points are spread over the cluster (an additive recurrence with the
/// golden ratio), and depend on the block, the point and the cluster alone.
class BlockEvidence {
public:
  /// The tree must outlive this. unoccluded: everything is seen, and nothing asked.
  BlockEvidence(const LightTree& tree, bool unoccluded) : tree_(&tree), unoccluded_(unoccluded) {}

  /// Of other points, which have to outlive what is asked; all lobes of one type. seed: of what is
  /// drawn for them.
  void start(std::span<const ShadingPoint* const> points, std::uint64_t seed);

  /// Looks at all clusters from these points (their indices, ascending), if that has not been done.
  /// Where a quarter of them, spread evenly, agree on whether they see a cluster, the others take
  /// that over without asking; nobody asks where it is proven. visible(p, light) of point p, called
  /// only for lights above its horizon.
  void look(std::span<const CutChain::Link> clusters, std::span<const std::uint32_t> points,
            const BlockVisibility& visible);
  /// The point asks for itself where it has taken over what others see; false: nowhere.
  bool look_for_itself(std::span<const CutChain::Link> clusters, std::uint32_t point,
                       const BlockVisibility& visible);
  /// The shares that a point sees of clusters, by several lights of each that it asks for itself.
  void look_closely(std::span<const CutChain::Link> clusters, std::uint32_t point,
                    const BlockVisibility& visible, std::vector<float>& shares);

  /// What the cluster at a place contributes where nothing occludes, at most its bound; exact for a
  /// leaf.
  [[nodiscard]] const glm::dvec3& open(std::size_t place, std::uint32_t point) const {
    return seen_[place * stride_ + point].open;
  }
  /// Whether the light drawn is seen.
  [[nodiscard]] bool sees(std::size_t place, std::uint32_t point) const {
    return seen_[place * stride_ + point].visible;
  }
  /// Whether the point has looked at this cluster, at this place; and how many have.
  [[nodiscard]] bool has_looked(std::size_t place, std::uint32_t node, std::uint32_t point) const {
    return seen_[place * stride_ + point].node == node;
  }
  [[nodiscard]] std::uint32_t lookers(std::size_t place, std::uint32_t node) const;
  /// n.l falloff of the light drawn: what it counts beside those that others drew. 0 where nothing
  /// was asked.
  [[nodiscard]] double weight(std::size_t place, std::uint32_t point) const {
    return seen_[place * stride_ + point].weight;
  }
  /// The sum of what is seen over the first `count` places.
  [[nodiscard]] glm::dvec3 total(std::size_t count, std::uint32_t point) const;
  /// Shadow rays of the point so far.
  [[nodiscard]] std::uint32_t shadow_rays(std::uint32_t point) const { return rays_[point]; }

private:
  static constexpr std::uint32_t none = 0xffffffff;
  struct Seen {
    glm::dvec3 open{0};
    std::uint32_t node = none;
    double weight = 0;
    bool visible = true;
    bool taken_over = false; ///< from others
  };
  struct Draw {
    double u; ///< in [0, 1)
    std::uint32_t point;
    Seen* into;
  };

  void open_up(std::uint32_t node, const glm::vec3& bound, Seen* row);
  void ask(std::uint32_t node, Seen* row, std::span<const std::uint32_t> points,
           const BlockVisibility& visible);
  void draw(std::uint32_t node, double lo, double hi, std::span<const Draw> draws,
            const BlockVisibility& visible);
  /// The share of a cluster seen, by several lights; `otherwise` where none is above the horizon.
  [[nodiscard]] float share_of_several(std::uint32_t node, std::uint32_t point,
                                       const BlockVisibility& visible, float otherwise);
  void ask_for(std::uint32_t light, std::uint32_t point, Seen& seen,
               const BlockVisibility& visible);

  const LightTree* tree_;
  bool unoccluded_;
  std::span<const ShadingPoint* const> points_;
  std::uint64_t seed_ = 0;
  std::size_t stride_ = 0;
  std::vector<Seen> seen_; ///< by place, then point
  std::vector<std::uint32_t> rays_;
  std::vector<std::uint32_t> unknown_, first_, others_;
  std::vector<const ShadingPoint*> asked_;
  std::vector<glm::dvec3> estimates_;
  std::vector<Draw> draws_;
};

} // namespace lightcuts
