// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include <oracle/properties/point_case.h>

namespace lightcuts::oracle {

/// A cut that a subject chose at a point.
struct CutAnswer {
  const PointAnswers& point;
  const CutConfig& config;
  const Cut& cut;
  Wide total; ///< of its estimates

  CutAnswer(const PointAnswers& answers, const CutConfig& asked, const Cut& chosen)
      : point(answers), config(asked), cut(chosen), total{} {
    for (const CutCluster& c : cut.clusters)
      for (int i = 0; i < 3; ++i) total[i] += c.estimate[i];
  }

  /// Relative rounding of the total, if summed in doubles: 2^-53 for each addition.
  [[nodiscard]] long double sum_error() const {
    return static_cast<long double>(cut.clusters.size()) * 0x1p-53L;
  }
};

/// For so many lights: with all of them, so that nothing is estimated.
[[nodiscard]] inline CutConfig exact_cut(std::size_t lights) {
  return {0, static_cast<std::uint32_t>(lights), 0};
}

/// Clusters of a cut that is too small to converge.
inline constexpr std::uint32_t small_cut_size = 3;

/// The cuts that are judged at a point: as configured, exact, and too small to converge.
[[nodiscard]] inline std::array<CutConfig, 3> cuts_of(const CutConfig& config, std::size_t lights) {
  CutConfig small = config, exact = config;
  small.max_size = small_cut_size;
  exact.threshold = 0;
  exact.black_level = 0;
  exact.max_size = static_cast<std::uint32_t>(lights);
  return {config, exact, small};
}

/// How one of two cuts that are compared is chosen.
struct ChosenCut {
  CutConfig config;
  bool all_seen = false;
};
struct TwoCuts {
  ChosenCut one, other;
};

/// |radiance - exact| <= limit, per channel.
void check_against_truth(const CutAnswer& of, const glm::vec3& limit, const Recorder& record);

} // namespace lightcuts::oracle
