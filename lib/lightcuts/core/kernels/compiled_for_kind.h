// SPDX-License-Identifier: MIT
#pragma once

#include <variant>

#include <lightcuts/core/kernels/block_bound.h>
#include <lightcuts/core/kernels/cluster_bound.h>
#include <lightcuts/core/kernels/cluster_estimate.h>
#include <lightcuts/core/kernels/kind_kernel.h>

namespace lightcuts {

/// The functions of KindKernel for one kind. Included by its translation unit alone.
template <class Kind>
struct KindFunctions {
  template <class F>
  static decltype(auto) with_lobe(const ShadingPoint& point, F&& f) {
    return std::visit(f, point.material().lobe);
  }

  static glm::vec3 joint_bound(const LightTree& tree, std::uint32_t node,
                               const ShadingPoint& point) {
    return with_lobe(point, [&](const auto& lobe) {
      return cluster_bound(JointSuprema<Kind>(), tree, node, point, lobe);
    });
  }
  static glm::vec3 no_specular_bound(const LightTree& tree, std::uint32_t node,
                                     const ShadingPoint& point) {
    return with_lobe(point, [&]<class OneLobe>(const OneLobe& lobe) {
      if constexpr (std::is_same_v<OneLobe, NoLobe>)
        return cluster_bound(JointSuprema<Kind>(), tree, node, point, lobe);
      else
        return cluster_bound(JointSuprema<Kind>(), tree, node, point, LobeAtItsPeak<OneLobe>{lobe});
    });
  }
  static glm::vec3 product_bound(const LightTree& tree, std::uint32_t node,
                                 const ShadingPoint& point) {
    return with_lobe(point, [&](const auto& lobe) {
      return cluster_bound(ProductSuprema<Kind>(), tree, node, point, lobe);
    });
  }
  static glm::vec3 cosine_bound(const LightTree& tree, std::uint32_t node,
                                const ShadingPoint& point) {
    return with_lobe(point, [&](const auto& lobe) {
      return cluster_bound(CosineSuprema<Kind>(), tree, node, point, lobe);
    });
  }

  static glm::dvec3 estimate(const LightTree& tree, std::uint32_t node, const ShadingPoint& point) {
    return with_lobe(
        point, [&](const auto& lobe) { return centroid_estimate<Kind>(tree, node, point, lobe); });
  }

  template <class OneLobe>
  [[gnu::flatten]] static void estimates_with(const LightTree& tree, std::uint32_t node,
                                              std::span<const ShadingPoint* const> points,
                                              const OneLobe* /*any*/, glm::dvec3* results) {
    for (const ShadingPoint* point : points)
      *results++ =
          centroid_estimate<Kind>(tree, node, *point, std::get<OneLobe>(point->material().lobe));
  }
  static void estimates(const LightTree& tree, std::uint32_t node,
                        std::span<const ShadingPoint* const> points, glm::dvec3* results) {
    with_lobe(*points.front(),
              [&](const auto& lobe) { estimates_with(tree, node, points, &lobe, results); });
  }

  static glm::vec3 bound_of_block(const LightTree& tree, std::uint32_t node,
                                  const ShadingBlock& block) {
    return std::visit([&](const auto& lobe) { return block_bound<Kind>(tree, node, block, lobe); },
                      block.material().lobe);
  }

  /// All calls in one piece.
  template <class OneLobe>
  [[gnu::flatten]] static void evaluate_with(const LightTree& tree, const ShadingPoint& point,
                                             const OneLobe& lobe, std::span<CutCluster> clusters) {
    for (CutCluster& c : clusters) {
      const bool leaf = tree.node(c.node).is_leaf();
      c.bound =
          leaf ? glm::vec3(0) : cluster_bound(JointSuprema<Kind>(), tree, c.node, point, lobe);
      c.estimate = glm::dvec3(0);
      if (!c.visible || (!leaf && c.bound == glm::vec3(0))) continue;
      const glm::dvec3 e = centroid_estimate<Kind>(tree, c.node, point, lobe);
      c.estimate = leaf ? e : glm::min(e, glm::dvec3(c.bound));
    }
  }
  static void evaluate(const LightTree& tree, const ShadingPoint& point,
                       std::span<CutCluster> clusters) {
    with_lobe(point, [&](const auto& lobe) { evaluate_with(tree, point, lobe, clusters); });
  }

  template <class OneLobe>
  [[gnu::flatten]] static void bounds_with(const LightTree& tree, const ShadingPoint& point,
                                           const OneLobe& lobe, std::span<glm::vec3> bounds) {
    const ShadingPoint own = point; // which no writing to bounds can change
    for (std::uint32_t i = 0; i < bounds.size(); ++i)
      bounds[i] = cluster_bound(JointSuprema<Kind>(), tree, i, own, lobe);
  }
  static void all_bounds(const LightTree& tree, const ShadingPoint& point,
                         std::span<glm::vec3> bounds) {
    with_lobe(point, [&](const auto& lobe) { bounds_with(tree, point, lobe, bounds); });
  }

  static void transfers(const ShadingPoint& point, std::span<const Light> lights,
                        double min_distance2, glm::dvec3* results) {
    with_lobe(point, [&](const auto& lobe) {
      for (const Light& light : lights)
        *results++ = transfer<Kind>(point, lobe, light, min_distance2);
    });
  }
};

template <class Kind>
const KindKernel& CompiledForKind<Kind>::kernel() {
  using F = KindFunctions<Kind>;
  static constexpr KindKernel all{{F::joint_bound, F::no_specular_bound, F::product_bound},
                                  F::estimate,
                                  F::cosine_bound,
                                  cluster_lower_bound<Kind>,
                                  F::bound_of_block,
                                  block_lower_bound<Kind>,
                                  F::estimates,
                                  F::evaluate,
                                  F::all_bounds,
                                  F::transfers};
  return all;
}

} // namespace lightcuts
