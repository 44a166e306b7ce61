// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <lightcuts/core/blocks/block_evidence.h>

namespace lightcuts {

/// Which share of a cluster is seen from the points of a block, from whether each of those that
/// have looked saw the light it asked for. To these, a plane over the picture is fitted by least
/// squares; to that is added, for each point, another that is fitted to what is left by those that
/// are alike. Alike are points whose evidence of all clusters together differs by no more than
/// chance lets expect: at the edge of a shadow those on the same side.
class VisibleShare {
public:
  /// places: where the points of the block lie in the picture, pixels.
  void start(std::span<const glm::vec2> places);

  /// Fits all clusters, at which these points have looked, and finds out which of these are alike.
  /// Between others it stays as it was.
  void observe(const BlockEvidence& evidence, std::span<const CutChain::Link> clusters,
               std::span<const std::uint32_t> points);

  /// Of the cluster at a place in the cut observed last, a share for each of some points, in [0,
  /// 1]: 0 or 1 where all that looked agree. shares: as many.
  void at(std::size_t place, std::span<const std::uint32_t> points, std::span<float> shares);

private:
  struct Plane {
    double height = 0;
    glm::dvec2 slope{0};
    bool agreed = true; ///< 0 or 1 for all
  };
  struct Sums;

  [[nodiscard]] double on(const Plane& plane, std::uint32_t point) const;
  [[nodiscard]] Plane plane_of(const Sums& sums) const;
  void fit(const BlockEvidence& evidence, std::size_t place, const CutChain::Link& cluster);
  void compare(const BlockEvidence& evidence, std::span<const std::uint32_t> points);
  /// Adds what one cluster tells of two points; the variance of that where they are alike.
  double compare_at(std::size_t place, double light, std::span<const std::uint32_t> points);
  void smooth(std::span<const std::uint32_t> points);

  std::vector<glm::dvec2> places_; ///< from the first
  std::vector<Plane> planes_;      ///< by place in the cut
  std::vector<float> weights_;     ///< by place in the cut, then point: of its evidence; <= 1
  std::vector<float> residuals_; ///< likewise: what it saw less the plane; 0 where it did not look
  std::vector<float> alike_;     ///< by two points, in [0, 1]
  std::vector<float> influence_; ///< by residual of a point, then share of another
  // Kept for their room:
  std::vector<double> excess_;
  std::vector<float> products_, seen_, raised_;
};

} // namespace lightcuts
