// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <lightcuts/core/methods/no_specular_bound_rules.h>
#include <lightcuts/core/methods/unscaled_rules.h>

namespace lightcuts {

/// What a cluster's error bound is.
enum class BoundRule : std::uint8_t {
  joint,       ///< as LightcutsRules have it
  no_specular, ///< as NoSpecularBoundRules
  product      ///< as PaperRules
};

/// What a cluster is taken to contribute.
enum class EstimateRule : std::uint8_t {
  centroid,       ///< as LightcutsRules have it
  representative, ///< scaled, as PaperRules
  unscaled        ///< as UnscaledRules
};

/// Bound and estimate chosen at run time, for any scene: to look at their combinations.
struct ChosenRules : LightcutsRules {
  BoundRule bound_rule = BoundRule::joint;
  EstimateRule estimate_rule = EstimateRule::centroid;

  template <class OneLobe>
  [[nodiscard]] glm::vec3 bound(const LightTree& tree, std::uint32_t node,
                                const ShadingPoint& point, const OneLobe& lobe) const {
    switch (bound_rule) {
    case BoundRule::product:
      return PaperRules::bound(tree, node, point, lobe);
    case BoundRule::no_specular:
      return NoSpecularBoundRules::bound(tree, node, point, lobe);
    case BoundRule::joint:
      break;
    }
    return LightcutsRules::bound(tree, node, point, lobe);
  }

  template <class OneLobe>
  [[nodiscard]] glm::dvec3 estimate(const LightTree& tree, std::uint32_t node,
                                    const ShadingPoint& point, const OneLobe& lobe,
                                    const glm::vec3& bound) const {
    switch (estimate_rule) {
    case EstimateRule::representative:
      return PaperRules::estimate(tree, node, point, lobe, bound);
    case EstimateRule::unscaled:
      return UnscaledRules::estimate(tree, node, point, lobe, bound);
    case EstimateRule::centroid:
      break;
    }
    return LightcutsRules::estimate(tree, node, point, lobe, bound);
  }

  bool operator==(const ChosenRules& other) const {
    return bound_rule == other.bound_rule && estimate_rule == other.estimate_rule;
  }
};

} // namespace lightcuts
