// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lightcuts::oracle {

/// What the oracle checks, in the order of reports.
enum class Property : std::uint8_t {
  // the tree
  tree_partitions_lights,
  tree_conserves_intensity,
  representative_belongs,
  tree_equals_naive,
  // bounds
  bound_dominates_contribution,
  bound_dominates_error,
  bounds_are_ordered,
  bound_shrinks_on_refinement,
  bound_is_finite,
  // cuts
  cut_partitions_lights,
  cut_obeys_threshold,
  certified_error_holds,
  zero_threshold_is_exact,
  total_does_not_drift,
  tighter_threshold_refines,
  visibility_only_darkens,
  refinement_order_is_strict,
  // all of them
  results_are_finite,
  threads_agree,
  // sampling
  probabilities_sum_to_one,
  contributing_lights_are_drawn,
  draws_state_their_probability,
  draws_follow_probabilities,
  draws_are_independent,
  stochastic_is_unbiased,
  // what must not matter
  intensity_scales_exactly,
  length_scales_exactly,
  rotation_is_immaterial,
  translation_is_immaterial,
  light_order_is_immaterial,
  split_light_is_immaterial,
  black_light_is_immaterial,
  // shading and visibility
  brdf_is_reciprocal,
  brdf_conserves_energy,
  occlusion_equals_brute_force,
  pixels_equal_points,
  // the subject itself
  subject_answers,
};
inline constexpr std::size_t property_count = std::size_t(Property::subject_answers) + 1;

/// What it means that a property does not hold.
enum class Severity : std::uint8_t {
  violation, ///< a wrong result
  waste      ///< a right one that costs more than it has to
};

struct PropertyInfo {
  const char* name;
  const char* statement; ///< one sentence
  const char* formula;   ///< what is computed; its left side over its right is the ratio
  Severity severity = Severity::violation;
};

[[nodiscard]] const PropertyInfo& info(Property property);
/// Of all, in their order: for the fields of records.
[[nodiscard]] std::array<const char*, property_count> names_of(Property any);
[[nodiscard]] std::optional<Property> property_named(std::string_view name);

/// Counts of one property.
struct PropertyCount {
  std::uint64_t cases = 0;
  std::uint64_t violations = 0;
  /// Largest left side / right side of the formula; 1 is the limit. Negative: a yes-or-no property.
  double worst_ratio = -1;
  /// Of the violation found at the lowest place: where, and the values on both sides.
  std::string first_violation;
  std::uint64_t first_place = std::numeric_limits<std::uint64_t>::max();
};

/// The counts of all properties. Merging is commutative, so the order of threads does not show.
class Tally {
public:
  /// Counts one case. place orders violations (the index of a shading point, say); ratio as in
  /// PropertyCount; describe() is called for a violation that becomes the first one.
  template <class Describe>
  void record(Property property, bool holds, std::uint64_t place, double ratio,
              Describe&& describe) {
    PropertyCount& count = counts_[std::size_t(property)];
    ++count.cases;
    if (!(ratio <= count.worst_ratio)) count.worst_ratio = ratio;
    if (holds) return;
    ++count.violations;
    if (place >= count.first_place) return;
    count.first_place = place;
    count.first_violation = describe();
  }

  /// Counts cases that hold, of which the worst has this ratio.
  void hold(Property property, std::uint64_t cases, double worst_ratio) {
    PropertyCount& count = counts_[std::size_t(property)];
    count.cases += cases;
    if (!(worst_ratio <= count.worst_ratio)) count.worst_ratio = worst_ratio;
  }

  /// Sets a property's counts to those that were saved.
  void restore(Property property, const PropertyCount& count) {
    counts_[std::size_t(property)] = count;
  }

  void merge(const Tally& other);

  [[nodiscard]] const PropertyCount& operator[](Property p) const {
    return counts_[std::size_t(p)];
  }
  /// Sums over the properties of that severity.
  [[nodiscard]] std::uint64_t violations() const { return sum(Severity::violation); }
  [[nodiscard]] std::uint64_t wasteful() const { return sum(Severity::waste); }

private:
  [[nodiscard]] std::uint64_t sum(Severity severity) const;

  std::array<PropertyCount, property_count> counts_;
};

/// The properties that do not hold, violations before waste.
[[nodiscard]] std::vector<Property> broken(const Tally& tally);

/// For record(): properties that hold or not, without a ratio.
inline constexpr double no_ratio = -1;

/// left / right for record(): 0/0 is 0, x/0 and NaN are the largest double, which JSON can say.
[[nodiscard]] double ratio_of(long double left, long double right);

} // namespace lightcuts::oracle
