// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <glm/vec3.hpp>
#include <lightcuts/core/lobes/shading_point.h>
#include <lightcuts/core/records/fields.h>
#include <lightcuts/core/tree/light_tree.h>

namespace lightcuts {

/// One cluster of a cut.
struct CutCluster {
  std::uint32_t node;
  bool visible;        ///< whether its representative is seen
  glm::dvec3 estimate; ///< radiance that it is taken to contribute, occlusion included
  glm::vec3 bound;     ///< of the error of that, radiance; 0 for a leaf
};

/// Bounds and estimates of a tree's clusters as seen from a shading point: all that a cut is made
/// of, apart from the loop that makes it (see CutSelector), so that methods, and the oracle's
/// broken ones, can put their own in their place. Any node, mixed ones too.
class ClusterKernel {
public:
  virtual ~ClusterKernel() = default;

  /// Upper bound, per channel, of the cluster's contribution; leaves have one, too.
  [[nodiscard]] virtual glm::vec3 bound(const LightTree& tree, std::uint32_t node,
                                        const ShadingPoint& point) const = 0;
  /// What the cluster is taken to contribute if its representative is seen; between 0 and `bound`,
  /// and exact for a leaf.
  [[nodiscard]] virtual glm::dvec3 estimate(const LightTree& tree, std::uint32_t node,
                                            const ShadingPoint& point,
                                            const glm::vec3& bound) const = 0;
  /// Lower bound of the cluster's contribution where nothing occludes.
  [[nodiscard]] virtual glm::vec3 lower_bound(const LightTree& tree, std::uint32_t node,
                                              const ShadingPoint& point) const;

  /// Fills in bounds and estimates of clusters by their nodes and whether these are visible: bound
  /// 0 for a leaf, estimate 0 for what is hidden or cannot contribute.
  virtual void evaluate(const LightTree& tree, const ShadingPoint& point,
                        std::span<CutCluster> clusters) const;
};

/// What a cluster's error bound is.
enum class BoundRule : std::uint8_t {
  joint,       ///< the maximum of n.l/|q|^2 over the box in one: see contribution_bound()
  no_specular, ///< lobes bounded by their peaks, wherever the lights are
  product      ///< separate maxima of n.l and 1/|q|^2 (Walter et al. 2005)
};
inline constexpr int bound_rule_count = 3;
[[nodiscard]] constexpr std::array<const char*, bound_rule_count> names_of(BoundRule /*any*/) {
  return {"joint", "no-specular", "product"};
}

/// What a cluster is taken to contribute.
enum class EstimateRule : std::uint8_t {
  centroid,       ///< as of one light at its centroid of intensity: see centroid_estimate()
  representative, ///< the representative's, scaled to its intensity (Walter et al. 2005)
  unscaled        ///< the representative's alone
};
inline constexpr int estimate_rule_count = 3;
[[nodiscard]] constexpr std::array<const char*, estimate_rule_count>
names_of(EstimateRule /*any*/) {
  return {"centroid", "representative", "unscaled"};
}

struct ClusterRules {
  BoundRule bound = BoundRule::joint;
  EstimateRule estimate = EstimateRule::centroid;

  template <class Visitor>
  static constexpr void fields(Visitor&& field) {
    field("bound", &ClusterRules::bound, domain::optional);
    field("estimate", &ClusterRules::estimate, domain::optional);
  }
  bool operator==(const ClusterRules&) const = default;
};

/// The library's kernel for trees of these kinds of light by these rules: compiled for one kind
/// alone, or for any mixture, with the same bits.
[[nodiscard]] const ClusterKernel& kernel_for(LightKinds kinds, const ClusterRules& rules = {});

} // namespace lightcuts
