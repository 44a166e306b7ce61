// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>
#include <lightcuts/core/cut/certified_error.h>
#include <lightcuts/core/cut/cut_selector.h>
#include <lightcuts/core/cut/light_sampling.h>
#include <lightcuts/core/kernels/transfer.h>
#include <lightcuts/core/numerics/rounding.h>
#include <lightcuts/core/numerics/splitmix.h>
#include <lightcuts/core/tree/light_tree.h>

namespace lightcuts {

/// The random number in [0, 1) of one node in one query: a hash, so that it depends on nothing
/// else, and those of different nodes, queries and seeds are as if independent.
[[nodiscard]] constexpr double random_number(std::uint64_t seed, std::uint64_t query,
                                             std::uint32_t node) {
  const std::uint64_t key = splitmix64(splitmix64(seed) ^ query);
  return double(splitmix64(key ^ node) >> 11) * 0x1p-53;
}

/// Stochastic Lightcuts (Yuksel 2019): each cluster of a cut is lit by one light drawn anew for
/// each query, f/p with f its contribution, occlusion included, and p the probability to draw it.
/// Noise in place of the structured error of fixed representatives.
///
/// Unbiased: over the seeds, the mean radiance is the exact one. For the cut must not depend on
/// what is drawn, and it does not: CutSelector picks it by estimates that are
/// deterministic, as if all lights were seen. In shadow the threshold is thus relative to more
/// light than there is. A cluster is a sum of lights, each with p > 0 where f > 0, so that the mean
/// of f/p is that sum; a leaf is exact. What leaves of this is the resolution of random numbers,
/// 2^-53, and rounding.
///
/// A Cut's estimates are those f/p, which may exceed the bounds. `visible`: whether the light drawn
/// is seen. `end` and the bounds are those of the choice of the cut. The certified error is that of
/// this one sample: a cluster's truth is between 0 and its bound, and f/p is known.
/// One selector per thread; no allocation once the largest cut has been seen.
template <class Importance>
class BasicStochasticCutSelector {
public:
  /// The tree must outlive the selector. Throws InputError, naming the field, where the
  /// configuration is NaN or out of its domain. config.unoccluded: `visible` is not called.
  explicit BasicStochasticCutSelector(const LightTree& tree, const CutConfig& config = {},
                                      std::uint64_t seed = 1)
      : tree_(&tree), select_(tree, with_lower_bounds_left_out(config)),
        unoccluded_(config.unoccluded), seed_(seed) {}

  /// query: a number of its own for each point, such as the pixel's index; the same seed, query and
  /// point give the same bits. visible(i) tells whether light i of the LightSet is seen from the
  /// point; called once per cluster at most, for lights that would contribute.
  Cut operator()(const ShadingPoint& point, std::uint64_t query, Visibility visible) {
    chosen_ = select_(point, [](std::uint32_t /*light*/) { return true; });
    shares_.forget();
    return again(point, query, visible);
  }

  /// Another sample at the point of this selector's last call: the same bits as a call with this
  /// query, but what does not depend on the query is not computed again.
  Cut again(const ShadingPoint& point, std::uint64_t query, Visibility visible) {
    Cut cut = chosen_;
    cut.shadow_rays = 0;
    clusters_.assign(cut.clusters.begin(), cut.clusters.end());
    for (CutCluster& cluster : clusters_)
      if (!is_dark(cluster)) draw(cluster, point, query, visible, cut.shadow_rays);
    add_up(cut);
    return cut;
  }

private:
  /// The choice needs no error bounds, which take time.
  static CutConfig with_lower_bounds_left_out(CutConfig config) {
    config.unoccluded = false;
    return config;
  }

  [[nodiscard]] bool is_leaf(const CutCluster& cluster) const {
    return tree_->node(cluster.node).is_leaf();
  }
  /// Contributes nothing, and has the estimate 0.
  [[nodiscard]] bool is_dark(const CutCluster& cluster) const {
    return !is_leaf(cluster) && cluster.bound == glm::vec3(0);
  }

  void draw(CutCluster& cluster, const ShadingPoint& point, std::uint64_t query,
            const Visibility& visible, std::uint32_t& shadow_rays) const {
    const LightSample sample = sample_light(shares_, *tree_, cluster.node, point,
                                            random_number(seed_, query, cluster.node));
    cluster.visible = true;
    cluster.estimate = glm::dvec3(0);
    if (sample.probability == 0) return;
    const Light& light = tree_->lights()[sample.light];
    const glm::dvec3 contribution =
        transfer(point, light, tree_->lights().min_distance()) * glm::dvec3(light.intensity);
    if (contribution == glm::dvec3(0)) return;
    if (!unoccluded_) {
      ++shadow_rays;
      cluster.visible = visible(sample.light);
    }
    if (cluster.visible) cluster.estimate = contribution / sample.probability;
  }

  void add_up(Cut& cut) const {
    glm::dvec3 total(0), error(0);
    for (const CutCluster& c : clusters_) {
      total += c.estimate;
      if (is_leaf(c)) continue;
      // In this order infinity minus infinity is left out.
      error += glm::max(c.estimate, glm::dvec3(c.bound) - c.estimate);
    }
    for (int c = 0; c < 3; ++c) {
      cut.radiance[c] = to_float(total[c]);
      cut.certified_error[c] = certified_error(total[c], error[c]);
    }
    cut.clusters = clusters_;
  }

  const LightTree* tree_;
  CutSelector select_;
  bool unoccluded_;
  std::uint64_t seed_;
  Cut chosen_; ///< its clusters are select_'s
  SharesAtPoint<Importance> shares_;
  std::vector<CutCluster> clusters_;
};

/// By hierarchical importance.
using StochasticCutSelector = BasicStochasticCutSelector<HierarchicalImportance>;

} // namespace lightcuts
