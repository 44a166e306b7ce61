// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include <lightcuts/core/cut/cut_selector.h>
#include <lightcuts/core/lobes/shading_block.h>
#include <lightcuts/core/lobes/shading_point.h>
#include <lightcuts/core/tree/light_tree.h>

namespace lightcuts::oracle {

/// What the library answers at grazing pairs; tests put something else in place.
class GrazingAnswers {
public:
  virtual ~GrazingAnswers() = default;
  [[nodiscard]] virtual glm::dvec3 transfer(const ShadingPoint& point, const Light& light,
                                            float min_distance) const;
  [[nodiscard]] virtual glm::vec3 bound(const LightTree& tree, std::uint32_t node,
                                        const ShadingPoint& point) const;
  [[nodiscard]] virtual glm::vec3 bound(const LightTree& tree, std::uint32_t node,
                                        const ShadingBlock& block) const;
  [[nodiscard]] virtual glm::vec3 lower_bound(const LightTree& tree, std::uint32_t node,
                                              const ShadingPoint& point) const;
  /// All lights are seen.
  [[nodiscard]] virtual Cut cut(CutSelector& select, const ShadingPoint& point) const;
};

/// What is compared with the truth, all channels at once.
enum class GrazingCheck : std::uint8_t {
  transfer,    ///< of a light: within the error that transfer.h states for this lobe and kind
  bound,       ///< of a cluster: at least its contribution
  block_bound, ///< of a cluster for a block of which the point is one: likewise
  lower_bound, ///< of a cluster: at most its contribution
  certificate  ///< of a cut: the radiance differs from the truth by at most the certified error
};
inline constexpr int grazing_check_count = 5;

struct GrazingCount {
  std::uint64_t pairs = 0; ///< of viewer and lights
  std::array<std::uint64_t, grazing_check_count> checks{};
  std::uint64_t exact = 0; ///< numbers that were decided in 700 bits
  std::uint64_t violations = 0;
  std::string first_violation;
  /// Largest error of transfer over the stated one, where least_transfer is not more than that.
  double worst_transfer = 0;

  [[nodiscard]] std::uint64_t all_checks() const;
  void merge(const GrazingCount& other);
};

/// Judges what the library says of one random viewer and lights that mirror it, at a grazing angle:
/// n.v = n.l = 2^-e for all e in turn up to the least float, or lights higher or lower by many
/// scales, turned aside by little, at all distances, with normals off the axes by next to nothing.
/// Every lobe of several widths, with all kinds of light, each time. The truth is written anew in
/// long double, with half vectors in 700 bits, and what lies within truth_error of a limit is
/// decided in 700 bits. The same numbers for the same seed and index.
[[nodiscard]] GrazingCount check_grazing_pair(const GrazingAnswers& of, std::uint64_t seed,
                                              std::uint64_t index);

} // namespace lightcuts::oracle
