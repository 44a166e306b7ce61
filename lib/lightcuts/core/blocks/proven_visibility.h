// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include <lightcuts/core/tree/light_tree.h>

namespace lightcuts {

/// What is certain of whether some points see the lights of a cluster.
enum class ProvenSight : std::uint8_t {
  unknown,
  seen,  ///< no shadow ray from any of the points to any of the lights is blocked
  hidden ///< all are
};

/// Proves, without a shadow ray, that the points of a group see a cluster or do not. One per
/// thread.
class ProvenVisibility {
public:
  struct Proof {
    ProvenSight sight = ProvenSight::unknown;
    std::uint32_t candidates = 0; ///< what may lie between, for what is proven of clusters within
  };

  ProvenVisibility() = default;
  ProvenVisibility(const ProvenVisibility&) = delete;
  ProvenVisibility& operator=(const ProvenVisibility&) = delete;
  virtual ~ProvenVisibility() = default;

  /// From here on of these points, their indices in the group. Proofs from before are void.
  virtual void start(std::span<const std::uint32_t> points) = 0;
  /// within: what was found since the start for a cluster that has all lights of this one, or
  /// Proof().
  virtual Proof prove(const TreeNode& cluster, const Proof& within) = 0;
};

} // namespace lightcuts
