// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <lightcuts/core/lights/light.h>
#include <lightcuts/core/lobes/material.h>
#include <lightcuts/core/lobes/shading_point.h>
#include <lightcuts/core/tree/light_tree.h>

namespace lightcuts::oracle {

/// What FastTruth has to know of a node of a binary tree, whoever built it.
struct FastNode {
  static constexpr std::uint32_t no_child = 0xFFFFFFFF;
  std::uint32_t child = 0;        ///< after the node itself; of a leaf: the index of its light
  std::uint32_t other = no_child; ///< the second child; no_child: a leaf
};

/// The unoccluded contributions of all clusters of a tree at one shading point, in double, between
/// bars that are narrow enough to decide nearly all comparisons with a bound: the tier before
/// Truth, for omni lights and diffuse surfaces,
///   intensity diffuse/pi max(0, n.q) / (|n| |q| max(|q|^2, min_distance^2)) , q = light - point ,
/// written anew from that. Keeps its memory from one point to the next; one per thread.
///
/// The bars. n.q errs by four roundings of 2^-53, of the sum of |n_i q_i|; where that is more than
/// 2^10 |n.q|, it is computed anew as Truth does, to 2^-53. So n.q errs by 2^-40.9 at most, the
/// other factors together by less than 2^-48, and a sum of what is not negative by 2^-53 for each
/// level of the tree. Nothing under- or overflows: of floats, n.q is 0 or in [2^-298, 2^260],
/// 1/(|q| max()) is in [2^-390, 2^447], and a product with two floats more is above 2^-990.
class FastTruth {
public:
  /// Whether all lights are omni and the material is diffuse only.
  [[nodiscard]] static bool supports(std::span<const Light> lights, const Material& material);

  /// Copies what it needs. nodes: as above, 0 is the root; lights have to be omni. min_distance in
  /// metres, as LightSet has it; 0: no clamp.
  FastTruth(std::span<const Light> lights, std::span<const FastNode> nodes, float min_distance);
  explicit FastTruth(const LightTree& tree);

  /// For a point whose material is diffuse.
  void evaluate(const ShadingPoint& point);

  /// Bars around the cluster's contribution, radiance per channel: lower <= truth <= upper in real
  /// numbers, equal where they are 0.
  [[nodiscard]] double upper(std::uint32_t node, int channel) const {
    return sums_[node][std::size_t(channel)] * to_upper_[std::size_t(channel)];
  }
  [[nodiscard]] double lower(std::uint32_t node, int channel) const {
    return sums_[node][std::size_t(channel)] * to_lower_[std::size_t(channel)];
  }
  [[nodiscard]] std::size_t size() const { return sums_.size(); }
  /// (upper - lower) / upper at most.
  [[nodiscard]] double relative_width() const { return 2 * error_; }

private:
  using Sum = std::array<double, 4>; ///< per channel, and one for the sake of whole registers
  struct Inner {
    std::uint32_t node, child, other;
  };

  void evaluate_block(const ShadingPoint& point, std::size_t begin, std::size_t end);
  void evaluate_doubtful(const ShadingPoint& point, std::size_t begin, std::size_t end);

  double min_distance2_;
  double error_;                                ///< relative, of all that is computed
  std::vector<float> x_, y_, z_;                ///< of the leaves' lights, metres
  std::vector<std::array<float, 3>> intensity_; ///< of the leaves' lights, W/sr
  std::vector<std::uint32_t> leaves_;           ///< nodes of one light
  std::vector<Inner> inner_;                    ///< the other nodes, children first
  std::vector<double> transfer_; ///< per leaf: n.q / (|q| max(|q|^2, min_distance^2)), 1/m^2
  std::vector<Sum> sums_;        ///< per node: the sum of intensity times transfer
  std::array<double, 3> to_upper_{}, to_lower_{}; ///< diffuse / (pi |n|) (1 +- error)
};

/// What compare() found at one point.
struct FastComparison {
  std::vector<std::uint32_t>
      undecided; ///< nodes that need a closer look: violations are among them
  /// Largest contribution / bound of all other nodes and channels with a finite bound, at most
  /// FastTruth::relative_width() too large; 0 where nothing contributes.
  double worst_ratio = 0;
  std::uint32_t worst_node = 0;
  int worst_channel = 0;
};

/// Compares a bound of each node, radiance per channel, with the truth: bound >= contribution
/// certainly holds in every channel of a node that is not reported as undecided. NaN and negative
/// bounds are never enough, +inf always is. result is overwritten.
void compare(std::span<const glm::vec3> bounds, const FastTruth& truth, FastComparison& result);

} // namespace lightcuts::oracle
