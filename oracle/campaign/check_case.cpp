// SPDX-License-Identifier: MIT
#include <oracle/campaign/check_case.h>

#include <optional>

#include <oracle/properties/case_properties.h>
#include <oracle/properties/each_view.h>
#include <oracle/properties/point_properties.h>

namespace lightcuts::oracle {
namespace {

constexpr DrawConfig draw_config{.false_alarms = 1e-6, .cases = most_cases_with_draws};

/// What to look at: everything, or what says something about one property.
struct Scope {
  std::optional<Property> only = std::nullopt;

  [[nodiscard]] bool has(Property first, Property last) const {
    return !only || (*only >= first && *only <= last) || *only == Property::results_are_finite ||
           *only == Property::subject_answers;
  }
  [[nodiscard]] bool bounds() const {
    return has(Property::bound_dominates_contribution, Property::bound_is_finite);
  }
  [[nodiscard]] bool cuts() const {
    return has(Property::cut_partitions_lights, Property::visibility_only_darkens);
  }
  [[nodiscard]] bool agreement() const {
    return has(Property::threads_agree, Property::threads_agree);
  }
  [[nodiscard]] bool sampling() const {
    return has(Property::probabilities_sum_to_one, Property::stochastic_is_unbiased);
  }
  [[nodiscard]] bool draws() const {
    return has(Property::draws_follow_probabilities, Property::stochastic_is_unbiased);
  }
  [[nodiscard]] bool views() const { return bounds() || cuts() || agreement() || sampling(); }
  [[nodiscard]] bool invariance() const {
    return has(Property::intensity_scales_exactly, Property::black_light_is_immaterial);
  }
  [[nodiscard]] bool picture() const {
    return has(Property::occlusion_equals_brute_force, Property::pixels_equal_points);
  }
};

void check_cuts(const Judged& judged, const Case& on, const PointCase& at, Tally& tally) {
  const auto visible = [&at](std::uint32_t light) {
    return light < at.visible.size() && at.visible[light] != 0;
  };
  for (const CutConfig& config : cuts_of(on))
    check_cut(judged, config, judged.tree.select(at.point, config, visible), at, tally);
  check_nesting(judged, on.cut, at, tally);
  check_darkening(judged, at, tally);
}

void check_views(const Judged& judged, const Topology& topology, const LightSet& lights,
                 const Case& on, const Scope& scope, std::uint64_t place, Tally& tally) {
  for_each_view(on, topology, lights, place, [&](std::size_t, const PointCase& at) {
    if (scope.bounds()) check_clusters(judged, at, tally);
    if (scope.cuts() && judged.has(Part::cuts)) check_cuts(judged, on, at, tally);
    if (scope.sampling() && judged.has(Part::sampling)) check_probabilities(judged, at, tally);
    if (scope.agreement()) check_agreement(judged, on.cut, at, tally);
    if (on.draws && scope.draws() && judged.has(Part::sampling) && judged.has(Part::random_cuts))
      check_draws(judged, on.cut, draw_config, at, tally);
    return false;
  });
}

void check_all(const Subject& subject, const Case& on, const Scope& scope, std::uint64_t place,
               Tally& tally) {
  if (scope.picture() && !on.triangles.empty()) check_picture(subject, on, place, tally);
  if (has(subject.parts(), Part::refinement_order)) check_refinement_order(subject, place, tally);
  const LightSet lights = on.light_set();
  if (lights.empty()) return;
  const std::unique_ptr<SubjectTree> tree = subject.build(lights, on.seed);
  Judged judged{*tree, subject.parts()};
  const std::optional<Topology> topology = check_tree(tree->claim(), lights, place, tally);
  if (!topology) return;
  check_cost(*topology, lights, place, tally);
  if (scope.views()) check_views(judged, *topology, lights, on, scope, place, tally);
  if (scope.invariance()) check_invariance(subject, on, place, tally);
}

/// What the subject cannot answer counts, too.
void check_answers(const Subject& subject, const Case& on, const Scope& scope, std::uint64_t place,
                   Tally& tally) {
  std::string failure;
  try {
    check_all(subject, on, scope, place, tally);
  } catch (const SubjectFailure& e) {
    failure = e.what();
  }
  tally.record(Property::subject_answers, failure.empty(), place, no_ratio,
               [&] { return failure; });
}

} // namespace

std::array<CutConfig, 3> cuts_of(const Case& on) {
  CutConfig exact = on.cut, small = on.cut;
  exact.threshold = 0;
  exact.black_level = 0;
  exact.max_size = std::uint32_t(on.lights.size());
  small.max_size = 3;
  return {on.cut, exact, small};
}

void check_case(const Subject& subject, const Case& on, std::uint64_t place, Tally& tally) {
  check_answers(subject, on, {}, place, tally);
}

void check_case_for(Property property, const Subject& subject, const Case& on, Tally& tally) {
  check_answers(subject, on, {property}, 0, tally);
}

} // namespace lightcuts::oracle
